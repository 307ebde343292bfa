// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace spin {

/// Thread i calls kernel(i). The kernel struct travels by value.
template <class Kernel>
__global__ void forEachKernel(Kernel kernel, std::size_t n) {
  const std::size_t i = static_cast<std::size_t>(blockIdx.x) * blockDim.x + threadIdx.x;
  if (i < n) kernel(i);
}

}  // namespace spin
