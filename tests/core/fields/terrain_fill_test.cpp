// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_fill.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

template <class Z>
Raster<float> land(int w, int h, double cell, const Z& z) {
  Raster<float> heights(w, h, -0.5 * cell * (w - 1), -0.5 * cell * (h - 1), cell);
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) heights.at(i, j) = static_cast<float>(z(heights.x(i), heights.y(j)));
  return heights;
}

/// A cone whose sides stand at 35 degrees, top at (0, 0).
Raster<float> cone() {
  const double fall = std::tan(degreesToRadians(35.0));
  return land(81, 81, 5.0, [&](double x, double y) { return 200.0 - fall * std::hypot(x, y); });
}

TEST(SoftRange, FallsSmoothlyOverItsEdge) {
  SoftRange range{true, 10.0, 20.0, 4.0};
  EXPECT_EQ(range.weight(10.0), 1.0);
  EXPECT_EQ(range.weight(20.0), 1.0);
  EXPECT_DOUBLE_EQ(range.weight(8.0), 0.5);
  EXPECT_DOUBLE_EQ(range.weight(22.0), 0.5);
  EXPECT_EQ(range.weight(6.0), 0.0);
  EXPECT_EQ(range.weight(std::nan("")), 0.0);
  EXPECT_GT(range.weight(9.0), range.weight(8.5));
  range.soft = 0.0;
  EXPECT_EQ(range.weight(9.999), 0.0);
  range.on = false;
  EXPECT_EQ(range.weight(1e9), 1.0);
  EXPECT_EQ(range.weight(std::nan("")), 1.0);
}

TEST(SoftRange, OfDirectionsPassesNorth) {
  SoftRange range{true, 300.0, 60.0, 20.0};
  EXPECT_EQ(range.weightOfDirection(0.0), 1.0);
  EXPECT_EQ(range.weightOfDirection(359.9), 1.0);
  EXPECT_EQ(range.weightOfDirection(60.0), 1.0);
  EXPECT_NEAR(range.weightOfDirection(70.0), 0.5, 1e-12);
  EXPECT_NEAR(range.weightOfDirection(290.0), 0.5, 1e-12);
  EXPECT_EQ(range.weightOfDirection(180.0), 0.0);
  range = {true, -60.0, 60.0, 0.0};
  EXPECT_EQ(range.weightOfDirection(310.0), 1.0);
  EXPECT_EQ(range.weightOfDirection(61.0), 0.0);
  range = {true, 0.0, 360.0, 0.0};
  EXPECT_EQ(range.weightOfDirection(123.0), 1.0);
}

TEST(TerrainShape, OfAPlaneIsExactUpToTheRim) {
  CpuBackend backend(2);
  // Rises to the north-east, so it faces south-west.
  const Raster<float> plane = land(20, 15, 2.0, [](double x, double y) { return 0.3 * x + 0.3 * y; });
  const TerrainShape shape = terrainShape(plane, backend);
  const double slope = radiansToDegrees(std::atan(0.3 * std::sqrt(2.0)));
  for (std::size_t k = 0; k < plane.size(); ++k) {
    EXPECT_NEAR(shape.slope.values[k], slope, 1e-3);
    EXPECT_NEAR(shape.aspect.values[k], 225.0, 1e-3);
  }
}

TEST(TerrainShape, OfAConeFacesOutwards) {
  CpuBackend backend(2);
  const Raster<float> heights = cone();
  const TerrainShape shape = terrainShape(heights, backend);
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      const double x = heights.x(i), y = heights.y(j);
      if (std::hypot(x, y) < 40.0) continue;  // differences over 10 m see the tip's bend
      EXPECT_NEAR(shape.slope.at(i, j), 35.0, 0.35) << x << ' ' << y;
      double faces = radiansToDegrees(std::atan2(x, y));
      if (faces < 0.0) faces += 360.0;
      const double off = std::abs(std::remainder(static_cast<double>(shape.aspect.at(i, j)) - faces, 360.0));
      EXPECT_LT(off, 3.6) << x << ' ' << y;  // one-sided differences at the rim
    }
}

TEST(TerrainShape, HasNothingToSayOfHolesLevelGroundAndOnePoint) {
  CpuBackend backend(1);
  Raster<float> flat = land(5, 5, 1.0, [](double, double) { return 3.0; });
  flat.at(2, 2) = kNone;
  const TerrainShape shape = terrainShape(flat, backend);
  EXPECT_TRUE(std::isnan(shape.slope.at(2, 2)));
  EXPECT_EQ(shape.slope.at(1, 2), 0.0f);
  EXPECT_TRUE(std::isnan(shape.aspect.at(1, 2)));
  const Raster<float> point = land(1, 1, 1.0, [](double, double) { return 3.0; });
  EXPECT_EQ(terrainShape(point, backend).slope.at(0, 0), 0.0f);
}

