// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/surface_samples.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace spin {
namespace {

/// Points that keep a distance, found again by cells of that size.
class SpacedPoints {
 public:
  explicit SpacedPoints(double distance) : m_distance(distance) {}

  void add(Vec3d p) {
    const std::array<std::int64_t, 3> cell = cellOf(p);
    for (std::int64_t z = cell[2] - 1; z <= cell[2] + 1; ++z)
      for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y)
        for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x) {
          const auto found = m_cells.find(keyOf(x, y, z));
          if (found == m_cells.end()) continue;
          for (const std::uint32_t k : found->second)
            if (length(points[k] - p) < m_distance) return;
        }
    m_cells[keyOf(cell[0], cell[1], cell[2])].push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p);
  }
  std::vector<Vec3d> points;

 private:
  std::array<std::int64_t, 3> cellOf(Vec3d p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / m_distance)),
            static_cast<std::int64_t>(std::floor(p.y / m_distance)),
            static_cast<std::int64_t>(std::floor(p.z / m_distance))};
  }
  static std::uint64_t keyOf(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto part = [](std::int64_t v) { return static_cast<std::uint64_t>(v) & 0x1FFFFFu; };
    return part(x) | (part(y) << 21) | (part(z) << 42);
  }
  double m_distance;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

/// Candidates per square of the distance.
constexpr double kDensity = 24.0;

}  // namespace

std::vector<Vec3d> surfaceSamples(
    const TriangleMesh& mesh, double distance,
    const std::function<std::optional<Vec3d>(Vec3d candidate, Vec3d normal)>& place) {
  SpacedPoints kept(distance);
  const auto offer = [&](Vec3d p, Vec3d n) {
    if (const std::optional<Vec3d> at = place(p, n)) kept.add(*at);
  };
  const auto normalOf = [&](std::size_t t) {
    return cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
  };
  for (std::size_t t = 0; t < mesh.triangles(); ++t)
    for (int k = 0; k < 3; ++k) offer(mesh.corner(t, k), normalized(normalOf(t)));
  double owed = 0.0;  // what small triangles leave of a candidate
  std::uint64_t number = 0;
  for (std::size_t t = 0; t < mesh.triangles(); ++t) {
    const Vec3d a = mesh.corner(t, 0), ab = mesh.corner(t, 1) - a, ac = mesh.corner(t, 2) - a;
    owed += kDensity * 0.5 * length(normalOf(t)) / (distance * distance);
    for (; owed >= 1.0; owed -= 1.0, ++number) {
      const auto n = static_cast<double>(number % (1u << 20));
      double u = std::fmod(0.5 + n * 0.7548776662466927, 1.0),
             v = std::fmod(0.5 + n * 0.5698402909980532, 1.0);
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      offer(a + ab * u + ac * v, normalized(normalOf(t)));
    }
  }
  return std::move(kept.points);
}

}  // namespace spin
