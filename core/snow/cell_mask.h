// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/snow/sky_change.h"

namespace spin {

/// Square blocks of the cells of a grid on the land and the boxes of their surface, local m.
struct LandBlocks {
  static constexpr int kSide = 16;  ///< cells along a block

  int across = 0, down = 0;
  std::vector<Box3d> boxes;

  LandBlocks(const Raster<float>& heights, const TerrainGrid& terrain, const CoverGrid& cover);
  const Box3d& at(int column, int row) const {
    return boxes[static_cast<std::size_t>(row * across + column)];
  }
};

/// A rectangle of blocks: columns and rows [from, to).
struct BlockTile {
  int fromColumn = 0, toColumn = 0, fromRow = 0, toRow = 0;
};

/// The cells of a grid whose sky may have changed, by square blocks.
struct CellMask {
  Box3d reached;               ///< local m, round all of them; empty: there are none
  int across = 0;              ///< blocks in a row; 0: all cells
  int width = 0;               ///< cells in a row
  int fromRow = 0, toRow = 0;  ///< rows of cells outside which there are none
  std::vector<std::uint8_t> on;

  /// Of a tile of a grid on the land. margin: how far beside a cell its answer looks, m.
  static CellMask onLand(const SkyChange& change, double margin, const LandBlocks& blocks,
                         const BlockTile& tile, const CoverGrid& cover);
  /// A model's patch is asked as a whole or not at all: patches are small. box: where it stands, local m.
  static CellMask ofPatch(const SkyChange& change, double margin, std::size_t model, const Box3d& box,
                          const CoverGrid& cover);

  /// In the rows that are looked at.
  std::size_t cells() const {
    return static_cast<std::size_t>(toRow - fromRow) * static_cast<std::size_t>(width);
  }
  bool covers(std::size_t cell) const {
    if (across == 0) return true;
    const auto w = static_cast<std::size_t>(width), side = static_cast<std::size_t>(LandBlocks::kSide);
    return on[cell / w / side * static_cast<std::size_t>(across) + cell % w / side] != 0;
  }
};

}  // namespace spin
