// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/snow/exposure_field.h"
#include "core/snow/occlusion_map.h"

namespace spin {

/// A grid of a cover: its box in axes of its own, and where they stand less the snow scene's centre.
struct GridPlace {
  std::size_t grid = 0;              ///< in the layout
  std::size_t model = 0, patch = 0;  ///< of a model's patch
  Box3d box;                         ///< empty where the grid has no cells
  Vec3d move{};
  double cellSize = 1.0;

  /// Where it stands, plus an offset.
  Box3d moved(Vec3d offset = {}) const;
};

/// Occlusion maps for grids in a row, one for each of the directions that are evenly spread over the cone of
/// fall. Texels of half a cell, or what the largest map allows; neighbours that fit into one map share it.
/// Which do follows from the places' own axes, so a model that moves takes its maps along.
class SharedMaps {
 public:
  SharedMaps(const std::vector<GridPlace>& places, const ExposureSettings& settings);

  /// Diagonal of the largest box that a map shows with texels of half a cell, m.
  static double largest(double cellSize, const ExposureSettings& settings) {
    return 0.9 * 0.5 * cellSize * settings.mapSize;
  }
  /// Index behind the last place that shares the maps of `first`, the first one of its group.
  std::size_t groupEnd(std::size_t first) const { return m_end[first]; }
  /// Size that a group's texels do not exceed, m, in any direction.
  double largestTexel(std::size_t first) const;
  /// Draws the maps of a group as far as `wanted` (less the scene's centre) needs them, by a raster where
  /// there is one.
  std::vector<OcclusionMap> draw(std::size_t first, const Box3d& wanted, const Occluders& occluders,
                                 MapRaster* raster, const Workshop& workshop) const;

 private:
  const std::vector<GridPlace>& m_places;
  const ExposureSettings& m_settings;
  std::vector<std::size_t> m_end;  ///< by the first place of a group; 0 elsewhere
  std::vector<double> m_diagonal;  ///< m, of the group's box, likewise
};

/// Sorts the patches of each model so that neighbours follow each other, for maps that they share.
void sortForMaps(std::vector<GridPlace>& places, const ExposureSettings& settings);

}  // namespace spin
