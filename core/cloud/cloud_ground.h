// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/fields/raster.h"
#include "core/math/vec.h"
#include "core/sim/snapshot.h"

namespace spin {

/// The ground under the air, which reaches beyond the terrain: there its rim goes on level, and holes are
/// filled from what lies round them. Level ground at height 0 where there is no terrain.
class CloudGround {
 public:
  CloudGround() = default;
  explicit CloudGround(const SceneSnapshot& scene);

  double height(double x, double y) const;
  /// Along the normal of the facet below: exact on planes, too far beside an edge by less than its height
  /// (so it does not tell how far the next cliff is).
  double distance(Vec3d p) const;
  /// Whether some of it is in the box, or nearly so.
  bool mayTouch(Vec3d low, Vec3d high) const;

 private:
  /// Within the raster.
  Vec2d held(double x, double y) const;

  std::shared_ptr<const Raster<float>> m_heights;
  double m_highest = 0.0;  ///< of them
};

}  // namespace spin
