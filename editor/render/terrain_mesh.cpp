// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/terrain_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

constexpr std::size_t kFewQuads = 8192;

class TileBuilder {
 public:
  TileBuilder(const Raster<float>& heights, int tileX, int tileY, int level)
      : m_heights(heights),
        m_surface(heights),
        m_i0(tileX * kTileQuads),
        m_j0(tileY * kTileQuads),
        m_stride(1 << level),
        m_coarsest(coarsestTerrainLevel(heights)) {
    m_known.fill(-1);
  }

  TerrainTileMesh build() {
    for (int j = m_j0; j < m_j0 + kTileQuads; j += m_stride)
      for (int i = m_i0; i < m_i0 + kTileQuads; i += m_stride) addBlock(i, j);
    return std::move(m_mesh);
  }

 private:
  bool complete(int i, int j) const {
    for (int b = j; b < j + m_stride; ++b)
      for (int a = i; a < i + m_stride; ++a)
        if (!m_surface.quadExists(a, b)) return false;
    return true;
  }

  void addBlock(int i, int j) {
    if (complete(i, j)) return addQuad(i, j, m_stride);
    for (int b = j; b < j + m_stride; ++b)
      for (int a = i; a < i + m_stride; ++a)
        if (m_surface.quadExists(a, b)) addQuad(a, b, 1);
  }

  void addQuad(int i, int j, int s) {
    const auto v00 = vertex(i, j), v10 = vertex(i + s, j), v01 = vertex(i, j + s), v11 = vertex(i + s, j + s);
    for (const std::uint32_t v : {v00, v10, v11, v00, v11, v01}) m_mesh.indices.push_back(v);
    if (i == m_i0 && goesOn(i - 1, j, 0, 1, s)) addSkirt(v00, v01);
    if (j == m_j0 && goesOn(i, j - 1, 1, 0, s)) addSkirt(v00, v10);
    if (i + s == m_i0 + kTileQuads && goesOn(i + s, j, 0, 1, s)) addSkirt(v10, v11);
    if (j + s == m_j0 + kTileQuads && goesOn(i, j + s, 1, 0, s)) addSkirt(v01, v11);
  }

  /// Whether there is ground across a side, to which a gap could open: at the rim a skirt would hang as a
  /// curtain.
  bool goesOn(int i, int j, int di, int dj, int count) const {
    if (m_coarsest == 0) return false;
    for (int k = 0; k < count; ++k)
      if (m_surface.quadExists(i + k * di, j + k * dj)) return true;
    return false;
  }

  void addSkirt(std::uint32_t a, std::uint32_t b) {
    const float depth = static_cast<float>(m_heights.cellSize * m_stride);
    const auto low = static_cast<std::uint32_t>(m_mesh.vertices.size());
    for (const std::uint32_t v : {a, b}) {
      Vec3f p = m_mesh.vertices[v];
      p.z -= depth;
      m_mesh.vertices.push_back(p);
    }
    for (const std::uint32_t v : {a, b, low, low, b, low + 1}) m_mesh.indices.push_back(v);
  }

  std::uint32_t vertex(int i, int j) {
    int& known = m_known[static_cast<std::size_t>((j - m_j0) * (kTileQuads + 1) + i - m_i0)];
    if (known < 0) {
      known = static_cast<int>(m_mesh.vertices.size());
      m_mesh.vertices.push_back(
          {static_cast<float>(m_heights.x(i)), static_cast<float>(m_heights.y(j)), heightOf(i, j)});
    }
    return static_cast<std::uint32_t>(known);
  }

  /// On the outline of a block: the straight line between the block's corners where both exist.
  float heightOf(int i, int j) const {
    const int s = m_stride, iLow = i - i % s, jLow = j - j % s;
    if (i != iLow && j == jLow) return between(i, j, iLow, j, iLow + s, j, i - iLow);
    if (j != jLow && i == iLow) return between(i, j, i, jLow, i, jLow + s, j - jLow);
    return m_heights.at(i, j);
  }

  float between(int i, int j, int ia, int ja, int ib, int jb, int offset) const {
    if (!m_heights.contains(ib, jb)) return m_heights.at(i, j);
    const float a = m_heights.at(ia, ja), b = m_heights.at(ib, jb);
    if (std::isnan(a) || std::isnan(b)) return m_heights.at(i, j);
    return a + (b - a) * static_cast<float>(offset) / static_cast<float>(m_stride);
  }

  const Raster<float>& m_heights;
  TerrainSurface m_surface;
  int m_i0, m_j0, m_stride, m_coarsest;
  std::array<int, (kTileQuads + 1) * (kTileQuads + 1)> m_known{};
  TerrainTileMesh m_mesh;
};

}  // namespace

TileCount terrainTiles(const Raster<float>& heights) {
  const auto tiles = [](int cells) { return cells < 2 ? 0 : (cells - 2) / kTileQuads + 1; };
  return {tiles(heights.width), tiles(heights.height)};
}

int coarsestTerrainLevel(const Raster<float>& heights) {
  int level = 0;
  while (level + 1 < kTerrainLevels && heights.size() >> (2 * level) > kFewQuads) ++level;
  return level;
}

TerrainTileMesh buildTerrainTile(const Raster<float>& heights, int tileX, int tileY, int level) {
  return TileBuilder(heights, tileX, tileY, level).build();
}

}  // namespace spin
