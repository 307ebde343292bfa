// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/fields/raster.h"

namespace spin {

/// Triangles of one terrain tile, local metres.
struct TerrainTileMesh {
  std::vector<Vec3f> vertices;
  std::vector<std::uint32_t> indices;
};

inline constexpr int kTileQuads = 32;     ///< quads along a tile's side at level 0
inline constexpr int kTerrainLevels = 6;  ///< level l draws every 2^l-th cell

/// Tiles along x and y that cover a raster.
struct TileCount {
  int x = 0, y = 0;
};
TileCount terrainTiles(const Raster<float>& heights);
/// Coarsest level that a terrain may be drawn at: 0 for those so small that they are drawn quickly as they
/// are, and would else cut through what flows in them.
int coarsestTerrainLevel(const Raster<float>& heights);

/// Meshes one tile. At level 0 it is exactly the TerrainSurface. A coarser block that touches a hole or the
/// raster's end is drawn at full resolution, its outline held to the straight edges of the coarse blocks
/// beside it, so that no crack opens inside a tile. Skirts hang from the tile's outline and close the gaps
/// between tiles of different levels, where there may be any.
TerrainTileMesh buildTerrainTile(const Raster<float>& heights, int tileX, int tileY, int level);

}  // namespace spin
