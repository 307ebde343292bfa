// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/sph/flow_solver.h"

namespace spin {

/// Whether points lie in a solid of a solver, by more than a quarter of a spacing.
class SolidTest {
 public:
  /// Keeps nothing of `config`; `walls` has its planes, surfaces and the ground's shape.
  SolidTest(const FlowConfig& config, const WallView& walls);
  bool operator()(const Vec3d& position) const;

 private:
  Vec3d m_origin;
  WallView m_walls;
  std::vector<float> m_heights;
  std::vector<WallMesh> m_meshes;
  float m_spacing = 0.0f;
};

}  // namespace spin
