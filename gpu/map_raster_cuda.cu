// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "gpu/map_raster_cuda.h"

#include "core/snow/map_raster_impl.h"
#include "gpu/cuda_backend.cuh"
#include "gpu/cuda_device.h"

namespace spin {

std::unique_ptr<MapRaster> makeMapRasterCuda(const Occluders& occluders) {
  if (!cudaAvailable()) return nullptr;
  return std::make_unique<MapRasterOn<CudaBackend>>(occluders, CudaBackend{});
}

}  // namespace spin
