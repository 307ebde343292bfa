// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "core/rigid/rigid_shape.h"

namespace spin {

/// A body and how it starts.
struct RigidBodyConfig {
  std::shared_ptr<const RigidShape> shape;  ///< not null
  double density = 500.0;                   ///< kg/m3; > 0
  double friction = 0.5;                    ///< Coulomb's coefficient; a pair takes the geometric mean; >= 0
  double restitution = 0.2;                 ///< 0..1; a pair takes the larger
  bool kinematic = false;                   ///< moves as its state's velocities say, whatever pushes it
  std::uint8_t surface = 0;                 ///< of the flow's surfaces (FlowWallsConfig::surfaces)
  RigidState start;

  double mass() const { return density * shape->mass.volume; }
};

/// Angular velocity for an angular momentum about the centre of mass, both in world axes.
inline Vec3d spinOf(const RigidBodyConfig& body, const Quaternion& orientation, Vec3d momentum) {
  return orientation.rotate(body.shape->inverseInertia * orientation.conjugate().rotate(momentum)) /
         body.density;
}
inline Vec3d momentumOf(const RigidBodyConfig& body, const Quaternion& orientation, Vec3d spin) {
  return orientation.rotate(body.shape->mass.inertia * orientation.conjugate().rotate(spin)) * body.density;
}

}  // namespace spin