TEST(FillWeights, OfAConesNorthSideBetweenTwoAltitudes) {
  CpuBackend backend(2);
  const Raster<float> heights = cone();
  FillRule rule;
  rule.altitude = {true, 1080.0, 1140.0, 10.0};
  rule.aspect = {true, 330.0, 30.0, 0.0};
  rule.slope = {true, 30.0, 40.0, 0.0};
  const Raster<float> weights = fillWeights(heights, terrainShape(heights, backend), rule, 1000.0, backend);
  double area = 0.0;
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      const double w = static_cast<double>(weights.at(i, j));
      area += w * 25.0;
      const double faces = radiansToDegrees(std::atan2(heights.x(i), heights.y(j)));
      const double z = static_cast<double>(heights.at(i, j));
      const bool outside = std::abs(faces) > 35.0 || z < 69.0 || z > 151.0;
      const bool inside = std::abs(faces) < 25.0 && z > 81.0 && z < 139.0;
      if (outside || inside) {
        EXPECT_EQ(w, inside ? 1.0 : 0.0) << i << ' ' << j;
      }
    }
  // A sixth of the ring between the radii that belong to the altitudes, half of each soft edge counted.
  const double fall = std::tan(degreesToRadians(35.0));
  const double outer = (200.0 - 75.0) / fall, inner = (200.0 - 145.0) / fall;
  const double ring = kPi * (outer * outer - inner * inner) / 6.0;
  EXPECT_NEAR(area / ring, 1.0, 0.03);
}

TEST(FillWeights, AreTheSameForAnyNumberOfThreads) {
  const Raster<float> heights = cone();
  FillRule rule;
  rule.slope = {true, 34.9, 35.0, 1.0};
  CpuBackend one(1), three(3);
  const auto a = fillWeights(heights, terrainShape(heights, one), rule, 0.0, one);
  const auto b = fillWeights(heights, terrainShape(heights, three), rule, 0.0, three);
  EXPECT_EQ(a.values, b.values);
}

Raster<float> someWeights() {
  Raster<float> weights(100, 70, 0, 0, 1.0, 0.0f);
  weights.at(1, 1) = 1.0f;
  weights.at(2, 1) = 0.25f;
  weights.at(3, 1) = 0.001f;
  return weights;
}

TEST(LayerFills, ReplaceMaxAndAdd) {
  TiledRaster<float> layer(100, 70, kNone);
  layer.set(1, 1, 3.0f);
  LayerFill fill;
  fill.value = 2.0;
  fill.base = 1.0;
  TiledRaster<float> after = filled(layer, someWeights(), fill);
  EXPECT_FLOAT_EQ(after.at(1, 1), 2.0f);
  EXPECT_FLOAT_EQ(after.at(2, 1), 1.25f);
  EXPECT_TRUE(std::isnan(after.at(3, 1)));
  EXPECT_EQ(after.tile(1), layer.tile(1));  // nothing changes there
  EXPECT_FLOAT_EQ(layer.at(1, 1), 3.0f);

  fill.combine = FillCombine::Max;
  after = filled(layer, someWeights(), fill);
  EXPECT_FLOAT_EQ(after.at(1, 1), 3.0f);
  EXPECT_FLOAT_EQ(after.at(2, 1), 1.25f);

  fill.combine = FillCombine::Add;
  fill.most = 4.5;
  after = filled(layer, someWeights(), fill);
  EXPECT_FLOAT_EQ(after.at(1, 1), 4.5f);
  EXPECT_FLOAT_EQ(after.at(2, 1), 1.5f);
}

TEST(LayerFills, ScatterNamesByWeightAndRepeat) {
  TiledRaster<std::uint8_t> layer(200, 200, 255);
  Raster<float> weights(200, 200, 0, 0, 1.0, 0.3f);
  for (int i = 0; i < 200; ++i) weights.at(i, 0) = 1.0f;
  const TiledRaster<std::uint8_t> after = filled(layer, weights, 4);
  int painted = 0;
  for (int j = 1; j < 200; ++j)
    for (int i = 0; i < 200; ++i) painted += after.at(i, j) == 4 ? 1 : 0;
  EXPECT_NEAR(painted / 39800.0, 0.3, 0.01);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(after.at(i, 0), 4);
  EXPECT_EQ(filled(layer, weights, 4), after);
}

}  // namespace
}  // namespace spin
