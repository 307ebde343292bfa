// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/nodes/flow_nodes.h"
#include "core/sim/snapshot.h"

namespace spin {

/// A place where flow begins.
struct FlowBeginning {
  Vec3d top{};         ///< m, local
  double speed = 0.0;  ///< m/s
  std::string node;
};

/// The box that flow stays in.
struct FlowDomain {
  Box3d box;             ///< m, local
  double fastest = 0.0;  ///< m/s, to be expected in it
  std::string problem;   ///< why there is none
  std::string node;      ///< that the problem is about
};

/// The box that the settings give, or one round the starts and the ground that flow can reach from them. With
/// `slides` the flow loses energy along its way, at half the least friction of the ground at most.
FlowDomain findDomain(const SceneSnapshot& scene, const FlowSettingsNode& settings,
                      const std::vector<FlowBeginning>& starts, bool slides);
/// Support radius that the settings ask for, m.
double supportOf(const FlowSettingsNode& settings);
/// The box of the settings, where they give one.
bool givesDomain(const FlowSettingsNode& settings);

}  // namespace spin
