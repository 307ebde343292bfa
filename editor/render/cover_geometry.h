// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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
/// Per cell: drawn depth in m, its slope along x and y, and the share of the sky's light that snow round a
/// hollow leaves it, 0.6..1; 0 where there is no surface. `coarseDepth` has the terrain raster's shape.
std::vector<Vec4f> fineCoverSnow(const FineCover& fine, const CoverGrid& grid,
                                 const std::vector<float>& depth, const Raster<float>& coarseDepth);

/// How a fine grid is drawn whose cells are so many pixels wide: at every 2^level-th cell, moved by the share
/// `morph` towards the surface of the next level, which it has reached where that takes over.
struct FineDetail {
  int level = 0;
  double morph = 0.0;
};
FineDetail fineDetail(double cellPixels);

/// Drawable form of a cover patch on a model: one vertex per cell and a rim half a cell further out, where
/// the surface ends and the snow has no height.
struct PatchCover {
  static constexpr int kBorderCells = 3;  ///< width of the border, in which the snow follows the rim
  std::vector<Vec3f> positions;           ///< in the grid's axes
  std::vector<std::uint32_t> indices;
  std::vector<std::int32_t> cell;       ///< of the grid; -1 = rim, -2 = a corner of it, beside no cell
  std::vector<std::int32_t> shownCell;  ///< the same; of a rim, one that it hangs on
  std::vector<std::int32_t> rim;        ///< nearest rim vertex within kBorderCells of a cell; -1 = none
  std::vector<float> inset;             ///< m from the rim; large inside; above 0 at joined rims
  std::vector<std::int32_t> vertexOfCell;
  float cellSize = 1.0f;
};
PatchCover makePatchCover(const CoverGrid& grid);

/// Where a rim vertex of a patch touches a cell of another patch of the same model.
struct RimContact {
  std::uint32_t vertex = 0;
  std::size_t grid = 0, cell = 0;
};
/// For each rim vertex of the patch over grid `own` the nearest cell of another grid of the same node that
/// lies level with it, both within a cell; none where nothing does, and none at corners.
std::vector<RimContact> rimContacts(const PatchCover& patch, std::size_t own,
                                    const std::vector<CoverGrid>& grids);
/// The border of a patch no longer runs along these vertices: insets and nearest rims are those of the rest.
void joinRims(PatchCover& patch, const std::vector<RimContact>& contacts);

/// Distance to the nearest border of a patch of X x Y, F1 = min(x, X - x, y, Y - y) (eq. 2.9 of [Z]): snow
/// that ends there falls towards it. For outlines of any form it is the inset.
constexpr float borderDistance(float x, float y, float X, float Y) {
  return std::min({x, X - x, y, Y - y});
}
/// The counterpart for patches whose surroundings are covered, F2 = max(x, X - x, y, Y - y) -
/// int(max(X/2, Y/2) + 0.5) (eq. 2.10), lengths in cells: least in the middle, largest at the border. On a
/// square of even cells it is X/2 - F1, the form in which it serves outlines of any form.
constexpr float bankWidth(float x, float y, float X, float Y) {
  const float half = std::max(0.5f * X, 0.5f * Y) + 0.5f;
  return std::max({x, X - x, y, Y - y}) - static_cast<float>(static_cast<int>(half));
}

/// Per vertex: drawn thickness in m, then the surface normal. Where the snow ends at the rim it is rounded
/// off as far in as it is thick, so that a patch ends in a curve and not in a wall (F1). `beside`, m, is read
/// at rims (empty = 0): where snow stands so high above a rim, the patch's snow is banked up to it (F2), so
/// that the two meet without a gap; joined rims are given that depth.
std::vector<Vec4f> patchCoverSnow(const PatchCover& patch, const std::vector<float>& depth,
                                  const std::vector<float>& beside = {});
/// Appends to `out`, with `first` added, the triangles of the patch that carry snow; with `bare`, all.
void appendCovered(const PatchCover& patch, const std::vector<Vec4f>& snow, std::uint32_t first,
                   std::vector<std::uint32_t>& out, bool bare = false);

}  // namespace spin
