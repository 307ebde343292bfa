// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/sky_change.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace spin {
namespace {

Sphere boundsOf(const StandingModel& model) {
  Box3d box;
  for (const PlacedTriangle& triangle : model.triangles)
    for (const Vec3f& p : triangle.corners) box.extend(p.to<double>());
  if (box.empty()) return {model.placement.translation, 0.0};
  return {model.placement.translation + box.centre(), 0.5 * length(box.size())};
}

}  // namespace

SkyChange::SkyChange(const FallCone& cone, const std::vector<StandingModel>& before,
                     const std::vector<StandingModel>& after)
    : m_everywhere(false), m_towardsSky(-cone.frame.n), m_halfAngle(cone.halfAngle) {
  SPIN_CHECK(before.size() == after.size(), "the same models");
  for (std::size_t m = 0; m < after.size(); ++m) {
    m_models.push_back(!(before[m].placement == after[m].placement));
    if (!m_models[m]) continue;
    m_spheres.push_back(boundsOf(before[m]));
    m_spheres.push_back(boundsOf(after[m]));
  }
}

bool SkyChange::reaches(const Box3d& box, double margin) const {
  if (m_everywhere) return true;
  if (box.empty()) return false;
  const double own = 0.5 * length(box.size()) + margin;
  // A line from within one sphere meets the other if one from the centre meets it grown by the first.
  return std::any_of(m_spheres.begin(), m_spheres.end(), [&](const Sphere& sphere) {
    const Vec3d way = sphere.centre - box.centre();
    const double reach = sphere.radius + own, distance = length(way);
    if (distance <= reach) return true;
    const double angle = std::acos(std::clamp(dot(way, m_towardsSky) / distance, -1.0, 1.0));
    constexpr double kRounding = 1e-6;
    return angle <= m_halfAngle + std::asin(reach / distance) + kRounding;
  });
}

}  // namespace spin
