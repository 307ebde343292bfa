// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "editor/render/gl_objects.h"

namespace spin {

/// Textures in which the surface of a flow is made. They may have fewer pixels than the picture (near
/// particles need no more), and reach `margin` pixels beyond its rims, so that what stands there is smoothed
/// like the rest.
struct FlowTargets {
  static constexpr int kMargin = 24;

  int width = 0, height = 0;  ///< with the margins
  double scale = 1.0;         ///< their pixels per pixel of the picture
  GlTexture raw;              ///< RG: distance before the eye (m, 0 = nothing), value of the nearest particle
  GlTexture smooth[2];        ///< R: distance, in turns
  GlTexture normal;           ///< normal (world axes), openness; half the bits suffice
  GlTexture thickness;        ///< half as wide and high: thickness (m), of it water, foam, loose snow
  GlTexture dust;             ///< half as wide and high: optical depth, and that times the distance in 100 m
  GlFramebuffer rawFramebuffer, smoothFramebuffer[2], normalFramebuffer, thicknessFramebuffer,
      dustFramebuffer;
  GlRenderbuffer depth;

  int halfWidth() const { return (width + 1) / 2; }
  int halfHeight() const { return (height + 1) / 2; }
  /// Makes what does not fit; the error says what the driver refuses.
  Status prepare(int pictureWidth, int pictureHeight, double newScale);
};

}  // namespace spin
