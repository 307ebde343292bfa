// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cover_graph.h"

#include <algorithm>
#include <cmath>

#include "core/snow/cover_graph_builder.h"

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::uint8_t opposite(std::uint8_t side) {
  return static_cast<std::uint8_t>((side + 4) % 8);
}

}  // namespace

std::size_t CoverGraph::gridOf(std::uint32_t cell) const {
  const auto after = std::upper_bound(m_grids.begin(), m_grids.end(), cell,
                                      [](std::uint32_t c, const Grid& grid) { return c < grid.first; });
  // Grids without cells share their number with the next one.
  return static_cast<std::size_t>(after - m_grids.begin()) - 1;
}

CoverGraph::Links CoverGraph::links(std::uint32_t cell) const {
  if (!(m_hasLinks[cell / 64] >> (cell % 64) & 1)) return {nullptr, nullptr};
  const auto at =
      static_cast<std::size_t>(std::lower_bound(m_linked.begin(), m_linked.end(), cell) - m_linked.begin());
  return {m_links.data() + m_start[at], m_links.data() + m_start[at + 1]};
}

std::size_t CoverGraph::memoryBytes() const {
  return m_bed.size() * 4 + m_area.size() * 4 + m_neighbours.size() + m_hasLinks.size() * 8 +
         m_linked.size() * 4 + m_start.size() * 4 + m_links.size() * sizeof(CoverLink);
}

void CoverGraphBuilder::addGrid(const CoverGrid& cover, Vec3d position, bool onModel) {
  const Raster<float>& base = cover.base;
  CoverGraph::Grid grid;
  grid.first = static_cast<std::uint32_t>(m_graph.m_bed.size());
  grid.width = base.width, grid.height = base.height;
  grid.cellSize = base.cellSize;
  grid.originX = base.originX + position.x, grid.originY = base.originY + position.y;
  grid.onModel = onModel;
  m_graph.m_grids.push_back(grid);
  for (std::size_t c = 0; c < base.size(); ++c) {
    const bool none = !(cover.area.values[c] > 0.0f) || !std::isfinite(base.values[c]);
    m_graph.m_bed.push_back(none ? kNan
                                 : static_cast<float>(static_cast<double>(base.values[c]) + position.z));
    m_graph.m_area.push_back(none ? 0.0f : cover.area.values[c]);
  }
  m_graph.m_neighbours.resize(m_graph.m_bed.size(), 0);
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i) {
      if (!isCell(grid, i, j)) continue;
      std::uint8_t mask = 0;
      for (std::size_t k = 0; k < 8; ++k)
        if (isCell(grid, i + kCellSteps[k][0], j + kCellSteps[k][1]))
          mask = static_cast<std::uint8_t>(mask | 1u << k);
      m_graph.m_neighbours[numberOf(grid, i, j)] = mask;
    }
}

bool CoverGraphBuilder::isCell(const CoverGraph::Grid& grid, int i, int j) const {
  return i >= 0 && j >= 0 && i < grid.width && j < grid.height && m_graph.m_area[numberOf(grid, i, j)] > 0.0f;
}

float CoverGraphBuilder::fallTowards(const CoverGraph::Grid& grid, int i, int j, std::uint8_t side) const {
  const int oi = i - kCellSteps[side][0], oj = j - kCellSteps[side][1];
  if (!isCell(grid, oi, oj)) return 0.0f;
  return m_graph.m_bed[numberOf(grid, oi, oj)] - m_graph.m_bed[numberOf(grid, i, j)];
}

void CoverGraphBuilder::joinSeam(std::uint32_t fine, std::uint32_t coarse, std::uint8_t side, double distance,
                                 double width) {
  CoverLink link;
  link.target = coarse;
  link.distance = static_cast<float>(distance);
  link.width = static_cast<float>(width);
  link.side = side;
  addLink(fine, link);
  link.target = fine;
  link.side = opposite(side);
  addLink(coarse, link);
}

