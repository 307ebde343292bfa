// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cub/cub.cuh>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "core/base/check.h"
#include "core/base/host_device.h"
#include "gpu/cuda_stage_timer.cuh"
#include "gpu/device_array.cuh"
#include "gpu/for_each_kernel.cuh"
#include "gpu/pinned_memory.cuh"

/// The backend concept of core/base/parallel.h on a CUDA card. Kernels are the same trivially copyable
/// structs with a SPIN_HD operator()(i). No CUDA type leaves gpu/.
namespace spin {

/// Block b combines [b * kReduceChunk, ...) in a fixed tree.
template <int kBlock, class T, class Map, class Combine>
__global__ void reduceKernel(std::size_t n, std::size_t chunk, T initial, Map map, Combine combine,
                             T* partial) {
  __shared__ T values[kBlock];
  const std::size_t begin = static_cast<std::size_t>(blockIdx.x) * chunk;
  const std::size_t end = begin + chunk < n ? begin + chunk : n;
  T value = initial;
  for (std::size_t i = begin + threadIdx.x; i < end; i += kBlock) value = combine(value, map(i));
  values[threadIdx.x] = value;
  for (int half = kBlock / 2; half > 0; half /= 2) {
    __syncthreads();
    if (threadIdx.x < half) values[threadIdx.x] = combine(values[threadIdx.x], values[threadIdx.x + half]);
  }
  if (threadIdx.x == 0) partial[blockIdx.x] = values[0];
}

struct IotaKernel {
  std::uint32_t* out;
  SPIN_HD void operator()(std::size_t i) const { out[i] = static_cast<std::uint32_t>(i); }
};

struct Widen {
  const std::uint32_t* in;
  SPIN_HD std::uint64_t operator()(std::size_t i) const { return in[i]; }
};

struct AddWide {
  SPIN_HD std::uint64_t operator()(std::uint64_t a, std::uint64_t b) const { return a + b; }
};

class CudaBackend {
 public:
  template <class T>
  using Array = DeviceArray<T>;

  static constexpr const char* kDevice = "cuda";
  static constexpr unsigned kBlock = 128;
  static constexpr std::size_t kReduceChunk = 8192;

  StageTimings& timings() { return m_timer.timings(); }
  std::size_t scratchBytes() const {
    return m_scratch.size() + m_partial.size() +
           (m_iota.size() + m_sortedKeys.size()) * sizeof(std::uint32_t);
  }

  template <class T>
  void upload(const std::vector<T>& from, Array<T>& to) {
    to.resize(from.size());
    cudaRequire(cudaMemcpy(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyHostToDevice),
                "upload");
  }
  template <class T>
  void download(const Array<T>& from, std::vector<T>& to) {
    to.resize(from.size());
    cudaRequire(cudaMemcpy(to.data(), from.data(), from.size() * sizeof(T), cudaMemcpyDeviceToHost),
                "download");
  }

  template <class Kernel>
  void forEach(const char* name, std::size_t n, const Kernel& kernel) {
    if (n == 0) return;
    const std::size_t blocks = (n + kBlock - 1) / kBlock;
    SPIN_CHECK_LE(blocks, static_cast<std::size_t>(INT32_MAX));
    m_timer.measure(name, [&] { forEachKernel<<<static_cast<unsigned>(blocks), kBlock>>>(kernel, n); });
    cudaRequire(cudaGetLastError(), name);
  }

  /// Times a kernel that the caller starts.
  template <class Start>
  void launch(const char* name, const Start& start) {
    m_timer.measure(name, start);
    cudaRequire(cudaGetLastError(), name);
  }

  /// Chunks of a fixed size, each combined in a fixed tree, then over the chunks in order: runs repeat.
  template <class T, class Map, class Combine>
  T reduce(const char* name, std::size_t n, T initial, const Map& map, const Combine& combine) {
    const std::size_t chunks = (n + kReduceChunk - 1) / kReduceChunk;
    if (chunks == 0) return initial;
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t bytes = chunks * sizeof(T);
    m_partial.resize(bytes);
    m_timer.measure(name, [&] {
      reduceKernel<256><<<static_cast<unsigned>(chunks), 256>>>(n, kReduceChunk, initial, map, combine,
                                                                reinterpret_cast<T*>(m_partial.data()));
    });
    cudaRequire(cudaGetLastError(), name);
    unsigned char* values = m_received.atLeast(bytes);
    cudaRequire(cudaMemcpy(values, m_partial.data(), bytes, cudaMemcpyDeviceToHost), name);
    T total = initial;
    for (std::size_t c = 0; c < chunks; ++c) {
      T value = initial;
      std::memcpy(&value, values + c * sizeof(T), sizeof(T));
      total = combine(total, value);
    }
    return total;
  }

  std::uint64_t exclusiveScan(const char* name, const std::uint32_t* in, std::uint32_t* out, std::size_t n) {
    if (n == 0) return 0;
    const std::uint64_t total = reduce(name, n, std::uint64_t{0}, Widen{in}, AddWide{});
    withScratch(name, [&](void* scratch, std::size_t& bytes) {
      return cub::DeviceScan::ExclusiveSum(scratch, bytes, in, out, n);
    });
    return total;
  }

  void sortByKey(const char* name, const Array<std::uint32_t>& keys, std::uint32_t keyCount,
                 Array<std::uint32_t>& order) {
    const std::size_t n = keys.size();
    order.resize(n);
    if (n == 0) return;
    if (m_iota.size() != n) {
      m_iota.resize(n);
      m_sortedKeys.resize(n);
      forEach(name, n, IotaKernel{m_iota.data()});
    }
    const int bits = std::max(1, static_cast<int>(std::bit_width(keyCount - 1)));
    withScratch(name, [&](void* scratch, std::size_t& bytes) {
      return cub::DeviceRadixSort::SortPairs(scratch, bytes, keys.data(), m_sortedKeys.data(), m_iota.data(),
                                             order.data(), n, 0, bits);
    });
  }

 private:
  /// CUB asks first how much temporary memory it wants, then works.
  template <class Call>
  void withScratch(const char* name, const Call& call) {
    std::size_t bytes = 0;
    cudaRequire(call(nullptr, bytes), name);
    m_scratch.resize(std::max<std::size_t>(bytes, 1));
    m_timer.measure(name, [&] { cudaRequire(call(m_scratch.data(), bytes), name); });
  }

  CudaStageTimer m_timer;
  Array<unsigned char> m_scratch, m_partial;
  PinnedMemory m_received;
  Array<std::uint32_t> m_iota, m_sortedKeys;
};

}  // namespace spin
