// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/wind_shelter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spin {
namespace {

constexpr float kNone = -std::numeric_limits<float>::infinity();
constexpr double kGrowth = 0.07;  ///< of the search's steps with the distance

Raster<float> halved(const Raster<float>& fine) {
  Raster<float> half((fine.width + 1) / 2, (fine.height + 1) / 2, fine.originX + 0.5 * fine.cellSize,
                     fine.originY + 0.5 * fine.cellSize, 2.0 * fine.cellSize, kNone);
  for (int j = 0; j < fine.height; ++j)
    for (int i = 0; i < fine.width; ++i) {
      float& block = half.at(i / 2, j / 2);
      block = std::max(block, fine.at(i, j));
    }
  return half;
}

/// Raises the tops to a triangle's: over the cells whose middle it covers, and along its edges, so that
/// upright sheets count.
void raiseTops(const std::array<Vec3d, 3>& corners, ObstacleTops& tops) {
  const auto raise = [&](int i, int j, double z) {
    if (!tops.contains(i, j)) return;
    float& top = tops.at(i, j);
    if (!(static_cast<double>(top) >= z)) top = static_cast<float>(z);  // NaN is raised too
  };
  for (std::size_t e = 0; e < 3; ++e) {
    const Vec3d a = corners[e], edge = corners[(e + 1) % 3] - a;
    const double steps = std::ceil(2.0 * std::hypot(edge.x, edge.y) / tops.cellSize) + 1.0;
    if (!(steps < 1e7)) continue;
    for (int s = 0; s <= static_cast<int>(steps); ++s) {
      const Vec3d p = a + edge * (s / steps);
      raise(tops.column(p.x), tops.row(p.y), p.z);
    }
  }
  const Vec3d n = cross(corners[1] - corners[0], corners[2] - corners[0]);
  if (!(std::abs(n.z) > 1e-12 * length(n))) return;
  const auto [x0, x1] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
  const auto [y0, y1] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
  const double side = n.z > 0.0 ? 1.0 : -1.0;
  for (int j = std::max(tops.row(y0), 0); j <= std::min(tops.row(y1), tops.height - 1); ++j)
    for (int i = std::max(tops.column(x0), 0); i <= std::min(tops.column(x1), tops.width - 1); ++i) {
      const double x = tops.x(i), y = tops.y(j);
      bool within = true;
      for (std::size_t e = 0; e < 3 && within; ++e) {
        const Vec3d &a = corners[e], &b = corners[(e + 1) % 3];
        within = side * ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) >= 0.0;
      }
      if (within) raise(i, j, corners[0].z - (n.x * (x - corners[0].x) + n.y * (y - corners[0].y)) / n.z);
    }
}

}  // namespace

HeightPyramid::HeightPyramid(const Raster<float>& heights) {
  m_levels.push_back(heights);
  for (float& z : m_levels[0].values)
    if (!std::isfinite(z)) z = kNone;
  while (m_levels.back().width > 1 || m_levels.back().height > 1) m_levels.push_back(halved(m_levels.back()));
}

bool HeightPyramid::covers(double x, double y) const {
  const Raster<float>& base = m_levels.front();
  return base.contains(base.column(x), base.row(y));
}

double HeightPyramid::highest(double x, double y, double size) const {
  std::size_t level = 0;
  while (level + 1 < m_levels.size() && m_levels[level + 1].cellSize <= size) ++level;
  const Raster<float>& blocks = m_levels[level];
  // Lines between blocks are lines between cells: which block holds a cell is asked by the cell.
  const Raster<float>& base = m_levels.front();
  const int i = base.column(x) >> level, j = base.row(y) >> level;
  return blocks.contains(i, j) ? static_cast<double>(blocks.at(i, j))
                               : -std::numeric_limits<double>::infinity();
}

ObstacleTops obstacleTops(const Raster<float>& cells, const std::vector<StandingModel>& models) {
  ObstacleTops tops = cells.sameShape<float>(std::numeric_limits<float>::quiet_NaN());
  for (const StandingModel& model : models)
    for (const PlacedTriangle& triangle : model.triangles) {
      std::array<Vec3d, 3> corners;
      for (std::size_t c = 0; c < 3; ++c)
        corners[c] = triangle.corners[c].to<double>() + model.placement.translation;
      raiseTops(corners, tops);
    }
  return tops;
}

WindObstacles makeWindObstacles(const SceneSnapshot& snapshot, const SnowGround& ground,
                                const std::vector<StandingModel>& models) {
  WindObstacles obstacles;
  for (const TerrainGrid& terrain : ground.terrain) {
    if (terrain.refinement == 0) {
      obstacles.coarse.emplace_back(snapshot.terrain->heights);
      continue;
    }
    const Raster<float>& base = ground.layout->grids[terrain.grid].base;
    ObstacleTops tops = obstacleTops(base, models);
    Raster<float> heights = base;
    for (std::size_t c = 0; c < heights.size(); ++c)
      if (tops.values[c] > heights.values[c]) heights.values[c] = tops.values[c];
    obstacles.fine.emplace_back(heights);
    obstacles.tops.push_back(std::move(tops));
  }
  return obstacles;
}

namespace {

UpwindSlope searchUpwind(const WindObstacles& obstacles, Vec3d from, Vec2d upwind, double firstStep,
                         double reach) {
  UpwindSlope best;
  const HeightPyramid* inside = nullptr;
  for (double d = firstStep; d <= reach;) {
    const double x = from.x + d * upwind.x, y = from.y + d * upwind.y;
    if (!inside || !inside->covers(x, y)) {
      const auto fine = std::find_if(obstacles.fine.begin(), obstacles.fine.end(),
                                     [&](const HeightPyramid& p) { return p.covers(x, y); });
      inside =
          fine != obstacles.fine.end() ? &*fine : (obstacles.coarse.empty() ? nullptr : &obstacles.coarse[0]);
      if (!inside || !inside->covers(x, y)) break;
    }
    const double step = std::max(inside->cellSize(), kGrowth * d);
    // A block reaches to both sides of the point: what is nearer than the point must not seem steeper.
    const double tangent = (inside->highest(x, y, step) - from.z) / (d + 0.5 * (step - inside->cellSize()));
    if (tangent > static_cast<double>(best.tangent))
      best = {static_cast<float>(tangent), static_cast<float>(d)};
    d += step;
  }
  return best;
}

}  // namespace

std::vector<UpwindSlope> upwindSlopes(const CoverGraph& graph, const WindObstacles& obstacles,
                                      Vec2d direction, const ShelterSettings& settings, CpuBackend& backend) {
  std::vector<UpwindSlope> slopes(graph.size());
  const double size = std::hypot(direction.x, direction.y);
  if (!(size > 0.0)) return slopes;
  const Vec2d upwind = direction * (-1.0 / size);
  for (const CoverGraph::Grid& grid : graph.grids()) {
    const auto cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    backend.forEach("shelter", cells, [&](std::size_t c) {
      const auto cell = grid.first + static_cast<std::uint32_t>(c);
      if (!(graph.area(cell) > 0.0f)) return;
      const int i = static_cast<int>(c) % grid.width, j = static_cast<int>(c) / grid.width;
      const Vec3d from{grid.originX + i * grid.cellSize, grid.originY + j * grid.cellSize,
                       static_cast<double>(graph.bed(cell))};
      slopes[cell] = searchUpwind(obstacles, from, upwind, grid.cellSize, settings.reach);
    });
  }
  return slopes;
}

}  // namespace spin
