// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_config.h"
#include "core/air/air_solver_impl.h"

namespace spin {

Result<std::unique_ptr<AirSolver>> makeAirSolverCpu(const AirConfig& config, const CpuBackend& like,
                                                    Isa isa) {
  if (const Status ok = checkAirConfig(config); !ok) return ok.error();
  auto solver =
      std::make_unique<AirSolverOn<CpuBackend>>(config, like.sharingThreads(), AirPasses<CpuBackend>(isa));
  if (const Status ok = solver->start(); !ok) return ok.error();
  return std::unique_ptr<AirSolver>(std::move(solver));
}

}  // namespace spin
