// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_surface.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/random.h"

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

TEST(TerrainSurfaceTest, NearlyVerticalRaysHit) {
  const Raster<float> level(128, 128, 0, 0, 5, 0.0f);
  const TerrainSurface surface(level);
  for (const double tilt : {0.0, 1e-15, 1e-9, 1e-4, 1e-3, 2e-3, 3e-3, 1e-2})
    for (const Vec3d from : {Vec3d{320, 320, 300}, Vec3d{321.3, 318.7, 300}}) {
      const auto hit = surface.raycast(from, {tilt, -0.5 * tilt, -1});
      ASSERT_TRUE(hit) << tilt;
      EXPECT_NEAR(hit->x, from.x + 300 * tilt, 1e-6);
      EXPECT_NEAR(hit->z, 0.0, 1e-6);
    }
}

TEST(TerrainSurfaceTest, NarrowRidgesAreNotSkipped) {
  Raster<float> ridge(64, 64, 0, 0, 5, 0.0f);
  for (int j = 0; j < 64; ++j) ridge.at(30, j) = 1.0f;
  const TerrainSurface surface(ridge);
  for (int k = 0; k < 50; ++k) {
    const auto hit = surface.raycast({10.0 + 0.37 * k, 150.0 + 0.1 * k, 0.95}, {1, 0.01 * (k % 5), 0});
    ASSERT_TRUE(hit) << k;
    EXPECT_NEAR(hit->x, 149.75, 1e-6);
  }
}

/// Rays through random points of rough ground, from all sides and from outside the raster, stop at the
/// surface and never beyond the point they are aimed at; what they hit first, a search in small steps hits
/// too.
TEST(TerrainSurfaceTest, RaysThroughRoughGroundStopAtTheFirstTriangle) {
  Raster<float> rough(40, 40, 0, 0, 2, 0.0f);
  const CounterRandom random{7, 3};
  for (std::size_t c = 0; c < rough.size(); ++c)
    rough.values[c] = static_cast<float>(6.0 * random.uniformDouble(c));
  rough.at(12, 17) = kHole;
  const TerrainSurface surface(rough);
  int hits = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    const CounterRandom own{k, 5};
    const Vec3d aim{78.0 * own.uniformDouble(0), 78.0 * own.uniformDouble(1), 0.0};
    const auto z = surface.heightAt(aim.x, aim.y);
    if (!z) continue;
    const Vec3d target{aim.x, aim.y, *z};
    const Vec3d from{200.0 * own.uniformDouble(2) - 60.0, 200.0 * own.uniformDouble(3) - 60.0,
                     8.0 + 60.0 * own.uniformDouble(4)};
    const auto hit = surface.raycast(from, target - from);
    ASSERT_TRUE(hit) << k;
    ++hits;
    const double reach = length(*hit - from);
    EXPECT_LE(reach, length(target - from) + 1e-6) << k;
    const auto under = surface.heightAt(hit->x, hit->y);
    ASSERT_TRUE(under) << k;
    EXPECT_NEAR(hit->z, *under, 1e-6) << k;
    // Under the rim or through the hole a ray may come from below: until the hit it stays on its side.
    const Vec3d step = normalized(target - from) * 0.01;
    int side = 0;
    for (Vec3d p = from; length(p - from) < reach - 0.02; p = p + step) {
      const auto ground = surface.heightAt(p.x, p.y);
      const int now = !ground ? 0 : p.z > *ground ? 1 : -1;
      ASSERT_NE(now * side, -1) << k;
      side = now;
    }
  }
  EXPECT_GT(hits, 300);
}

TEST(TerrainSurfaceTest, RayThatMissesHitsNothing) {
  const Raster<float> raster = plane();
  const TerrainSurface surface(raster);
  EXPECT_FALSE(surface.raycast({90, 195, 500}, {1, 1, 0}));
  EXPECT_FALSE(surface.raycast({90, 195, 500}, {-1, -1, -1}));
}

TEST(TerrainSurfaceTest, NearestHeightGoesOnBeyondTheRimAndInHoles) {
  Raster<float> raster = plane();
  raster.at(2, 1) = kHole;
  const TerrainSurface surface(raster);
  EXPECT_EQ(surface.nearestHeight(103, 204), *surface.heightAt(103, 204));
  EXPECT_NEAR(surface.nearestHeight(140.001, 210), planeHeight(140, 210), 1e-4);
  EXPECT_NEAR(surface.nearestHeight(90, 150), planeHeight(100, 200), 1e-4);
  EXPECT_NEAR(surface.nearestHeight(119, 211), planeHeight(120, 220), 11.0) << "a neighbour of the hole";
  EXPECT_EQ(TerrainSurface(Raster<float>(2, 2, 0, 0, 1, kHole)).nearestHeight(0, 0), 0.0);
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
