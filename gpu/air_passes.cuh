// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_passes.h"
#include "core/sim/air_part.h"
#include "gpu/cuda_backend.cuh"

namespace spin {

/// A block works on a brick, a thread on a cell; results of a brick are combined in a fixed tree.
template <class Pass>
__global__ void airPassKernel(Pass pass, AirStrides strides, const AirBrick* bricks, double* results) {
  constexpr int kCells = static_cast<int>(kBrickCells);
  const AirBrick brick = bricks[blockIdx.x];
  const int t = static_cast<int>(threadIdx.x), x = t % kBrickX, y = t / kBrickX % kBrickY,
            z = t / (kBrickX * kBrickY);
  const CellAt at{brick.first + z * strides.z + y * strides.y + x, brick.x + x, brick.y + y, brick.z + z};
  if constexpr (Pass::kResult == AirResult::None) {
    pass(at);
  } else {
    __shared__ double values[kCells];
    values[t] = static_cast<double>(pass(at));
    for (int half = kCells / 2; half > 0; half /= 2) {
      __syncthreads();
      if (t >= half) continue;
      const double other = values[t + half];
      // What is not a number stays.
      const bool takes = other > values[t] || other != other;
      values[t] = Pass::kResult == AirResult::Sum ? values[t] + other : (takes ? other : values[t]);
    }
    if (t == 0) results[blockIdx.x] = values[0];
  }
}

template <>
class AirPasses<CudaBackend> {
 public:
  using Bricks = CudaBackend::Array<AirBrick>;

  template <class Pass>
  void run(CudaBackend& backend, const char* name, AirStrides strides, const Bricks& bricks, const Pass& pass,
           double* results = nullptr) {
    if (bricks.size() == 0) return;
    backend.launch(name, [&] {
      airPassKernel<<<static_cast<unsigned>(bricks.size()), static_cast<unsigned>(kBrickCells)>>>(
          pass, strides, bricks.data(), results);
    });
  }
  template <class Pass>
  const std::vector<double>& results(CudaBackend& backend, const char* name, AirStrides strides,
                                     const Bricks& bricks, const Pass& pass) {
    m_device.resize(bricks.size());
    run(backend, name, strides, bricks, pass, m_device.data());
    backend.download(m_device, m_results);
    return m_results;
  }

 private:
  CudaBackend::Array<double> m_device;
  std::vector<double> m_results;
};

}  // namespace spin
