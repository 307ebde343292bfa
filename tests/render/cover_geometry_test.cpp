// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/cover_geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace spin {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A level table of n x n full cells of 0.1 m at height z.
CoverGrid table(int n, float z) {
  CoverGrid grid{"t/0", "t", Raster<float>(n, n, 0.05, 0.05, 0.1, z), {}};
  grid.area = grid.base.sameShape<float>(0.01f);
  return grid;
}

TEST(PatchCover, SnowEndsAtTheEdgeOfTheSurfaceWithoutAWall) {
  const CoverGrid grid = table(12, 1.0f);
  const PatchCover patch = makePatchCover(grid);
  const auto snow = patchCoverSnow(patch, std::vector<float>(grid.base.size(), 0.2f));
  float left = 1e9f, right = -1e9f, deepest = 0.0f;
  for (std::size_t v = 0; v < snow.size(); ++v) {
    left = std::min(left, patch.positions[v].x);
    right = std::max(right, patch.positions[v].x);
    deepest = std::max(deepest, snow[v].x);
    if (patch.cell[v] < 0) {
      EXPECT_EQ(snow[v].x, 0.0f);
    }
  }
  // Full cells: the surface ends at the cells' outer borders.
  EXPECT_NEAR(left, 0.0f, 1e-5f);
  EXPECT_NEAR(right, 1.2f, 1e-5f);
  EXPECT_NEAR(deepest, 0.2f, 1e-4f);
  const auto middle = static_cast<std::size_t>(patch.vertexOfCell[grid.base.index(6, 6)]);
  EXPECT_NEAR(snow[middle].x, 0.2f, 1e-5f);
  EXPECT_NEAR(snow[middle].w, 1.0f, 1e-4f) << "level snow faces up";
}

TEST(PatchCover, HalfCoveredCellsDrawTheEdgeIn) {
  CoverGrid grid = table(8, 0.0f);
  for (int j = 0; j < 8; ++j) grid.area.at(7, j) = 0.002f;  // a fifth of the last column
  const PatchCover patch = makePatchCover(grid);
  float right = -1e9f;
  for (const Vec3f& p : patch.positions) right = std::max(right, p.x);
  EXPECT_NEAR(right, 0.72f, 1e-4f);
}

TEST(PatchCover, AStepBetweenSurfacesStaysOpen) {
  CoverGrid grid = table(10, 0.0f);
  for (int j = 0; j < 10; ++j)
    for (int i = 5; i < 10; ++i) grid.base.at(i, j) = 3.0f;
  const PatchCover patch = makePatchCover(grid);
  for (std::size_t t = 0; t < patch.indices.size(); t += 3) {
    float low = 1e9f, high = -1e9f;
    for (std::size_t k = 0; k < 3; ++k) {
      low = std::min(low, patch.positions[patch.indices[t + k]].z);
      high = std::max(high, patch.positions[patch.indices[t + k]].z);
    }
    EXPECT_LT(high - low, 1.0f);
  }
}

TEST(PatchCover, BareTrianglesAreNotDrawn) {
  const CoverGrid grid = table(12, 0.0f);
  const PatchCover patch = makePatchCover(grid);
  std::vector<float> depth(grid.base.size(), 0.0f);
  std::vector<std::uint32_t> drawn;
  appendCovered(patch, patchCoverSnow(patch, depth), 100, drawn);
  EXPECT_TRUE(drawn.empty());
  depth[grid.base.index(6, 6)] = 0.1f;
  appendCovered(patch, patchCoverSnow(patch, depth), 100, drawn);
  EXPECT_FALSE(drawn.empty());
  EXPECT_LT(drawn.size(), patch.indices.size() / 3);
  EXPECT_GE(*std::min_element(drawn.begin(), drawn.end()), 100u);
}

TEST(PatchCover, MissingCellsMakeNoSnow) {
  CoverGrid grid = table(6, 0.0f);
  for (float& z : grid.base.values) z = kNan;
  EXPECT_TRUE(makePatchCover(grid).indices.empty());
}

