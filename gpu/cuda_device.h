// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/base/result.h"

namespace spin {

/// The card that CUDA work runs on.
struct CudaDevice {
  std::string name;     ///< "NVIDIA H100"
  std::string backend;  ///< "cuda-sm90": part of a frame's provenance
  double memoryBytes = 0;
};

/// Looks for a driver, a card, and kernels in this program that the card can run. Never fails hard: a machine
/// without a driver gives an Error that says what is missing. Asked once per process.
const Result<CudaDevice>& cudaDevice();
inline bool cudaAvailable() {
  return cudaDevice().ok();
}

enum class Device { Cpu, Cuda };

/// Reads auto | cpu | cuda. `auto` takes the card where there is one; `cuda` without a card falls back to the
/// processor and logs a warning that says why. Another word is a Usage error.
Result<Device> chooseDevice(const std::string& request);

}  // namespace spin
