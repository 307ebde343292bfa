// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "editor/render/gl_objects.h"

namespace spin {

/// A copy of the picture's depth that shaders can read: one number a pixel, also of multisampled pictures.
class SceneDepth {
 public:
  /// Copies within the scissor rectangle. `framebuffer` has a 32-bit float depth of that size.
  Status copy(GLuint framebuffer, int width, int height);
  GLuint texture() const { return m_depth.id(); }

 private:
  GlTexture m_depth;
  GlFramebuffer m_framebuffer;
  int m_width = 0, m_height = 0;
};

}  // namespace spin
