// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/snow/snow_scene.h"

namespace spin {

/// A vertical side of the domain: the air between the ground's edge (or the floor, where no ground meets the
/// side) and the top.
class DomainSide {
 public:
  /// axis 0 or 1; sign +1 for the side at the domain's maximum.
  DomainSide(const SnowScene& scene, int axis, int sign);

  Vec3d outward() const { return m_outward; }
  double area() const { return m_areaToHere.empty() ? 0.0 : m_areaToHere.back(); }
  /// Point uniform over the side's area; u, v in [0, 1).
  Vec3d at(double u, double v) const;
  /// Height of the side's lower edge at a coordinate along it.
  double lowerEdge(double along) const;

 private:
  struct Segment {
    double from, to;              ///< along the side
    double bottomFrom, bottomTo;  ///< heights of the lower edge
  };
  Vec3d point(double along, double z) const;

  Vec3d m_outward;
  int m_axis;
  double m_place, m_top, m_floor;
  std::vector<Segment> m_segments;
  std::vector<double> m_areaToHere;
};

std::array<DomainSide, 4> domainSides(const SnowScene& scene);

}  // namespace spin