/// Seams of one fine grid: each of its border cells adjoins the coarse cell whose point on the block's border
/// is nearest.
void CoverGraphBuilder::joinFineGrid(const CoverGraph::Grid& coarse, const CoverGraph::Grid& fine) {
  const auto visit = [&](int i, int j, std::uint8_t side) {
    if (!isCell(fine, i, j)) return;
    const double x = fine.originX + i * fine.cellSize, y = fine.originY + j * fine.cellSize;
    const double bx = x + 0.5 * kCellSteps[side][0] * fine.cellSize,
                 by = y + 0.5 * kCellSteps[side][1] * fine.cellSize;
    const int ci = static_cast<int>(std::lround((bx - coarse.originX) / coarse.cellSize)),
              cj = static_cast<int>(std::lround((by - coarse.originY) / coarse.cellSize));
    const std::uint32_t cell = numberOf(fine, i, j);
    if (!isCell(coarse, ci, cj)) return addBorder(fine, i, j, side);
    const double cx = coarse.originX + ci * coarse.cellSize, cy = coarse.originY + cj * coarse.cellSize;
    joinSeam(cell, numberOf(coarse, ci, cj), side, std::hypot(cx - x, cy - y), fine.cellSize);
  };
  for (int j = 0; j < fine.height; ++j) visit(fine.width - 1, j, 0), visit(0, j, 4);
  for (int i = 0; i < fine.width; ++i) visit(i, fine.height - 1, 2), visit(i, 0, 6);
}

void CoverGraphBuilder::addBorder(const CoverGraph::Grid& grid, int i, int j, std::uint8_t side) {
  CoverLink link;
  link.target = CoverLink::kBeyond;
  link.distance = link.width = static_cast<float>(grid.cellSize);
  link.sill = fallTowards(grid, i, j, side);
  link.side = side;
  addLink(numberOf(grid, i, j), link);
}

/// Sides of terrain cells past which there is neither terrain of the same grid nor another grid's.
void CoverGraphBuilder::addBorders(const CoverGraph::Grid& grid, const Raster<float>& base, bool fine) {
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i) {
      if (!isCell(grid, i, j)) continue;
      for (std::uint8_t side = 0; side < 8; side = static_cast<std::uint8_t>(side + 2)) {
        const int ni = i + kCellSteps[side][0], nj = j + kCellSteps[side][1];
        if (isCell(grid, ni, nj)) continue;
        // Past a fine grid's outer side lies coarse terrain, which joinFineGrid() has looked for; a coarse
        // point with a height and no area lies inside a fine grid.
        const bool inside = base.contains(ni, nj);
        if (fine ? inside : !inside || std::isnan(base.at(ni, nj))) addBorder(grid, i, j, side);
      }
    }
}

CoverGraph CoverGraphBuilder::take() {
  std::stable_sort(m_raw.begin(), m_raw.end(), [](const RawLink& a, const RawLink& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.link.side < b.link.side;
  });
  m_graph.m_hasLinks.assign(m_graph.size() / 64 + 1, 0);
  for (const RawLink& raw : m_raw) {
    if (m_graph.m_linked.empty() || m_graph.m_linked.back() != raw.cell) {
      m_graph.m_linked.push_back(raw.cell);
      m_graph.m_start.push_back(static_cast<std::uint32_t>(m_graph.m_links.size()));
      m_graph.m_hasLinks[raw.cell / 64] |= std::uint64_t{1} << (raw.cell % 64);
    }
    m_graph.m_links.push_back(raw.link);
  }
  m_graph.m_start.push_back(static_cast<std::uint32_t>(m_graph.m_links.size()));
  return std::move(m_graph);
}

CoverGraph makeCoverGraph(const SnowGround& ground, const SnowScene* scene) {
  const std::vector<CoverGrid>& grids = ground.layout->grids;
  std::vector<Vec3d> positions(grids.size());
  std::vector<char> onModel(grids.size(), 0);
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (const ModelPatch& patch : ground.models[m].patches) {
      onModel[patch.grid] = 1;
      if (scene) positions[patch.grid] = scene->models[m].placement.translation;
    }
  CoverGraphBuilder builder;
  for (std::size_t g = 0; g < grids.size(); ++g) builder.addGrid(grids[g], positions[g], onModel[g] != 0);
  for (const TerrainGrid& terrain : ground.terrain) {
    const bool fine = terrain.refinement > 0;
    if (fine) builder.joinFineGrid(builder.grid(ground.terrain[0].grid), builder.grid(terrain.grid));
    builder.addBorders(builder.grid(terrain.grid), grids[terrain.grid].base, fine);
  }
  addRims(ground, scene, builder);
  return builder.take();
}

}  // namespace spin
