// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/snow/cover_graph.h"
#include "core/snow/wind_field.h"

namespace spin {

/// Heights of a raster and the highest of ever larger blocks of it, m; -infinity where there is none.
class HeightPyramid {
 public:
  explicit HeightPyramid(const Raster<float>& heights);
  bool covers(double x, double y) const;
  /// Highest within the block of about `size` metres that a point lies in.
  double highest(double x, double y, double size) const;
  double cellSize() const { return m_levels.front().cellSize; }

 private:
  std::vector<Raster<float>> m_levels;
};

/// What stands in the wind's way: the terrain, and near models it and their tops, finely.
struct WindObstacles {
  std::vector<ObstacleTops> tops;     ///< of models, by fine terrain grid
  std::vector<HeightPyramid> fine;    ///< terrain and tops
  std::vector<HeightPyramid> coarse;  ///< the terrain; empty or one
};
/// Tops of the models over the cells of a raster.
ObstacleTops obstacleTops(const Raster<float>& cells, const std::vector<StandingModel>& models);
WindObstacles makeWindObstacles(const SceneSnapshot& snapshot, const SnowGround& ground,
                                const std::vector<StandingModel>& models);

struct ShelterSettings {
  double reach = 200.0;  ///< m, upwind search (Winstral et al. 2002: 100 to 300 m)
  double from = 0.05;    ///< tangent of the upwind slope at which shelter begins: 20 heights behind a fence
  double full = 0.2;     ///< and at which the wind carries nothing: 5 heights
};

/// The upwind slope of one cell of the cover's graph: what shelters it most, by its bare surface.
struct UpwindSlope {
  float tangent = 0.0f;   ///< 0 where nothing upwind is higher
  float distance = 1.0f;  ///< m to what it is
};

/// Share of the wind's friction velocity that a cell keeps in the lee, 0 to 1: 1 up to the tangent `from`, 0
/// from `full` on. Snow that lies in the lee lowers the slope to what shelters it, so that drifts fill up to
/// about the slopes of equilibrium drifts (1:6 to 1:7, Tabler 1994) and then let the wind pass.
inline double shelterFactor(const UpwindSlope& slope, double snowDepth, const ShelterSettings& settings) {
  const double tangent = static_cast<double>(slope.tangent) - snowDepth / static_cast<double>(slope.distance);
  const double s = (settings.full - tangent) / (settings.full - settings.from);
  return s < 0.0 ? 0.0 : (s > 1.0 ? 1.0 : s);
}

/// Maximum upwind slope (the Sx of Winstral et al. 2002) of every cell for a wind towards `direction`. A
/// mass-consistent wind has no wakes; this stands in for them. It takes fences, trees and houses as solid,
/// and knows no eddies: behind a house snow gathers, but no scour forms at its corners.
std::vector<UpwindSlope> upwindSlopes(const CoverGraph& graph, const WindObstacles& obstacles,
                                      Vec2d direction, const ShelterSettings& settings, CpuBackend& backend);

}  // namespace spin
