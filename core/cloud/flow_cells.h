// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "core/sph/flow_solver.h"

namespace spin {

/// Particles of the flow by cells of one support, for those who ask what is near.
class FlowCells {
 public:
  FlowCells(const std::vector<FlowSample>& samples, double support);

  /// Calls visit(index of a sample, offset from p to it, distance) for all within the support, by row and
  /// index.
  template <class Visit>
  void near(Vec3d p, const Visit& visit) const {
    if (m_entries.empty()) return;
    const std::int64_t x = cellOf(p.x - m_low.x), y = cellOf(p.y - m_low.y), z = cellOf(p.z - m_low.z);
    for (std::int64_t c = std::max<std::int64_t>(z - 1, 0); c <= std::min(z + 1, m_cells[2] - 1); ++c)
      for (std::int64_t b = std::max<std::int64_t>(y - 1, 0); b <= std::min(y + 1, m_cells[1] - 1); ++b) {
        const std::int64_t first = std::max<std::int64_t>(x - 1, 0), last = std::min(x + 1, m_cells[0] - 1);
        if (first > last) continue;
        const std::int64_t row = (c * m_cells[1] + b) * m_cells[0];
        auto it = std::lower_bound(m_entries.begin(), m_entries.end(), Entry{row + first, 0});
        for (; it != m_entries.end() && it->cell <= row + last; ++it) {
          const Vec3d offset = (*m_samples)[it->sample].particle.position - p;
          const double distance = length(offset);
          if (distance < m_support) visit(std::size_t{it->sample}, offset, distance);
        }
      }
  }
  /// Particles within the support.
  int count(Vec3d p) const;
  double support() const { return m_support; }

 private:
  struct Entry {
    std::int64_t cell;
    std::uint32_t sample;
    friend auto operator<=>(const Entry&, const Entry&) = default;
  };
  std::int64_t cellOf(double offset) const {
    return static_cast<std::int64_t>(std::floor(offset / m_support));
  }

  const std::vector<FlowSample>* m_samples;
  double m_support;
  Vec3d m_low{};
  std::int64_t m_cells[3] = {0, 0, 0};
  std::vector<Entry> m_entries;  ///< sorted
};

}  // namespace spin
