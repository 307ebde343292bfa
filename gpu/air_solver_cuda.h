// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_solver.h"

namespace spin {

/// The air on the CUDA card; fails where there is none, or as makeAirSolverCpu() does.
Result<std::unique_ptr<AirSolver>> makeAirSolverCuda(const AirConfig& config);

}  // namespace spin
