// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "gpu/cuda_backend.cuh"
#include "gpu/cuda_device.h"
#include "tests/support/backend_contract.h"

namespace spin::contract {

struct CudaTraits {
  using Backend = CudaBackend;
  static Backend make() { return {}; }
  static bool available(std::string& why) {
    if (!cudaAvailable()) why = cudaDevice().error().text();
    return cudaAvailable();
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, BackendContract, CudaTraits);

}  // namespace spin::contract
