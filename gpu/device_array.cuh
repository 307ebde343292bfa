// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "gpu/cuda_error.cuh"

namespace spin {

/// Owning array in device memory. Growing discards the contents; what is new is zero, as in a std::vector.
template <class T>
class DeviceArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  DeviceArray() = default;
  DeviceArray(DeviceArray&& other) noexcept { swap(other); }
  DeviceArray& operator=(DeviceArray&& other) noexcept {
    swap(other);
    return *this;
  }
  ~DeviceArray() { cudaFree(m_data); }

  void resize(std::size_t size) {
    if (size > m_capacity) {
      cudaFree(m_data);
      m_data = nullptr;
      m_size = m_capacity = 0;
      cudaRequire(cudaMalloc(&m_data, size * sizeof(T)), "memory");
      m_capacity = size;
      cudaRequire(cudaMemset(m_data, 0, size * sizeof(T)), "clear");
    }
    m_size = size;
  }
  T* data() { return m_data; }
  const T* data() const { return m_data; }
  std::size_t size() const { return m_size; }

 private:
  void swap(DeviceArray& other) noexcept {
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    std::swap(m_capacity, other.m_capacity);
  }
  T* m_data = nullptr;
  std::size_t m_size = 0;
  std::size_t m_capacity = 0;
};

}  // namespace spin
