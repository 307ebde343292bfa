// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cell_mask.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Box of the terrain's points in columns i0..i1 and rows j0..j1.
Box3d landBox(const Raster<float>& h, int i0, int i1, int j0, int j1) {
  Box3d box;
  for (int j = std::max(j0, 0); j <= std::min(j1, h.height - 1); ++j)
    for (int i = std::max(i0, 0); i <= std::min(i1, h.width - 1); ++i)
      if (!std::isnan(h.at(i, j))) box.extend(Vec3d{h.x(i), h.y(j), static_cast<double>(h.at(i, j))});
  return box;
}

/// The terrain's rows or columns that hold the surface of a block's cells.
std::pair<int, int> pointsOf(int block, int refinement, int firstQuad) {
  const int low = block * LandBlocks::kSide, high = low + LandBlocks::kSide;
  if (refinement == 0) return {low - 1, high};
  return {firstQuad + low / refinement, firstQuad + (high - 1) / refinement + 1};
}

}  // namespace

LandBlocks::LandBlocks(const Raster<float>& heights, const TerrainGrid& terrain, const CoverGrid& cover)
    : across((cover.base.width + kSide - 1) / kSide), down((cover.base.height + kSide - 1) / kSide) {
  for (int row = 0; row < down; ++row)
    for (int column = 0; column < across; ++column) {
      const auto [i0, i1] = pointsOf(column, terrain.refinement, terrain.firstQuadI);
      const auto [j0, j1] = pointsOf(row, terrain.refinement, terrain.firstQuadJ);
      boxes.push_back(landBox(heights, i0, i1, j0, j1));
    }
}

CellMask CellMask::onLand(const SkyChange& change, double margin, const LandBlocks& blocks,
                          const BlockTile& tile, const CoverGrid& cover) {
  CellMask mask;
  mask.width = cover.base.width;
  mask.across = blocks.across;
  mask.fromRow = tile.fromRow * LandBlocks::kSide;
  mask.toRow = std::min(tile.toRow * LandBlocks::kSide, cover.base.height);
  mask.on.assign(blocks.boxes.size(), 0);
  for (int row = tile.fromRow; row < tile.toRow; ++row)
    for (int column = tile.fromColumn; column < tile.toColumn; ++column) {
      const Box3d& box = blocks.at(column, row);
      if (!change.reaches(box, margin)) continue;
      mask.on[static_cast<std::size_t>(row * blocks.across + column)] = 1;
      mask.reached.extend(box);
    }
  return mask;
}

CellMask CellMask::ofPatch(const SkyChange& change, double margin, std::size_t model, const Box3d& box,
                           const CoverGrid& cover) {
  CellMask mask;
  mask.width = cover.base.width;
  mask.toRow = cover.base.height;
  if (change.moved(model) || change.reaches(box, margin)) mask.reached = box;
  return mask;
}

}  // namespace spin
