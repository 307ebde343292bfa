// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/sph_slice_impl.h"
#include "gpu/cuda_backend.cuh"
#include "gpu/cuda_device.h"
#include "gpu/sph_slice_cuda.h"

namespace spin {

template class SphSlice<CudaBackend>;

Result<std::unique_ptr<SphSliceSolver>> makeSphSliceCuda(const SphSliceConfig& config) {
  if (!cudaAvailable()) return cudaDevice().error();
  if (const Status ok = checkSliceConfig(config); !ok) return ok.error();
  return Result<std::unique_ptr<SphSliceSolver>>(
      std::make_unique<SphSlice<CudaBackend>>(config, CudaBackend{}, PairStages<CudaBackend>{}));
}

}  // namespace spin
