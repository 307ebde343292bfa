// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <utility>

#include "gpu/cuda_error.cuh"

namespace spin {

/// Host memory that the card reaches by itself: small answers come back without a detour through the driver's
/// own buffer.
class PinnedMemory {
 public:
  PinnedMemory() = default;
  PinnedMemory(PinnedMemory&& other) noexcept
      : m_data(std::exchange(other.m_data, nullptr)), m_size(std::exchange(other.m_size, 0)) {}
  PinnedMemory& operator=(PinnedMemory&&) = delete;
  ~PinnedMemory() { cudaFreeHost(m_data); }

  /// At least so many bytes; growing discards the contents.
  unsigned char* atLeast(std::size_t bytes) {
    if (bytes > m_size) {
      cudaFreeHost(m_data);
      m_data = nullptr;
      m_size = 0;
      cudaRequire(cudaMallocHost(&m_data, bytes), "host memory");
      m_size = bytes;
    }
    return m_data;
  }

 private:
  unsigned char* m_data = nullptr;
  std::size_t m_size = 0;
};

}  // namespace spin
