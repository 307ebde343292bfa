// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "editor/render/gl_objects.h"

namespace spin {

/// Pictures of half the size in which a cloud is marched and smoothed.
struct AirTargets {
  struct Layer {
    GlTexture look;   ///< colour, share of what is behind that is still seen
    GlTexture place;  ///< distances before the eye, m: the scene's, the cloud's mean, its deviation
    GlFramebuffer framebuffer;
  };
  int width = 0, height = 0;
  Layer raw, smooth;

  /// Makes what does not fit a picture of this size; the error says what the driver refuses.
  Status prepare(int pictureWidth, int pictureHeight);
  /// Nothing before anything.
  void clear() const;
};

}  // namespace spin
