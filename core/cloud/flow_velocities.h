// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/sph/flow_solver.h"

namespace spin {

/// Velocities of the flow's particles when a part of a frame began: what they lost since tells an impact,
/// however short it was, and pressure that only trembles is none.
class FlowVelocities {
 public:
  void note(const std::vector<FlowSample>& samples) {
    m_first = UINT32_MAX;
    std::uint32_t last = 0;
    for (const FlowSample& s : samples) {
      m_first = std::min(m_first, s.particle.id);
      last = std::max(last, s.particle.id);
    }
    m_velocities.assign(samples.empty() ? 0 : std::size_t{last - m_first} + 1, std::nullopt);
    for (const FlowSample& s : samples) m_velocities[s.particle.id - m_first] = s.particle.velocity;
  }
  /// m/s; none where the particle was not there yet.
  std::optional<Vec3d> of(std::uint32_t id) const {
    return id >= m_first && id - m_first < m_velocities.size() ? m_velocities[id - m_first] : std::nullopt;
  }

 private:
  std::uint32_t m_first = UINT32_MAX;
  std::vector<std::optional<Vec3d>> m_velocities;  ///< by number since the first
};

}  // namespace spin
