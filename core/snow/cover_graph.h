// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/snow/snow_scene.h"

namespace spin {

/// Sides and corners of a cell, from east against the clock; the even ones are sides.
inline constexpr std::array<std::array<int, 2>, 8> kCellSteps{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

/// A way out of a cell that does not lead to the cell beside it in its own grid: over the seam between coarse
/// and fine terrain, over the rim of a patch, out of the domain.
struct CoverLink {
  static constexpr std::uint32_t kBeyond = UINT32_MAX;     ///< out over the terrain's border or a hole's
  static constexpr std::uint32_t kFalls = UINT32_MAX - 1;  ///< off a rim into nothing
  static constexpr std::uint32_t kFirstOut = kFalls;
  static constexpr float kNoSill = -std::numeric_limits<float>::infinity();

  std::uint32_t target = kBeyond;  ///< cell
  float distance = 0.0f;           ///< m in plan, to the target's centre; to the edge where the way falls
  float sill = kNoSill;            ///< m, height of the edge in between; with kBeyond the fall of the bed, m
  float width = 0.0f;              ///< m of the cell's border
  std::uint8_t side = 0;           ///< of the cell: index into kCellSteps, even
  bool falls = false;              ///< over a rim

  bool leads() const { return target < kFirstOut; }
};

/// How all cells of a cover adjoin each other. Cells of all grids are numbered through, grid after grid; what
/// lies beside a cell in its own grid follows from the grid's shape, all other ways are links.
class CoverGraph {
 public:
  struct Grid {
    std::uint32_t first = 0;  ///< number of its first cell
    int width = 0, height = 0;
    double cellSize = 1.0;                ///< m
    double originX = 0.0, originY = 0.0;  ///< local position of the first cell's centre, m
    bool onModel = false;
  };

  std::size_t size() const { return m_bed.size(); }
  const std::vector<Grid>& grids() const { return m_grids; }
  /// Grid that a cell belongs to.
  std::size_t gridOf(std::uint32_t cell) const;
  /// m, local; NaN where there is no surface.
  float bed(std::uint32_t cell) const { return m_bed[cell]; }
  /// m2 in plan; 0 where the cell is none.
  float area(std::uint32_t cell) const { return m_area[cell]; }
  /// Bit k: there is a cell at kCellSteps[k] in the same grid. 0 for what is no cell.
  std::uint8_t neighbours(std::uint32_t cell) const { return m_neighbours[cell]; }

  struct Links {
    const CoverLink *first, *last;
    const CoverLink* begin() const { return first; }
    const CoverLink* end() const { return last; }
  };
  /// In the order of their sides.
  Links links(std::uint32_t cell) const;
  std::size_t linkCount() const { return m_links.size(); }
  std::size_t memoryBytes() const;

 private:
  friend class CoverGraphBuilder;

  std::vector<Grid> m_grids;
  std::vector<float> m_bed, m_area;
  std::vector<std::uint8_t> m_neighbours;
  std::vector<std::uint64_t> m_hasLinks;  ///< a bit a cell
  std::vector<std::uint32_t> m_linked;    ///< cells with links, ascending
  std::vector<std::uint32_t> m_start;     ///< links of m_linked[k]: [m_start[k], m_start[k + 1])
  std::vector<CoverLink> m_links;
};

/// The graph of a ground's cells where its models stand in the scene. What falls off a rim lands on the
/// uppermost cell straight below a point one cell past it, unless a wall stands there. Terrain that a model
/// stands on stays open beneath it. With a null scene every rim leads into nothing and patches lie at the
/// local origin.
CoverGraph makeCoverGraph(const SnowGround& ground, const SnowScene* scene);

}  // namespace spin
