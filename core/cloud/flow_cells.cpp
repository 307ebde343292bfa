// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/flow_cells.h"

namespace spin {

FlowCells::FlowCells(const std::vector<FlowSample>& samples, double support)
    : m_samples(&samples), m_support(support) {
  Box3d box;
  for (const FlowSample& s : samples) box.extend(s.particle.position);
  if (box.empty()) return;
  m_low = box.min;
  for (int axis = 0; axis < 3; ++axis) m_cells[axis] = cellOf(box.size()[axis]) + 1;
  m_entries.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3d p = samples[i].particle.position - m_low;
    m_entries.push_back(
        {(cellOf(p.z) * m_cells[1] + cellOf(p.y)) * m_cells[0] + cellOf(p.x), static_cast<std::uint32_t>(i)});
  }
  std::sort(m_entries.begin(), m_entries.end());
}

int FlowCells::count(Vec3d p) const {
  int found = 0;
  near(p, [&](std::size_t, Vec3d, double) { ++found; });
  return found;
}

}  // namespace spin
