// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/body_boundary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include "core/fields/mesh_distance.h"
#include "core/fields/surface_samples.h"
#include "core/physics/kernels.h"
#include "core/sph/wall_law.h"

namespace spin {
namespace {

/// Least distance of samples, spacings: dart throwing then leaves about one to a square of the spacing.
constexpr double kSampleDistance = 0.8;

class Inset {
 public:
  Inset(const MeshShells& shells, double spacing) : m_origin(shells.origin), m_spacing(spacing) {
    for (std::size_t k = 0; k < shells.shells.size(); ++k) m_shells.emplace_back(shells, k);
  }

  /// Half a spacing below the surface; nothing where that is nearer to another face, or the place is inside.
  std::optional<Vec3d> operator()(Vec3d p, Vec3d normal) const {
    const ShellDistance* own = nullptr;
    double nearest = 1e30;
    for (const ShellDistance& shell : m_shells)
      if (const auto s = shell.nearest(p - m_origin, nearest)) nearest = s->distance, own = &shell;
    if (own == nullptr) return {};
    const double slack = 0.1 * m_spacing;
    if (unionDistance(p) < -slack) return {};
    const double depth = 0.5 * own->thickness(p - m_origin, -normal, m_spacing);
    const Vec3d q = p - normal * depth;
    if (own->closed() && unionDistance(q) > slack - depth) return {};
    return q;
  }

 private:
  double unionDistance(Vec3d p) const {
    double least = 1e30;
    for (const ShellDistance& shell : m_shells)
      if (shell.closed()) least = std::min(least, *shell.signedDistance(p - m_origin, 1e30));
    return least;
  }
  Vec3d m_origin;
  double m_spacing;
  std::vector<ShellDistance> m_shells;
};

/// sum W over all points, times the support's cube.
std::vector<double> kernelSums(const std::vector<Vec3d>& points, double support) {
  using Cell = std::array<std::int64_t, 3>;
  std::map<Cell, std::vector<std::size_t>> cells;
  const auto cellOf = [&](Vec3d p) {
    return Cell{static_cast<std::int64_t>(std::floor(p.x / support)),
                static_cast<std::int64_t>(std::floor(p.y / support)),
                static_cast<std::int64_t>(std::floor(p.z / support))};
  };
  for (std::size_t k = 0; k < points.size(); ++k) cells[cellOf(points[k])].push_back(k);
  std::vector<double> sums(points.size(), 0.0);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Cell c = cellOf(points[k]);
    for (std::int64_t z = c[2] - 1; z <= c[2] + 1; ++z)
      for (std::int64_t y = c[1] - 1; y <= c[1] + 1; ++y)
        for (std::int64_t x = c[0] - 1; x <= c[0] + 1; ++x) {
          const auto found = cells.find(Cell{x, y, z});
          if (found == cells.end()) continue;
          for (const std::size_t j : found->second)
            sums[k] += CubicSpline::kNorm * CubicSpline::shape(length(points[j] - points[k]) / support);
        }
  }
  return sums;
}

}  // namespace

BodyBoundary sampleBody(const RigidShape& shape, double spacing, double support) {
  BodyBoundary boundary;
  if (const Result<MeshShells> shells = makeMeshShells(shape.mesh)) {
    const Inset inset(*shells, spacing);
    boundary.positions = surfaceSamples(shape.mesh, kSampleDistance * spacing,
                                        [&](Vec3d p, Vec3d normal) { return inset(p, normal); });
  }
  if (boundary.positions.empty()) boundary.positions.push_back({});
  // A plane layer of such particles at distance z has the density share P(z) / P(0).
  const double layer = spacing / support;
  const auto share =
      static_cast<double>(solidShare(static_cast<float>(0.5 * layer), static_cast<float>(layer)).density);
  const double factor = share * CubicSpline::planeIntegral(0.0) / CubicSpline::planeIntegral(layer);
  const double cube = support * support * support / (spacing * spacing * spacing);
  for (const double sum : kernelSums(boundary.positions, support))
    boundary.volumes.push_back(static_cast<float>(factor * cube / sum));
  return boundary;
}

}  // namespace spin
