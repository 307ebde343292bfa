// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/bench/flow_bench_scene.h"

namespace spin {

/// The largest FlowConfig::courant up to 1, to 3 %, with which the state equation carries the particles
/// through `seconds`: no state stops being finite, kinetic and potential energy stay within 1 % of what steps
/// of a tenth of a spacing come to, and the mean compression stays below 2 %. Stability does not depend on
/// the number of particles: a small scene tells it for a large one.
Result<double> longestCourant(FlowConfig config, const std::vector<FlowParticle>& particles, double seconds,
                              const BenchOptions& options);

}  // namespace spin
