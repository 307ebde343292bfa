// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "core/math/sampling.h"
#include "core/snow/exposure_field.h"

namespace spin {
namespace {

/// Directions of fall that stand for the cone.
constexpr std::size_t kDirections = 16;
/// A facet that takes less than this share of what the smooth slope takes tells little about shelter.
constexpr double kTelling = 0.25;

std::vector<Vec3d> coneDirections(const FallCone& cone) {
  std::vector<Vec3d> directions;
  for (const auto& point : sobolPoints(kDirections))
    directions.push_back(cone.direction(shifted(point[2], 0x80000000u), shifted(point[3], 0x80000000u)));
  return directions;
}

/// What stays on an open slope per precipitation rate and horizontal area.
double openDeposit(Vec3d normal, const std::vector<Vec3d>& directions, const SlopeHold& hold) {
  double sum = 0.0;
  for (const Vec3d& w : directions) sum += std::max(0.0, levelFluxFactor(normal, w));
  return sum / static_cast<double>(directions.size()) / normal.z * hold.share(normal.z);
}

/// Normal of the ground without its facets: gradients at the raster's points by central differences, bilinear
/// between them.
Vec3d smoothNormal(const Raster<float>& h, double x, double y) {
  const double gx = std::clamp((x - h.originX) / h.cellSize, 0.0, h.width - 1.000001);
  const double gy = std::clamp((y - h.originY) / h.cellSize, 0.0, h.height - 1.000001);
  const int i = static_cast<int>(gx), j = static_cast<int>(gy);
  // Over a hole the one-sided difference, or none.
  const auto slope = [&](int ci, int cj, int di, int dj) {
    const int i0 = std::max(ci - di, 0), j0 = std::max(cj - dj, 0);
    const int i1 = std::min(ci + di, h.width - 1), j1 = std::min(cj + dj, h.height - 1);
    const float here = h.at(ci, cj), low = h.at(i0, j0), high = h.at(i1, j1);
    const double from = static_cast<double>(std::isnan(low) ? here : low);
    const double to = static_cast<double>(std::isnan(high) ? here : high);
    const int steps = (i1 - i0 + j1 - j0) - (std::isnan(low) ? 1 : 0) - (std::isnan(high) ? 1 : 0);
    return steps > 0 ? (to - from) / (steps * h.cellSize) : 0.0;
  };
  const auto mixed = [&](int di, int dj) {
    const double u = gx - i, v = gy - j;
    const double south = slope(i, j, di, dj) * (1.0 - u) + slope(i + 1, j, di, dj) * u;
    const double north = slope(i, j + 1, di, dj) * (1.0 - u) + slope(i + 1, j + 1, di, dj) * u;
    return south * (1.0 - v) + north * v;
  };
  return normalized(Vec3d{-mixed(1, 0), -mixed(0, 1), 1.0});
}

/// Sums over rectangles of cells in four look-ups.
class AreaSums {
 public:
  AreaSums(int width, int height, const std::vector<double>& values)
      : m_width(width),
        m_height(height),
        m_sums(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1)) {
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i)
        at(i + 1, j + 1) = values[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(i)] +
                           at(i, j + 1) + at(i + 1, j) - at(i, j);
  }
  /// Over the cells within `reach` of (i, j).
  double around(int i, int j, int reach) const {
    const int i0 = std::max(i - reach, 0), j0 = std::max(j - reach, 0);
    const int i1 = std::min(i + reach + 1, m_width), j1 = std::min(j + reach + 1, m_height);
    return at(i1, j1) - at(i0, j1) - at(i1, j0) + at(i0, j0);
  }

 private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(m_width + 1) + static_cast<std::size_t>(i);
  }
  double& at(int i, int j) { return m_sums[index(i, j)]; }
  double at(int i, int j) const { return m_sums[index(i, j)]; }

  int m_width, m_height;
  std::vector<double> m_sums;
};

struct OpenDeposits {
  std::vector<double> facet, smooth;
};

OpenDeposits openDeposits(const CoverGrid& grid, const TerrainSurface& surface,
                          const std::vector<float>& held, const ExposureSettings& settings,
                          const Workshop& workshop) {
  const std::vector<Vec3d> directions = coneDirections(settings.cone);
  OpenDeposits open{std::vector<double>(held.size()), std::vector<double>(held.size())};
  workshop.backend.forEach("cover facets", held.size(), [&](std::size_t c) {
    if (!(grid.area.values[c] > 0.0f)) return;
    const auto width = static_cast<std::size_t>(grid.base.width);
    const double x = grid.base.x(static_cast<int>(c % width)), y = grid.base.y(static_cast<int>(c / width));
    open.facet[c] = openDeposit(surface.normalAt(x, y), directions, settings.hold);
    open.smooth[c] = openDeposit(smoothNormal(surface.heights(), x, y), directions, settings.hold);
  });
  return open;
}

double massOn(const CoverGrid& grid, const std::vector<float>& held) {
  double sum = 0.0;
  for (std::size_t c = 0; c < held.size(); ++c)
    sum += static_cast<double>(held[c]) * static_cast<double>(grid.area.values[c]);
  return sum;
}

/// The share of the open deposit that arrives (what shelters leave) times the open deposit of the smooth
/// slope. Where a facet turns so far away that it says nothing about shelter, that of its surroundings over
/// one quad counts.
void smoothGrid(const CoverGrid& grid, int reach, const OpenDeposits& open, std::vector<float>& held) {
  const std::vector<float> unsmoothed = held;
  std::vector<double> deposits(held.begin(), held.end());
  const AreaSums heldSums(grid.base.width, grid.base.height, deposits);
  const AreaSums openSums(grid.base.width, grid.base.height, open.facet);
  const double before = massOn(grid, held);
  for (int j = 0; j < grid.base.height; ++j)
    for (int i = 0; i < grid.base.width; ++i) {
      const std::size_t c = grid.base.index(i, j);
      if (!(grid.area.values[c] > 0.0f)) continue;
      const bool telling = open.facet[c] > kTelling * open.smooth[c];
      const double from = telling ? open.facet[c] : openSums.around(i, j, reach);
      const double arrived = telling ? static_cast<double>(held[c]) : heldSums.around(i, j, reach);
      held[c] = from > 0.0 ? static_cast<float>(std::min(arrived / from, 1.0) * open.smooth[c]) : 0.0f;
    }
  const double after = massOn(grid, held);
  // Where hardly a smooth slope holds what its facets hold, there is nothing to spread it over.
  constexpr double kMostScale = 2.0;
  if (!(after * kMostScale >= before)) {
    held = unsmoothed;
    return;
  }
  if (!(after > 0.0)) return;
  for (float& value : held) value = static_cast<float>(static_cast<double>(value) * (before / after));
}

}  // namespace

void smoothFacets(const SceneSnapshot& snapshot, const SnowGround& ground, const ExposureSettings& settings,
                  const Workshop& workshop, ExposureMemory& memory) {
  memory.smooth.resize(memory.gathered.grids.size());
  if (ground.terrain.empty()) return;
  const TerrainSurface surface(snapshot.terrain->heights);
  for (const TerrainGrid& terrain : ground.terrain) {
    const GatheredCover::Cells& gathered = memory.gathered.grids[terrain.grid];
    if (terrain.refinement == 0 || !gathered.asked) continue;
    const CoverGrid& grid = ground.layout->grids[terrain.grid];
    std::vector<float>& held = memory.smooth[terrain.grid];
    held = gathered.held;
    smoothGrid(grid, terrain.refinement, openDeposits(grid, surface, held, settings, workshop), held);
  }
}

}  // namespace spin
