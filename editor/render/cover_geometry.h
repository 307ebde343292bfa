// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/frame.h"

namespace spin {

/// Drawable form of a fine cover grid on the terrain. It replaces the coarse terrain inside `rectangle`;
/// towards its border its depth fades into the coarse cover's, so that the surfaces meet. Its triangles are
/// sorted into blocks, so that those out of view are not drawn.
struct FineCover {
  static constexpr int kStrides = 3;  ///< drawn at every 1st, 2nd or 4th cell
  static constexpr int kBlock = 32;   ///< cells along a block
  struct Block {
    Box3d bounds;
    std::vector<std::uint32_t> indices[kStrides];
  };
  std::vector<Vec3f> positions;  ///< bare surface at the cell centres; NaN heights become 0
  std::vector<float> own;        ///< weight of the grid's own depth against the coarse one, 0..1
  std::vector<Block> blocks;
  Vec4f rectangle{};  ///< x0, y0, x1, y1
  Box3d bounds;
};
FineCover makeFineCover(const CoverGrid& grid);
/// Per cell: drawn depth in m and its slope along x and y. `coarseDepth` has the terrain raster's shape.
std::vector<Vec3f> fineCoverSnow(const FineCover& fine, const CoverGrid& grid,
                                 const std::vector<float>& depth, const Raster<float>& coarseDepth);

/// Drawable form of a cover patch on a model: one vertex per cell and a rim half a cell further out, where
/// the surface ends and the snow has no height.
struct PatchCover {
  std::vector<Vec3f> positions;  ///< in the grid's axes
  std::vector<std::uint32_t> indices;
  std::vector<std::int32_t> cell;  ///< of the grid; -1 = rim
  std::vector<float> inset;        ///< m from the rim; large inside
  std::vector<std::int32_t> vertexOfCell;
  float cellSize = 1.0f;
};
PatchCover makePatchCover(const CoverGrid& grid);
/// Per vertex: drawn thickness in m, then the surface normal. The edge is rounded as far in as the snow is
/// thick, so that a patch ends in a curve and not in a wall.
std::vector<Vec4f> patchCoverSnow(const PatchCover& patch, const std::vector<float>& depth);
/// Appends to `out`, with `first` added, the triangles of the patch that carry snow.
void appendCovered(const PatchCover& patch, const std::vector<Vec4f>& snow, std::uint32_t first,
                   std::vector<std::uint32_t>& out);

}  // namespace spin
