// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/snow/cover_graph.h"

namespace spin {

/// Puts a cover's graph together: all grids first, then the links.
class CoverGraphBuilder {
 public:
  /// position: of the grid's node, m; heights become local.
  void addGrid(const CoverGrid& cover, Vec3d position, bool onModel);
  const CoverGraph::Grid& grid(std::size_t g) const { return m_graph.m_grids[g]; }
  const CoverGraph& graph() const { return m_graph; }  ///< without links
  bool isCell(const CoverGraph::Grid& grid, int i, int j) const;
  static std::uint32_t numberOf(const CoverGraph::Grid& grid, int i, int j) {
    return grid.first + static_cast<std::uint32_t>(j) * static_cast<std::uint32_t>(grid.width) +
           static_cast<std::uint32_t>(i);
  }
  /// How much the bed falls over one cell towards a side, continued from the cell on the other side, m; 0
  /// where there is none.
  float fallTowards(const CoverGraph::Grid& grid, int i, int j, std::uint8_t side) const;

  void joinFineGrid(const CoverGraph::Grid& coarse, const CoverGraph::Grid& fine);
  void addBorders(const CoverGraph::Grid& grid, const Raster<float>& base, bool fine);
  void addLink(std::uint32_t cell, const CoverLink& link) { m_raw.push_back({cell, link}); }

  CoverGraph take();

 private:
  struct RawLink {
    std::uint32_t cell;
    CoverLink link;
  };

  void joinSeam(std::uint32_t fine, std::uint32_t coarse, std::uint8_t side, double distance, double width);
  void addBorder(const CoverGraph::Grid& grid, int i, int j, std::uint8_t side);

  CoverGraph m_graph;
  std::vector<RawLink> m_raw;
};

/// Adds the ways over the rims of models' patches.
void addRims(const SnowGround& ground, const SnowScene* scene, CoverGraphBuilder& builder);

}  // namespace spin
