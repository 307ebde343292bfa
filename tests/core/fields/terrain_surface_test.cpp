// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_surface.h"

#include <gtest/gtest.h>

#include <limits>

namespace spin {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

/// Plane z = 2 + x/2 - y/4 over 5 x 4 cells of 10 m, first cell at (100, 200).
Raster<float> plane() {
  Raster<float> raster(5, 4, 100.0, 200.0, 10.0);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i)
      raster.at(i, j) = static_cast<float>(2 + 0.5 * raster.x(i) - 0.25 * raster.y(j));
  return raster;
}

double planeHeight(double x, double y) {
  return 2 + 0.5 * x - 0.25 * y;
}

TEST(TerrainSurfaceTest, PlaneIsReproducedEverywhere) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  for (double x = 100; x <= 140; x += 2.5)
    for (double y = 200; y <= 230; y += 2.5) {
      const auto z = surface.heightAt(x, y);
      ASSERT_TRUE(z) << x << " " << y;
      EXPECT_NEAR(*z, planeHeight(x, y), 1e-5);
    }
  const Vec3d n = surface.normalAt(111, 222), expected = normalized(Vec3d{-0.5, 0.25, 1});
  EXPECT_LT(length(n - expected), 1e-6);
}

TEST(TerrainSurfaceTest, NothingOutside) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  EXPECT_FALSE(surface.heightAt(99.9, 210));
  EXPECT_FALSE(surface.heightAt(140.1, 210));
  EXPECT_FALSE(surface.heightAt(120, 230.1));
  EXPECT_FALSE(surface.heightAt(std::numeric_limits<double>::quiet_NaN(), 210));
  EXPECT_EQ(surface.normalAt(0, 0), (Vec3d{0, 0, 1}));
}

TEST(TerrainSurfaceTest, QuadIsCutAlongItsRisingDiagonal) {
  Raster<float> raster(2, 2, 0, 0, 1);
  raster.at(1, 1) = 1.0f;
  const TerrainSurface surface(raster);
  // The cut runs from (0, 0) to (1, 1): on it the height rises evenly, and the other corners stay low.
  EXPECT_NEAR(*surface.heightAt(0.5, 0.5), 0.5, 1e-6);
  EXPECT_NEAR(*surface.heightAt(0.75, 0.25), 0.25, 1e-6);
  EXPECT_NEAR(*surface.heightAt(0.25, 0.75), 0.25, 1e-6);
  raster.at(1, 1) = 0.0f;
  raster.at(1, 0) = 1.0f;
  EXPECT_NEAR(*surface.heightAt(0.5, 0.5), 0.0, 1e-6);
}

TEST(TerrainSurfaceTest, AHoleTakesItsFourQuads) {
  Raster<float> raster = plane();
  raster.at(2, 2) = kHole;
  const TerrainSurface surface(raster);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(surface.quadExists(i, j), !((i == 1 || i == 2) && (j == 1 || j == 2)));
  EXPECT_FALSE(surface.quadExists(4, 0));
  EXPECT_FALSE(surface.quadExists(-1, 0));
  EXPECT_FALSE(surface.heightAt(119, 219));
  EXPECT_TRUE(surface.heightAt(105, 205));
}

TEST(TerrainSurfaceTest, CellAreasAddUpToTheSurface) {
  Raster<float> raster = plane();
  raster.at(4, 3) = kHole;
  const TerrainSurface surface(raster);
  double area = 0.0;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i) area += surface.cellArea(i, j);
  EXPECT_DOUBLE_EQ(area, 11 * 100.0);
  EXPECT_DOUBLE_EQ(surface.cellArea(1, 1), 100.0);
  EXPECT_DOUBLE_EQ(surface.cellArea(0, 0), 25.0);
  EXPECT_DOUBLE_EQ(surface.cellArea(4, 3), 0.0);
}

TEST(TerrainSurfaceTest, RayHitsWhereItCrossesThePlane) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  const Vec3d from{90, 195, 80}, through{121, 214, planeHeight(121, 214)};
  const auto hit = surface.raycast(from, through - from);
  ASSERT_TRUE(hit);
  EXPECT_LT(length(*hit - through), 1e-3);
}

TEST(TerrainSurfaceTest, VerticalRaysHitOnlyTowardsTheSurface) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  const auto down = surface.raycast({121, 214, 500}, {0, 0, -1});
  ASSERT_TRUE(down);
  EXPECT_NEAR(down->z, planeHeight(121, 214), 1e-4);
  EXPECT_FALSE(surface.raycast({121, 214, 500}, {0, 0, 1}));
  EXPECT_FALSE(surface.raycast({0, 0, 500}, {0, 0, -1}));
}

TEST(TerrainSurfaceTest, RayThatMissesHitsNothing) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  EXPECT_FALSE(surface.raycast({90, 195, 500}, {1, 1, 0}));
  EXPECT_FALSE(surface.raycast({90, 195, 500}, {-1, -1, -1}));
}

TEST(TerrainSurfaceTest, RangeAndBoundsPassOverHoles) {
  Raster<float> raster = plane();
  raster.at(0, 0) = kHole;
  const Vec2d range = valueRange(raster);
  EXPECT_NEAR(range.x, planeHeight(100, 230), 1e-5);
  EXPECT_NEAR(range.y, planeHeight(140, 200), 1e-5);
  const Box3d box = boundsOf(raster);
  EXPECT_EQ(box.min.x, 100.0);
  EXPECT_EQ(box.max.y, 230.0);
  Raster<float> empty(2, 2, 0, 0, 1, kHole);
  EXPECT_EQ(valueRange(empty), Vec2d{});
  EXPECT_TRUE(boundsOf(empty).empty());
}

}  // namespace
}  // namespace spin
