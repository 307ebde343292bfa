// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/sph/flow_solver.h"

namespace spin {

/// Whether points lie in a solid of a solver or in a body, by more than a quarter of a spacing.
class SolidTest {
 public:
  /// `walls` has the planes, surfaces and the ground's shape of `config`, which must outlive this; `bodies`
  /// are the states of its bodies now.
  SolidTest(const FlowConfig& config, const WallView& walls, const std::vector<RigidState>& bodies);
  bool operator()(const Vec3d& position) const;

 private:
  bool inBody(const Vec3d& position) const;

  const FlowConfig& m_config;
  const std::vector<RigidState>& m_bodies;
  Vec3d m_origin;
  WallView m_walls;
  std::vector<float> m_heights;
  std::vector<WallMesh> m_meshes;
  float m_spacing = 0.0f;
};

}  // namespace spin
