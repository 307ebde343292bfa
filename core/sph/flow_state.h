// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_setup.h"

namespace spin {

/// All that a solver needs to go on as if it had never stopped. What a step computes anew is not in it.
struct FlowSolverState {
  FlowHostState particles;  ///< in the solver's order, the dead ones that it has not dropped yet too
  std::uint32_t nextId = 0;
  double lastStep = 0.0;  ///< s
  FlowLosses losses;      ///< of those dropped
  std::vector<RigidState> bodies;
};

/// Whether a state, which may come from a file, fits: equal lengths, positions within the domain, materials
/// that are there, finite values, numbers below
/// nextId, a state for every body.
Status checkState(const FlowConfig& config, const FlowSolverState& state);

}  // namespace spin
