// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/terrain_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

Raster<float> bumpy(int width, int height) {
  Raster<float> h(width, height, 100.0, 200.0, 5.0);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      h.at(i, j) = static_cast<float>(20.0 * std::sin(i * 0.9) * std::cos(j * 0.7) + i);
  return h;
}

double planArea(const TerrainTileMesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const Vec3f a = mesh.vertices[mesh.indices[t]], b = mesh.vertices[mesh.indices[t + 1]],
                c = mesh.vertices[mesh.indices[t + 2]];
    sum += 0.5 * static_cast<double>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  }
  return sum;
}

double existingArea(const Raster<float>& h, int tileX, int tileY) {
  const TerrainSurface surface(h);
  double sum = 0.0;
  for (int j = tileY * kTileQuads; j < (tileY + 1) * kTileQuads; ++j)
    for (int i = tileX * kTileQuads; i < (tileX + 1) * kTileQuads; ++i)
      if (surface.quadExists(i, j)) sum += h.cellSize * h.cellSize;
  return sum;
}

/// Vertices that lie on an edge in plan but above or below it: each would be a crack.
int vertexesOffEdges(const TerrainTileMesh& mesh) {
  int off = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3f a = mesh.vertices[mesh.indices[t + k]], b = mesh.vertices[mesh.indices[t + (k + 1) % 3]];
      const float lx = b.x - a.x, ly = b.y - a.y, squared = lx * lx + ly * ly;
      // Skirts have edges without extent in plan, and lower twins of outline vertices; both are no surface.
      if (squared < 1e-3f || a.z < -50.0f || b.z < -50.0f) continue;
      for (const Vec3f& p : mesh.vertices) {
        const float s = ((p.x - a.x) * lx + (p.y - a.y) * ly) / squared;
        const float away = std::abs((p.x - a.x) * ly - (p.y - a.y) * lx) / std::sqrt(squared);
        if (s <= 0.01f || s >= 0.99f || away > 1e-3f || p.z < -50.0f) continue;
        if (std::abs(a.z + s * (b.z - a.z) - p.z) > 1e-2f) ++off;
      }
    }
  return off;
}

TEST(TerrainMesh, FinestLevelIsTheTerrainSurface) {
  const Raster<float> h = bumpy(40, 40);
  const TerrainSurface surface(h);
  const TerrainTileMesh mesh = buildTerrainTile(h, 0, 0, 0);
  EXPECT_NEAR(planArea(mesh), existingArea(h, 0, 0), 0.1);
  int checked = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    Vec3f middle{};
    for (std::size_t k = 0; k < 3; ++k) middle += mesh.vertices[mesh.indices[t + k]];
    middle = middle / 3.0f;
    const auto z = surface.heightAt(static_cast<double>(middle.x), static_cast<double>(middle.y));
    ASSERT_TRUE(z.has_value());
    if (std::abs(*z - static_cast<double>(middle.z)) < 1e-3) ++checked;
  }
  // All but the skirts: two triangles for each of the 4 x 32 outline edges.
  EXPECT_EQ(checked, 2 * 32 * 32);
}

TEST(TerrainMesh, EveryLevelCoversWhatExistsAndNoMore) {
  Raster<float> h = bumpy(75, 60);  // the last tiles are cut off by the raster's end
  for (int j = 10; j < 14; ++j)
    for (int i = 20; i < 29; ++i) h.at(i, j) = kHole;
  const TileCount tiles = terrainTiles(h);
  EXPECT_EQ(tiles.x, 3);
  EXPECT_EQ(tiles.y, 2);
  for (int level = 0; level < kTerrainLevels; ++level)
    for (int y = 0; y < tiles.y; ++y)
      for (int x = 0; x < tiles.x; ++x)
        EXPECT_NEAR(planArea(buildTerrainTile(h, x, y, level)), existingArea(h, x, y), 0.5)
            << x << ' ' << y << ' ' << level;
}

TEST(TerrainMesh, NoVertexLeavesTheEdgeItLiesOn) {
  Raster<float> h = bumpy(33, 33);
  for (float& z : h.values) z += 100.0f;
  h.at(13, 17) = kHole;
  h.at(2, 30) = kHole;
  for (int level = 1; level <= 4; ++level) {
    TerrainTileMesh mesh = buildTerrainTile(h, 0, 0, level);
    // Skirts hang below; mark their lower vertices by sinking them out of sight.
    const float lowest = valueRange(h).x > 0 ? static_cast<float>(valueRange(h).x) : 0.0f;
    for (Vec3f& p : mesh.vertices) {
      const int i = h.column(static_cast<double>(p.x)), j = h.row(static_cast<double>(p.y));
      const bool outline = i == 0 || j == 0 || i == 32 || j == 32;
      if (outline && p.z < lowest) p.z = -100.0f;
    }
    std::size_t skirts = 0;
    for (const Vec3f& p : mesh.vertices) skirts += p.z < -50.0f;
    EXPECT_EQ(vertexesOffEdges(mesh), 0) << "level " << level << ", skirts sunk " << skirts;
  }
}

TEST(TerrainMesh, NothingHangsFromTheRim) {
  Raster<float> h(65, 160, 0.0, 0.0, 1.0);
  ASSERT_GT(coarsestTerrainLevel(h), 0);
  const auto lowest = [&](int tile, int level) {
    float low = 0.0f;
    for (const Vec3f& p : buildTerrainTile(h, tile, 0, level).vertices) low = std::min(low, p.z);
    return low;
  };
  // Level ground of two by five tiles: skirts hang at the seams between them alone.
  const auto hanging = [&](int tile, int level) {
    std::size_t count = 0;
    for (const Vec3f& p : buildTerrainTile(h, tile, 0, level).vertices)
      count += p.z < 0.0f && p.x != 32.0f && p.y != 32.0f;
    return count;
  };
  for (const int level : {0, 2, 4})
    for (const int tile : {0, 1}) {
      EXPECT_EQ(hanging(tile, level), 0u) << tile << ' ' << level;
      EXPECT_LT(lowest(tile, level), 0.0f) << "the seam is closed";
    }
  for (int j = 0; j < 160; ++j)
    for (int i = 0; i < 65; ++i)
      if (i > 32 || j > 32) h.at(i, j) = kHole;
  EXPECT_EQ(lowest(0, 2), 0.0f) << "beside a hole there is no seam";
  const Raster<float> small(65, 33, 0.0, 0.0, 1.0);
  EXPECT_EQ(coarsestTerrainLevel(small), 0) << "all its tiles are of one level";
  for (const Vec3f& p : buildTerrainTile(small, 0, 0, 0).vertices) EXPECT_EQ(p.z, 0.0f);
}

TEST(TerrainMesh, CoarserLevelsAreCheaper) {
  const Raster<float> h = bumpy(33, 33);
  std::size_t before = std::numeric_limits<std::size_t>::max();
  for (int level = 0; level < kTerrainLevels; ++level) {
    const std::size_t now = buildTerrainTile(h, 0, 0, level).indices.size();
    EXPECT_LT(now, before);
    before = now;
  }
}

}  // namespace
}  // namespace spin
