// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/air/air_lanes.h"

namespace spin {

struct ClearKernel {
  float* to;
  SPIN_HD void operator()(std::size_t i) const { to[i] = 0.0f; }
};

struct ListedValue {
  const float* values;
  const std::uint32_t* index;
  SPIN_HD double operator()(std::size_t i) const { return static_cast<double>(values[index[i]]); }
};
struct AddDouble {
  SPIN_HD double operator()(double a, double b) const { return a + b; }
};
struct ListedSubtract {
  float* values;
  const std::uint32_t* index;
  float amount;
  SPIN_HD void operator()(std::size_t i) const { values[index[i]] -= amount; }
};

/// Numbers of a lattice's cells with zeros before and behind, so that passes may read past the lattice's
/// sides; data() is the first cell.
template <class Backend>
class PaddedArray {
 public:
  void reset(Backend& backend, std::size_t cells, AirStrides strides) {
    const auto slab = static_cast<std::size_t>(strides.z + strides.y);
    m_front = 2 * slab + 64;
    // A coarse level's bricks beyond the last ones look for children as far as twelve slabs behind the end.
    const std::size_t size = m_front + cells + 14 * slab + 128;
    m_values.resize(size);
    backend.forEach("bricks", size, ClearKernel{m_values.data()});
  }
  float* data() { return m_values.data() + m_front; }
  const float* data() const { return m_values.data() + m_front; }
  std::size_t bytes() const { return m_values.size() * sizeof(float); }
  /// The cells in host memory.
  void download(Backend& backend, std::size_t cells, std::vector<float>& to) const {
    std::vector<float> all;
    backend.download(m_values, all);
    to.assign(all.begin() + static_cast<std::ptrdiff_t>(m_front),
              all.begin() + static_cast<std::ptrdiff_t>(m_front + cells));
  }

 private:
  typename Backend::template Array<float> m_values;
  std::size_t m_front = 0;
};

}  // namespace spin
