// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

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

/// What every pass needs to know of one picture.
struct DrawContext {
  const SceneSnapshot& scene;
  const RenderCamera& camera;
  double filmTime;
  const RenderOptions& options;
  const FrameBlock& block;
  Frustum frustum;
  double pixelsPerUnit;  ///< pixels that a length of 1 m covers at 1 m distance
};

/// Distance from a point to a box, 0 inside.
double distanceTo(const Box3d& box, Vec3d point);

}  // namespace spin
