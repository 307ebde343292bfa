// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_solver.h"

namespace spin {

/// The solver of core/sph on the card. Fails where there is none (see cudaDevice()) or a value is out of
/// range.
Result<std::unique_ptr<FlowSolver>> makeFlowSolverCuda(const FlowConfig& config);

}  // namespace spin
