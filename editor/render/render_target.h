// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "editor/render/gl_objects.h"

namespace spin {

/// Colour and depth to draw into, of one size, format and sample count.
class RenderTarget {
 public:
  /// Makes or remakes the target; does nothing where it already fits. Samples are clamped to what the driver
  /// has.
  Status prepare(int width, int height, GLenum colourFormat, int samples);
  GLuint framebuffer() const { return m_framebuffer.id(); }
  int width() const { return m_width; }
  int height() const { return m_height; }

 private:
  GlFramebuffer m_framebuffer;
  GlRenderbuffer m_colour, m_depth;
  int m_width = 0, m_height = 0, m_samples = -1;
  GLenum m_format = 0;
};

}  // namespace spin
