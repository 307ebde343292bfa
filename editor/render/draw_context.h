// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "editor/render/snow_look.h"
#include "editor/render/view_uniforms.h"

namespace spin {

/// The four side planes and the near plane of a view.
class Frustum {
 public:
  explicit Frustum(const Matrix4& viewProjection);
  /// False only where the box lies wholly outside one plane.
  bool mayShow(const Box3d& box) const;

 private:
  std::array<std::array<double, 4>, 5> m_planes;
};

/// Pixels x0, y0, x1, y1 (end excluded, from the lower left) that a box covers in a picture, and `margin`
/// more on all sides; all of them where the box reaches behind the eye, none where it is out of sight.
std::array<int, 4> pixelsOf(const Box3d& box, const Matrix4& viewProjection, int width, int height,
                            double margin);

/// What every pass needs to know of one picture.
struct DrawContext {
  const SceneSnapshot& scene;
  const RenderCamera& camera;
  double filmTime;
  const RenderOptions& options;
  const FrameBlock& block;
  Frustum frustum;
  double pixelsPerUnit;  ///< pixels that a length of 1 m covers at 1 m distance
  SnowLook look = SnowLook::Physical;
};

/// Distance from a point to a box, 0 inside.
double distanceTo(const Box3d& box, Vec3d point);

}  // namespace spin
