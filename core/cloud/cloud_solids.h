// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/air/air_solver.h"
#include "core/cloud/cloud_ground.h"
#include "core/fields/signed_distance.h"
#include "core/flow/flow_scene.h"

namespace spin {

/// What is solid for the air and for what flies in it: the terrain (level ground at height 0 where there is
/// none) and what rigid_body nodes make solid for the flow.
class CloudSolids {
 public:
  /// Fails where a model has no field.
  static Result<CloudSolids> make(const SceneSnapshot& scene, const FlowScene& flow, double cell,
                                  const CancelToken& cancel);

  /// Bodies are where they are now.
  void place(const std::vector<RigidState>& bodies) { *m_bodies = bodies; }
  bool move() const { return !m_shapes.empty(); }

  /// m, below 0 inside; large where nothing is near.
  double distance(Vec3d p) const;
  /// Of the ground alone.
  double groundDistance(Vec3d p) const { return m_ground.distance(p); }
  const CloudGround& ground() const { return m_ground; }
  /// Unit, out of what is nearest.
  Vec3d normal(Vec3d p) const;

  /// For the solver, bodies last; they follow place(), their boxes do not.
  std::vector<AirSolid> airSolids() const;

 private:
  double bodyDistance(std::size_t body, Vec3d p) const;

  CloudGround m_ground;
  std::vector<std::shared_ptr<const SignedDistance>> m_meshes;
  std::vector<std::shared_ptr<const RigidShape>> m_shapes;
  std::shared_ptr<std::vector<RigidState>> m_bodies = std::make_shared<std::vector<RigidState>>();
};

}  // namespace spin