TEST(PatchCover, TheBorderFormulasAreThePublishedOnes) {
  // On a patch of 8 x 8 cells.
  EXPECT_FLOAT_EQ(borderDistance(0, 3, 8, 8), 0.0f);
  EXPECT_FLOAT_EQ(borderDistance(3, 7, 8, 8), 1.0f);
  EXPECT_FLOAT_EQ(borderDistance(4, 4, 8, 8), 4.0f);
  EXPECT_FLOAT_EQ(borderDistance(2, 5, 4, 10), 2.0f);
  EXPECT_FLOAT_EQ(bankWidth(4, 4, 8, 8), 0.0f);
  EXPECT_FLOAT_EQ(bankWidth(0, 4, 8, 8), 4.0f);
  EXPECT_FLOAT_EQ(bankWidth(6, 4, 8, 8), 2.0f);
  for (int x = 0; x <= 8; ++x)
    for (int y = 0; y <= 8; ++y) {
      const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
      EXPECT_FLOAT_EQ(bankWidth(fx, fy, 8, 8), 4.0f - borderDistance(fx, fy, 8, 8));
    }
}

TEST(PatchCover, TheInsetIsTheDistanceToTheBorder) {
  const CoverGrid grid = table(6, 1.0f);
  const PatchCover patch = makePatchCover(grid);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      const auto v = static_cast<std::size_t>(patch.vertexOfCell[grid.base.index(i, j)]);
      const auto x = static_cast<float>(grid.base.x(i)), y = static_cast<float>(grid.base.y(j));
      EXPECT_NEAR(patch.inset[v], borderDistance(x, y, 0.6f, 0.6f), 1e-5f) << i << ' ' << j;
    }
}

TEST(PatchCover, SnowIsBankedUpToSnowBesideIt) {
  const CoverGrid grid = table(12, 1.0f);
  const PatchCover patch = makePatchCover(grid);
  const std::vector<float> depth(grid.base.size(), 0.2f);
  // Along its left border snow stands 0.3 m above the rim; on the other sides nothing does.
  std::vector<float> beside(patch.positions.size(), 0.0f);
  for (std::size_t v = 0; v < beside.size(); ++v) beside[v] = patch.positions[v].x < 0.06f ? 0.3f : -2.0f;
  const auto snow = patchCoverSnow(patch, depth, beside);
  int left = 0;
  for (std::size_t v = 0; v < snow.size(); ++v) {
    if (patch.cell[v] >= 0) continue;
    const bool banked = patch.positions[v].x < 0.06f;
    EXPECT_NEAR(snow[v].x, banked ? 0.3f : 0.0f, 1e-6f) << "the rim meets what lies beside it";
    left += banked;
  }
  EXPECT_GE(left, 12);
  const auto at = [&](int i, int j) {
    return snow[static_cast<std::size_t>(patch.vertexOfCell[grid.base.index(i, j)])].x;
  };
  EXPECT_GT(at(0, 6), 0.25f);
  EXPECT_GT(at(0, 6), at(2, 6)) << "falls inwards";
  EXPECT_NEAR(at(5, 6), 0.2f, 1e-4f);
  EXPECT_LT(at(11, 6), 0.2f) << "tapers on the other side";
  for (int i = 1; i < 12; ++i) EXPECT_LT(std::abs(at(i, 6) - at(i - 1, 6)), 0.1f) << "no wall at " << i;
}

TEST(PatchCover, RimsFindLevelCellsOfOtherPatches) {
  // Two halves of a table, one above another table, and one of another model.
  std::vector<CoverGrid> grids{table(6, 1.0f), table(6, 1.0f), table(6, 1.3f), table(6, 1.0f)};
  grids[1].base.originX += 0.6;
  grids[2].base.originY += 0.6;
  grids[3].base.originX -= 0.6;
  grids[3].node = "u";
  const PatchCover patch = makePatchCover(grids[0]);
  const auto contacts = rimContacts(patch, 0, grids);
  ASSERT_GE(contacts.size(), 6u);
  for (const RimContact& c : contacts) {
    EXPECT_EQ(c.grid, 1u);
    EXPECT_LT(patch.cell[c.vertex], 0);
    EXPECT_NEAR(patch.positions[c.vertex].x, 0.6f, 0.06f);
    EXPECT_EQ(static_cast<int>(c.cell) % 6, 0) << "its nearest column";
  }
  grids[1].base.originX += 0.25;
  EXPECT_TRUE(rimContacts(patch, 0, grids).empty()) << "a gap wider than a cell";
}

TEST(PatchCover, SnowBesideThatIsFarHigherMakesNoWall) {
  const CoverGrid grid = table(12, 1.0f);
  const PatchCover patch = makePatchCover(grid);
  const auto snow = patchCoverSnow(patch, std::vector<float>(grid.base.size(), 0.2f),
                                   std::vector<float>(patch.positions.size(), 30.0f));
  for (const Vec4f& s : snow) EXPECT_LE(s.x, 0.7f + 1e-5f);
}

