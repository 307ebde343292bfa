// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/domain_faces.h"

#include <algorithm>
#include <cmath>

namespace spin {

DomainSide::DomainSide(const SnowScene& scene, int axis, int sign)
    : m_outward(axis == 0 ? Vec3d{double(sign), 0, 0} : Vec3d{0, double(sign), 0}),
      m_axis(axis),
      m_place((sign > 0 ? scene.domain.max : scene.domain.min)[axis]),
      m_top(scene.domain.max.z),
      m_floor(scene.level) {
  const int other = 1 - axis;
  std::vector<Segment> ground;
  for (const SkirtEdge& edge : scene.skirts) {
    if (!edge.onBorder || !(edge.outward == m_outward)) continue;
    if (edge.from[other] < edge.to[other])
      ground.push_back({edge.from[other], edge.to[other], edge.from.z, edge.to.z});
    else
      ground.push_back({edge.to[other], edge.from[other], edge.to.z, edge.from.z});
  }
  std::sort(ground.begin(), ground.end(), [](const Segment& a, const Segment& b) { return a.from < b.from; });
  double reached = scene.domain.min[other];
  const double end = scene.domain.max[other], hair = 1e-9 * (end - reached);
  for (const Segment& segment : ground) {
    if (segment.from > reached + hair) m_segments.push_back({reached, segment.from, m_floor, m_floor});
    m_segments.push_back(segment);
    reached = segment.to;
  }
  if (end > reached + hair) m_segments.push_back({reached, end, m_floor, m_floor});
  double sum = 0.0;
  for (const Segment& s : m_segments)
    m_areaToHere.push_back(sum += (s.to - s.from) * (m_top - 0.5 * (s.bottomFrom + s.bottomTo)));
}

Vec3d DomainSide::point(double along, double z) const {
  return m_axis == 0 ? Vec3d{m_place, along, z} : Vec3d{along, m_place, z};
}

Vec3d DomainSide::at(double u, double v) const {
  const double area = u * m_areaToHere.back();
  const auto found = std::upper_bound(m_areaToHere.begin(), m_areaToHere.end(), area);
  const auto k = std::min(static_cast<std::size_t>(found - m_areaToHere.begin()), m_segments.size() - 1);
  const Segment& s = m_segments[k];
  const double before = k == 0 ? 0.0 : m_areaToHere[k - 1];
  const double share = (area - before) / (m_areaToHere[k] - before);
  // The column's height changes linearly along the segment, so its area is quadratic in t.
  const double ha = m_top - s.bottomFrom, hb = m_top - s.bottomTo;
  const double t = share * (ha + hb) / (ha + std::sqrt(std::max(0.0, ha * ha - share * (ha * ha - hb * hb))));
  const double bottom = s.bottomFrom + t * (s.bottomTo - s.bottomFrom);
  return point(s.from + t * (s.to - s.from), bottom + v * (m_top - bottom));
}

double DomainSide::lowerEdge(double along) const {
  for (const Segment& s : m_segments)
    if (along >= s.from && along <= s.to)
      return s.bottomFrom + (s.bottomTo - s.bottomFrom) * (along - s.from) / (s.to - s.from);
  return m_floor;
}

std::array<DomainSide, 4> domainSides(const SnowScene& scene) {
  return {DomainSide(scene, 0, -1), DomainSide(scene, 0, 1), DomainSide(scene, 1, -1),
          DomainSide(scene, 1, 1)};
}

}  // namespace spin
