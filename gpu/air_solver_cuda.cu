// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "gpu/air_solver_cuda.h"

#include "core/air/air_config.h"
#include "core/air/air_solver_impl.h"
#include "gpu/air_passes.cuh"
#include "gpu/cuda_device.h"

namespace spin {

Result<std::unique_ptr<AirSolver>> makeAirSolverCuda(const AirConfig& config) {
  if (!cudaAvailable()) return cudaDevice().error();
  if (const Status ok = checkAirConfig(config); !ok) return ok.error();
  auto solver = std::make_unique<AirSolverOn<CudaBackend>>(config, CudaBackend{}, AirPasses<CudaBackend>{});
  if (const Status ok = solver->start(); !ok) return ok.error();
  return std::unique_ptr<AirSolver>(std::move(solver));
}

}  // namespace spin
