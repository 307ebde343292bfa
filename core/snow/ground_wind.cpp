// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/ground_wind.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kAbove = 2.0;  ///< m above a cell at which the wind is asked

}  // namespace

void GroundWind::sheltered(const double* depth, const ShelterSettings& settings, CpuBackend& backend,
                           std::vector<float>& out) const {
  out.resize(friction.size());
  backend.forEach("drift", friction.size(), [&](std::size_t c) {
    out[c] = friction[c] * static_cast<float>(shelterFactor(shelter[c], depth[c], settings));
  });
}

GroundWind groundWind(const CoverGraph& graph, const WindField& field, const WindObstacles& obstacles,
                      Vec2d wind10, double roughness, const ShelterSettings& settings, CpuBackend& backend) {
  GroundWind wind;
  wind.direction.resize(graph.size());
  wind.friction.resize(graph.size());
  wind.shelter = upwindSlopes(graph, obstacles, wind10, settings, backend);
  const double level = 0.4 * std::hypot(wind10.x, wind10.y) / std::log(10.0 / roughness);
  for (const CoverGraph::Grid& grid : graph.grids()) {
    const auto cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    backend.forEach("drift", cells, [&](std::size_t c) {
      const auto cell = grid.first + static_cast<std::uint32_t>(c);
      if (!(graph.area(cell) > 0.0f)) return;
      const double x = grid.originX +
                       static_cast<int>(c % static_cast<std::size_t>(grid.width)) * grid.cellSize,
                   y = grid.originY +
                       static_cast<int>(c / static_cast<std::size_t>(grid.width)) * grid.cellSize;
      double above = kAbove;
      if (grid.onModel)
        above += std::max(0.0, static_cast<double>(graph.bed(cell)) - field.groundHeight(x, y));
      const Vec3d at = field.at(x, y, above, wind10);
      const double speed = std::hypot(at.x, at.y);
      if (!(speed > 0.0)) return;
      wind.direction[cell] = {static_cast<float>(at.x / speed), static_cast<float>(at.y / speed)};
      wind.friction[cell] = static_cast<float>(level * field.speedUp(x, y, above, wind10));
    });
  }
  return wind;
}

}  // namespace spin
