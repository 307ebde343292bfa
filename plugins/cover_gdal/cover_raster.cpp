// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cover_gdal/cover_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spin {
namespace {

struct Sums {
  double area = 0.0;
  double depth = 0.0;
  double swe = 0.0;
  double liquid = 0.0;
  double temperature = 0.0;
};

bool fits(const CoverGrid& grid, const CoverPart::Values& values) {
  const std::size_t cells = grid.base.size();
  return grid.area.size() == cells && values.swe.size() == cells && values.depth.size() == cells;
}

/// The values of a field, or nothing where the frame does not hold it.
const float* fieldOf(const std::vector<float>& values, std::size_t cells) {
  return values.size() == cells ? values.data() : nullptr;
}

void addGrid(const CoverGrid& grid, const CoverPart::Values& values, const Raster<float>& coarse,
             std::vector<Sums>& sums) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const float* liquid = fieldOf(values.liquid, grid.base.size());
  const float* temperature = fieldOf(values.temperature, grid.base.size());
  for (int j = 0; j < grid.base.height; ++j) {
    for (int i = 0; i < grid.base.width; ++i) {
      const std::size_t cell = grid.base.index(i, j);
      const double area = static_cast<double>(grid.area.values[cell]);
      if (!(area > 0.0) || std::isnan(grid.base.values[cell])) continue;
      // A fine grid may reach over the edge by half a cell; its snow belongs to the edge cell.
      const int column = std::clamp(coarse.column(grid.base.x(i)), 0, coarse.width - 1);
      const int row = std::clamp(coarse.row(grid.base.y(j)), 0, coarse.height - 1);
      Sums& to = sums[coarse.index(column, row)];
      to.area += area;
      to.depth += area * static_cast<double>(values.depth[cell]);
      to.swe += area * static_cast<double>(values.swe[cell]);
      to.liquid += liquid ? area * static_cast<double>(liquid[cell]) : kNone;
      to.temperature += temperature ? area * static_cast<double>(temperature[cell]) : kNone;
    }
  }
}

}  // namespace

std::optional<TerrainCover> gatherTerrainCover(const CoverPart& cover) {
  if (!cover.layout || cover.values.size() != cover.layout->grids.size()) return std::nullopt;
  const std::vector<CoverGrid>& grids = cover.layout->grids;
  const auto coarse =
      std::find_if(grids.begin(), grids.end(), [](const CoverGrid& grid) { return grid.id == "terrain"; });
  if (coarse == grids.end() || coarse->base.empty()) return std::nullopt;
  std::vector<Sums> sums(coarse->base.size());
  for (std::size_t g = 0; g < grids.size(); ++g) {
    if (grids[g].id != "terrain" && grids[g].id.rfind("terrain/", 0) != 0) continue;
    if (!fits(grids[g], cover.values[g])) return std::nullopt;
    addGrid(grids[g], cover.values[g], coarse->base, sums);
  }
  const float none = std::numeric_limits<float>::quiet_NaN();
  const Raster<float> blank = coarse->base.sameShape<float>(none);
  TerrainCover out{blank, blank, blank, blank, coarse->base.sameShape<float>(0.0f)};
  for (std::size_t c = 0; c < sums.size(); ++c) {
    if (!(sums[c].area > 0.0)) continue;
    out.depth.values[c] = static_cast<float>(sums[c].depth / sums[c].area);
    out.swe.values[c] = static_cast<float>(sums[c].swe / sums[c].area);
    out.liquid.values[c] = static_cast<float>(sums[c].liquid / sums[c].area);
    out.temperature.values[c] = static_cast<float>(sums[c].temperature / sums[c].area);
    out.area.values[c] = static_cast<float>(sums[c].area);
  }
  return out;
}

}  // namespace spin
