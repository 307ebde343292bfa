// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "core/sim/process.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// A part of a frame that the flow has just gone through.
struct FlowPart {
  const StepInput& frame;
  double from, to;  ///< s of film
  FlowSolver& solver;
  const FlowConfig& config;
  ProcessContext& context;
};

/// What acts on the flow and is acted on by it, hand in hand (the air). Who couples puts one into the
/// Exchange in begin() and loadState(); the flow process calls it after every part of a frame, the last step
/// of which was sampled.
struct FlowCoupling {
  double longest = 1.0 / 24.0;                    ///< s of film from one call to the next, at most
  std::function<Status(const FlowPart&)> before;  ///< a part begins; may be empty
  std::function<Status(const FlowPart&)> after;
  std::vector<FlowParticle> rejoining;  ///< come into the flow when its next part begins
  std::vector<FlowParticle> refused;    ///< those of them that lay in solids: they are their owner's again

  int partsOf(double seconds) const {
    return seconds > longest ? static_cast<int>(std::ceil(seconds / longest - 1e-9)) : 1;
  }
};

}  // namespace spin
