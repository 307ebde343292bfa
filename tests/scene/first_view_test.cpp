// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/first_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

template <class Height>
Raster<float> ground(int side, double cell, const Height& height) {
  Raster<float> raster(side, side, 0.0, 0.0, cell);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) raster.at(i, j) = static_cast<float>(height(i * cell, j * cell));
  return raster;
}

/// Whether the middle column of the picture meets the ground at an angle above its centre, degrees.
bool meetsGround(const Raster<float>& heights, const FirstView& view, double aboveCentre) {
  const Vec3d way = normalized(view.target - view.position);
  const double flat = std::hypot(way.x, way.y);
  const double angle = std::atan2(way.z, flat) + degreesToRadians(aboveCentre);
  const Vec3d ray{std::cos(angle) * way.x / flat, std::cos(angle) * way.y / flat, std::sin(angle)};
  return TerrainSurface(heights).raycast(view.position, ray).has_value();
}

void expectGroundAndSky(const Raster<float>& heights) {
  const auto view = firstViewOf(heights);
  ASSERT_TRUE(view);
  EXPECT_TRUE(meetsGround(heights, *view, -10.0)) << "ground before the target";
  EXPECT_FALSE(meetsGround(heights, *view, 22.0)) << "sky at the upper edge";
  const TerrainSurface surface(heights);
  EXPECT_GT(view->position.z, surface.heightAt(view->position.x, view->position.y).value_or(-1e9) + 1.0);
  EXPECT_NEAR(view->target.z, surface.nearestHeight(view->target.x, view->target.y), 1e-3);
  EXPECT_LE(length(view->position - view->target),
            1.2 * std::hypot(kFarthestFirstView, 0.5 * kFarthestFirstView));
}

TEST(FirstView, ASlopeAPlainAndAValleyShowGroundAndSky) {
  expectGroundAndSky(ground(200, 5.0, [](double x, double) { return 0.7 * x; }));
  expectGroundAndSky(ground(200, 5.0, [](double, double y) { return 800.0 - 0.8 * y; }));
  expectGroundAndSky(ground(100, 1.0, [](double, double) { return 3.0; }));
  expectGroundAndSky(ground(300, 10.0, [](double x, double) { return 0.5 * std::abs(x - 1500.0); }));
}

TEST(FirstView, LooksAtTheMiddleOfWhatHasData) {
  Raster<float> heights = ground(100, 5.0, [](double x, double) { return 0.1 * x; });
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 60; ++i) heights.at(i, j) = std::nanf("");
  const auto view = firstViewOf(heights);
  ASSERT_TRUE(view);
  EXPECT_NEAR(view->target.x, 5.0 * 79.5, 5.0);
  EXPECT_NEAR(view->target.y, 5.0 * 49.5, 5.0);
}

/// Every corner of the terrain is in the picture, and the horizon above it.
TEST(FirstView, TheWholeTerrainIsSeenFromItsLowSide) {
  for (const Vec2d rise : {Vec2d{0.6, 0.0}, Vec2d{-0.3, 0.4}, Vec2d{0.0, 0.0}}) {
    const auto heights =
        ground(150, 10.0, [&](double x, double y) { return 900.0 + rise.x * x + rise.y * y; });
    const auto view = wholeViewOf(heights);
    ASSERT_TRUE(view);
    const Vec3d way = view->target - view->position;
    EXPECT_GE(way.x * rise.x + way.y * rise.y, 0.0) << "uphill";
    EXPECT_LT(radiansToDegrees(std::asin(-way.z / length(way))), 22.0) << "the horizon is in the picture";
    const Vec3d forward = normalized(way), right = normalized(cross(forward, Vec3d{0, 0, 1}));
    const Vec3d up = cross(right, forward);
    double widest = 0.0;
    for (const int i : {0, 149})
      for (const int j : {0, 149}) {
        const Vec3d p = Vec3d{heights.x(i), heights.y(j), heights.at(i, j)} - view->position;
        const double depth = dot(p, forward) * std::tan(degreesToRadians(22.5));
        ASSERT_GT(depth, 0.0);
        EXPECT_LT(std::abs(dot(p, up)) / depth, 1.0);
        EXPECT_LT(std::abs(dot(p, right)) / depth, 1.5);
        widest = std::max({widest, std::abs(dot(p, up)) / depth, std::abs(dot(p, right)) / depth / 1.5});
      }
    EXPECT_GT(widest, 0.75) << "not from farther than needed";
  }
}

TEST(FirstView, WithoutGroundThereIsNone) {
  EXPECT_FALSE(wholeViewOf(ground(4, 1.0, [](double, double) { return std::nan(""); })));
  EXPECT_FALSE(firstViewOf(ground(4, 1.0, [](double, double) { return std::nan(""); })));
}

}  // namespace
}  // namespace spin
