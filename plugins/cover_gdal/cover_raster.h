// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/sim/frame.h"

namespace spin {

/// The cover of the whole terrain on its coarse grid; NaN where no grid accounts for any area. Liquid water
/// and temperature are NaN throughout if a grid of the frame lacks them, which is so where nothing melts.
struct TerrainCover {
  Raster<float> depth;        ///< m, area-weighted mean
  Raster<float> swe;          ///< kg/m2, area-weighted mean
  Raster<float> liquid;       ///< kg/m2 of water within the snow, area-weighted mean
  Raster<float> temperature;  ///< K of the surface, snow or bare, area-weighted mean
  Raster<float> area;         ///< m2 of horizontal area that each cell stands for; sum(swe area) is the mass
};

/// Gathers grid "terrain" and the fine grids "terrain/..." (a fine cell counts for the coarse cell that its
/// centre lies in). Nothing if there is no such grid or its values do not fit it.
std::optional<TerrainCover> gatherTerrainCover(const CoverPart& cover);

}  // namespace spin
