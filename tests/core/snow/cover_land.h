// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/snow/cover_graph.h"

namespace spin::test {

/// One terrain grid of n x m cells of full area with heights z(x, y); holes where z is NaN.
template <class Z>
SnowGround landGround(int n, int m, double cell, const Z& z) {
  auto layout = std::make_shared<CoverLayout>();
  CoverGrid grid{"terrain", "terrain", Raster<float>(n, m, 0.0, 0.0, cell), {}};
  grid.area = grid.base.sameShape<float>(0.0f);
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      grid.base.at(i, j) = static_cast<float>(z(grid.base.x(i), grid.base.y(j)));
      grid.area.at(i, j) = std::isnan(grid.base.at(i, j)) ? 0.0f : static_cast<float>(cell * cell);
    }
  layout->grids.push_back(std::move(grid));
  SnowGround ground;
  ground.layout = std::move(layout);
  ground.terrain.push_back({0, 0, 0, 0});
  return ground;
}

template <class Z>
std::shared_ptr<const CoverGraph> landGraph(int n, int m, double cell, const Z& z) {
  return std::make_shared<const CoverGraph>(makeCoverGraph(landGround(n, m, cell, z), nullptr));
}

/// Amount on all cells of something per m2.
inline double sumOver(const CoverGraph& graph, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::uint32_t c = 0; c < values.size(); ++c) sum += values[c] * static_cast<double>(graph.area(c));
  return sum;
}

}  // namespace spin::test