TEST(FineCover, MeetsTheCoarseCoverAtItsBorderAndIsItselfInside) {
  CoverGrid grid{"terrain/fine0", "terrain", Raster<float>(80, 80, 20.125, 20.125, 0.25, 5.0f), {}};
  Raster<float> coarse(20, 20, 0.0, 0.0, 5.0);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) coarse.at(i, j) = 0.1f + 0.01f * static_cast<float>(i);
  const FineCover fine = makeFineCover(grid);
  const auto snow = fineCoverSnow(fine, grid, std::vector<float>(grid.base.size(), 0.5f), coarse);
  for (int k = 0; k < 80; ++k) {
    const float expected = 0.1f + 0.01f * static_cast<float>(grid.base.x(k) / 5.0);
    EXPECT_NEAR(snow[grid.base.index(k, 0)].x, expected, 1e-5f);
    EXPECT_NEAR(snow[grid.base.index(k, 79)].x, expected, 1e-5f);
  }
  EXPECT_NEAR(snow[grid.base.index(40, 40)].x, 0.5f, 1e-6f);
  EXPECT_NEAR(snow[grid.base.index(40, 40)].y, 0.0f, 1e-5f);
  EXPECT_GT(snow[grid.base.index(3, 40)].y, 0.05f) << "rises from the border inwards";
}

TEST(FineCover, HollowsSeeLessOfTheSky) {
  CoverGrid grid{"terrain/fine0", "terrain", Raster<float>(60, 60, 0.0, 0.0, 0.25, 0.0f), {}};
  const Raster<float> coarse(4, 4, 0.0, 0.0, 5.0, 0.4f);
  std::vector<float> depth(grid.base.size(), 0.4f);
  for (int j = 28; j < 34; ++j)
    for (int i = 28; i < 34; ++i) depth[grid.base.index(i, j)] = 0.0f;
  const auto snow = fineCoverSnow(makeFineCover(grid), grid, depth, coarse);
  EXPECT_LT(snow[grid.base.index(30, 30)].w, 0.8f) << "in the hollow";
  EXPECT_GE(snow[grid.base.index(30, 30)].w, 0.6f);
  EXPECT_FLOAT_EQ(snow[grid.base.index(26, 30)].w, 1.0f) << "beside it";
  EXPECT_NEAR(snow[grid.base.index(50, 50)].w, 1.0f, 1e-5f) << "level";
  EXPECT_NEAR(snow[grid.base.index(0, 0)].w, 1.0f, 1e-5f) << "in the corner";
}

TEST(FineCover, LevelsTakeOverWhereTheFinerHasBecomeTheCoarser) {
  EXPECT_EQ(fineDetail(10.0).level, 0);
  EXPECT_EQ(fineDetail(10.0).morph, 0.0);
  EXPECT_EQ(fineDetail(3.0001).level, 0);
  EXPECT_NEAR(fineDetail(3.0001).morph, 1.0, 1e-3);
  EXPECT_EQ(fineDetail(2.9999).level, 1);
  EXPECT_EQ(fineDetail(2.9999).morph, 0.0) << "begins as it is";
  EXPECT_NEAR(fineDetail(1.5001).morph, 1.0, 1e-3);
  EXPECT_EQ(fineDetail(0.1).level, 2);
  EXPECT_EQ(fineDetail(0.1).morph, 0.0) << "there is no coarser level";
}

TEST(FineCover, BlocksCoverTheGridAtEveryStride) {
  CoverGrid grid{"terrain/fine0", "terrain", Raster<float>(71, 45, 0.0, 0.0, 0.25, 0.0f), {}};
  const FineCover fine = makeFineCover(grid);
  for (int s = 0; s < FineCover::kStrides; ++s) {
    double area = 0.0;
    for (const auto& block : fine.blocks)
      for (std::size_t t = 0; t < block.indices[s].size(); t += 3) {
        const Vec3f a = fine.positions[block.indices[s][t]], b = fine.positions[block.indices[s][t + 1]],
                    c = fine.positions[block.indices[s][t + 2]];
        area += 0.5 * static_cast<double>((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
      }
    EXPECT_NEAR(area, 70 * 44 * 0.0625, 1e-3);
  }
}

}  // namespace
}  // namespace spin
