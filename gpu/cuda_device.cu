// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cuda_runtime.h>

#include "core/base/log.h"
#include "gpu/cuda_device.h"

namespace spin {
namespace {

__global__ void probeKernel() {}

Error missing(const std::string& why, const std::string& advice) {
  return {ErrorKind::Failed, "CUDA cannot be used", {}, why, advice};
}

Result<CudaDevice> probe() {
  int count = 0;
  const cudaError_t found = cudaGetDeviceCount(&count);
  if (found != cudaSuccess || count == 0)
    return missing(found != cudaSuccess ? cudaGetErrorString(found) : "there is no card",
                   "Install the NVIDIA driver, or use --device cpu");
  cudaDeviceProp properties{};
  if (const cudaError_t error = cudaGetDeviceProperties(&properties, 0); error != cudaSuccess)
    return missing(cudaGetErrorString(error), "Use --device cpu");
  cudaFuncAttributes attributes{};
  if (cudaFuncGetAttributes(&attributes, probeKernel) != cudaSuccess) {
    cudaGetLastError();
    return missing(std::string(properties.name) + " is of an architecture this build has no code for",
                   "Build with SPIN_CUDA_ARCHITECTURES for this card");
  }
  CudaDevice device;
  device.name = properties.name;
  device.backend = "cuda-sm" + std::to_string(properties.major) + std::to_string(properties.minor);
  device.memoryBytes = static_cast<double>(properties.totalGlobalMem);
  return device;
}

}  // namespace

const Result<CudaDevice>& cudaDevice() {
  static const Result<CudaDevice> device = probe();
  return device;
}

Result<Device> chooseDevice(const std::string& request) {
  if (request == "cpu") return Device::Cpu;
  if (request != "auto" && request != "cuda")
    return Error{ErrorKind::Usage, "Unknown device", request, "known are auto, cpu and cuda", {}};
  if (cudaAvailable()) return Device::Cuda;
  if (request == "cuda") logWarning(cudaDevice().error().text() + "; the processor is used instead");
  return Device::Cpu;
}

}  // namespace spin
