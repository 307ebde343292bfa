// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/flow_solver_impl.h"
#include "gpu/cuda_backend.cuh"
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"

namespace spin {

template class FlowSolverOn<CudaBackend>;

Result<std::unique_ptr<FlowSolver>> makeFlowSolverCuda(const FlowConfig& config) {
  if (!cudaAvailable()) return cudaDevice().error();
  if (const Status ok = checkFlowConfig(config); !ok) return ok.error();
  FlowConfig ready = config;
  if (const Status ok = makeMeshFields(ready, 0); !ok) return ok.error();
  return Result<std::unique_ptr<FlowSolver>>(
      std::make_unique<FlowSolverOn<CudaBackend>>(ready, CudaBackend{}, FlowPasses<CudaBackend>{}));
}

}  // namespace spin
