// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "core/fields/height_distance.h"
#include "core/fields/raster.h"
#include "core/fields/signed_distance.h"

namespace spin {

/// A place on something that does not move.
struct StaticContact {
  double distance = 0.0;  ///< m, below 0 inside
  Vec3d normal{0, 0, 1};  ///< out of it
};

/// What bodies rest on and collide with that has no mass: half-spaces, terrain, meshes. World metres.
class RigidStatics {
 public:
  struct Plane {
    Vec3d point{};
    Vec3d normal{0, 0, 1};  ///< out of the solid
  };
  void addPlane(Plane plane);
  /// Heights at cell centres as TerrainSurface has them; NaN = no ground.
  void setGround(Raster<float> ground);
  void addMesh(std::shared_ptr<const SignedDistance> field);

  /// Calls visit(part, contact) for each solid that is nearer to p than `reach`; `part` numbers the solids.
  void near(Vec3d p, double reach, const std::function<void(int part, const StaticContact&)>& visit) const;
  /// Whether anything can be nearer than that to the ball: quick, and never wrongly false.
  bool mayTouch(Vec3d centre, double radius) const;

 private:
  double highest(Vec3d centre, double radius) const;

  std::vector<Plane> m_planes;
  Raster<float> m_ground;
  std::vector<std::shared_ptr<const SignedDistance>> m_meshes;
};

}  // namespace spin
