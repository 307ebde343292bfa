// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/wind_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/snow/wind_columns.h"
#include "core/snow/wind_shelter.h"
#include "tests/core/snow/cover_land.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

template <class Z>
Raster<float> land(int n, double cell, const Z& z) {
  Raster<float> heights(n, n, 0.0, 0.0, cell);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) heights.at(i, j) = static_cast<float>(z(heights.x(i), heights.y(j)));
  return heights;
}

WindField windOver(const Raster<float>& ground, const std::vector<ObstacleTops>& tops = {}, int threads = 2) {
  CpuBackend backend(threads);
  auto field = WindField::make(ground, tops, {}, backend);
  EXPECT_TRUE(field.ok());
  return std::move(*field);
}

constexpr double kL = 200.0;

double ridge(double x, double) {
  return 40.0 / (1.0 + (x - 1280.0) * (x - 1280.0) / (kL * kL));
}

TEST(WindField, LevelGroundHasTheLogProfile) {
  const WindField field = windOver(land(32, 20.0, [](double, double) { return 700.0; }));
  for (const double z : {0.05, 1.0, 7.0, 40.0, 250.0}) {
    const Vec3d wind = field.at(301.0, 77.0, z, {3.0, -4.0});
    const double profile = std::log(z / 0.01) / std::log(1000.0);
    EXPECT_NEAR(wind.x, 3.0 * profile, 1e-6);
    EXPECT_NEAR(wind.y, -4.0 * profile, 1e-6);
    EXPECT_NEAR(wind.z, 0.0, 1e-9);
  }
  EXPECT_EQ(field.at(300.0, 77.0, 0.0, {3.0, -4.0}).x, 0.0);
}

TEST(WindField, NoBoxGainsOrLosesAir) {
  const auto rough = [](double x, double y) { return 90.0 * std::sin(x / 150.0) * std::cos(y / 110.0); };
  EXPECT_LT(windOver(land(64, 20.0, rough)).divergence(), 1.1e-5);
}

TEST(WindField, TheAdjustmentBalancesEveryBoxAndClosesTheGround) {
  WindColumns g;
  g.width = 9, g.height = 7, g.layers = 5, g.cell = 10.0, g.top = 200.0;
  g.levels = {0.0, 0.05, 0.15, 0.3, 0.6, 1.0};
  for (std::size_t c = 0; c < g.columns(); ++c)
    g.ground.push_back(30.0 * std::sin(0.9 * static_cast<double>(c)));
  CpuBackend backend(2);
  WindFaces flow = levelWind(g, 0, 0.01);
  balanceWind(g, windConductances(g, 1.5), 1e-12, 5000, backend, flow);
  double largest = 0.0;
  for (int j = 0; j < g.height; ++j)
    for (int i = 0; i < g.width; ++i)
      for (int k = 0; k < g.layers; ++k) {
        const std::size_t c = g.column(i, j);
        EXPECT_NEAR(flow.x[xFace(g, i + 1, j, k)] - flow.x[xFace(g, i, j, k)] +
                        flow.y[yFace(g, i, j + 1, k)] - flow.y[yFace(g, i, j, k)] +
                        flow.z[zFace(g, c, k + 1)] - flow.z[zFace(g, c, k)],
                    0.0, 1e-6);
        EXPECT_TRUE(k > 0 || flow.z[zFace(g, c, 0)] == 0.0);
        largest = std::max(largest, std::abs(flow.y[yFace(g, i, j, k)]));
      }
  EXPECT_GT(largest, 1.0);  // it had something to do
}

TEST(WindField, CrestsSpeedTheWindUpByTheRuleOfThumb) {
  // Taylor and Lee 1984: 2 h/L on a ridge, 1.6 h/L on a round hill, at the height of the greatest speed-up.
  const WindField along = windOver(land(128, 20.0, ridge));
  const double crest = along.speedUp(1280.0, 1280.0, 2.0, {10.0, 0.0});
  EXPECT_NEAR(crest - 1.0, 2.0 * 40.0 / kL, 0.06);
  // Slower before and behind it, and along it unchanged.
  EXPECT_LT(along.speedUp(1280.0 - 3.0 * kL, 1280.0, 2.0, {10.0, 0.0}), 1.0);
  EXPECT_NEAR(along.speedUp(1280.0, 1280.0, 2.0, {0.0, 10.0}), 1.0, 0.03);
  // It climbs the windward side.
  EXPECT_GT(along.at(1280.0 - kL, 1280.0, 2.0, {10.0, 0.0}).z, 0.2);
  const WindField round = windOver(land(128, 20.0, [](double x, double y) {
    return 40.0 / (1.0 + (std::pow(x - 1280.0, 2) + std::pow(y - 1280.0, 2)) / (kL * kL));
  }));
  EXPECT_NEAR(round.speedUp(1280.0, 1280.0, 2.0, {0.0, 10.0}) - 1.0, 1.6 * 40.0 / kL, 0.05);
}

TEST(WindField, TurnsWithTheWindAndMirrorsWithTheLand) {
  const auto skewed = [](double x, double y) { return 25.0 * std::sin(x / 60.0) + 0.1 * y; };
  const WindField field = windOver(land(48, 10.0, skewed));
  const Vec3d there = field.at(200.0, 150.0, 3.0, {6.0, 2.0}),
              back = field.at(200.0, 150.0, 3.0, {-6.0, -2.0});
  EXPECT_NEAR(length(there + back), 0.0, 1e-12);
  const WindField mirrored =
      windOver(land(48, 10.0, [&](double x, double y) { return skewed(470.0 - x, y); }));
  const Vec3d other = mirrored.at(270.0, 150.0, 3.0, {-6.0, 2.0});
  EXPECT_NEAR(other.x, -there.x, 1e-4);
  EXPECT_NEAR(other.y, there.y, 1e-4);
  EXPECT_NEAR(other.z, there.z, 1e-4);
}

TEST(WindField, BlowsRoundAHouse) {
  const Raster<float> ground = land(60, 2.0, [](double, double) { return 0.0; });
  ObstacleTops tops = ground.sameShape<float>(test::kHole);
  for (int j = 27; j < 33; ++j)
    for (int i = 27; i < 33; ++i) tops.at(i, j) = 10.0f;
  const WindField field = windOver(ground, {tops});
  const Vec2d wind{8.0, 0.0};
  EXPECT_NEAR(field.speedUp(59.0, 59.0, 2.0, wind), 0.0, 0.05);  // within
  EXPECT_LT(field.speedUp(51.0, 59.0, 2.0, wind), 0.7);          // before it
  EXPECT_GT(field.speedUp(59.0, 68.0, 2.0, wind), 1.1);          // past its side
  EXPECT_GT(field.at(51.0, 66.0, 2.0, wind).y, 0.3);             // towards the sides
  EXPECT_LT(field.divergence(), 1.1e-5);
}

TEST(WindField, HolesSinglePointsAndWallsStayFinite) {
  EXPECT_FALSE([] {
    CpuBackend backend(1);
    return WindField::make(land(3, 5.0, [](double, double) { return std::nan(""); }), {}, {}, backend);
  }()
                   .ok());
  for (const Raster<float>&ground :
       {land(1, 5.0, [](double, double) { return 3.0; }),
        land(20, 5.0, [](double x, double y) { return x < 30 && y < 30 ? std::nan("") : x; }),
        land(20, 5.0, [](double x, double) { return x > 50.0 ? 200.0 : 0.0; })}) {
    const WindField field = windOver(ground);
    const Vec3d wind = field.at(40.0, 40.0, 1.5, {60.0, 0.0});
    EXPECT_TRUE(std::isfinite(wind.x) && std::isfinite(wind.y) && std::isfinite(wind.z));
  }
}

TEST(WindField, ThreadsChangeNoBit) {
  const Raster<float> ground =
      land(40, 20.0, [](double x, double y) { return 30.0 * std::sin(x / 80.0 + y / 50.0); });
  const Vec3d one = windOver(ground, {}, 1).at(333.0, 444.0, 5.0, {3.0, 5.0});
  const Vec3d five = windOver(ground, {}, 5).at(333.0, 444.0, 5.0, {3.0, 5.0});
  EXPECT_EQ(one.x, five.x);
  EXPECT_EQ(one.y, five.y);
  EXPECT_EQ(one.z, five.z);
}

/// A fence of one sheet, 2 m high, across the wind at x = 60 on level ground.
struct Fence {
  SceneSnapshot scene;
  SnowGroundPointer ground;
  CoverGraph graph;
  WindObstacles obstacles;

  Fence() {
    test::TestScene build;
    build.land(41, 25, 5.0, [](double, double) { return 0.0; });
    build.terrain.coverDetailCell = 0.5;
    build.terrain.coverDetailMargin = 40.0;
    ModelNode fence;
    fence.position = {60.0, 60.0, 0.0};
    build.model("fence", test::modelOf(test::sheetMesh({0, -15, 0}, {0, 15, 0}, {0, -15, 2})), fence);
    scene = build.build();
    ground = makeSnowGround(scene);
    const auto standing = makeSnowScene(scene, *ground, 0.0, makeBvhRayScene);
    graph = makeCoverGraph(*ground, &*standing);
    obstacles = makeWindObstacles(scene, *ground, standing->models);
  }
  /// Cell of the fine grid that a place lies in.
  std::uint32_t cellAt(double x, double y) const {
    const CoverGraph::Grid& fine = graph.grids()[1];
    const int i = static_cast<int>(std::lround((x - fine.originX) / fine.cellSize)),
              j = static_cast<int>(std::lround((y - fine.originY) / fine.cellSize));
    return fine.first + static_cast<std::uint32_t>(j * fine.width + i);
  }
};

TEST(WindShelter, AFenceShelters) {
  const Fence fence;
  CpuBackend backend(2);
  const ShelterSettings settings;
  const auto slopes = upwindSlopes(fence.graph, fence.obstacles, {1, 0}, settings, backend);
  for (const double x : {2.0, 5.0, 10.0, 20.0}) {
    const UpwindSlope& slope = slopes[fence.cellAt(60.0 + x, 60.0)];
    EXPECT_NEAR(static_cast<double>(slope.tangent), 2.0 / x, 0.13 * 2.0 / x) << x;
  }
  EXPECT_EQ(slopes[fence.cellAt(55.0, 60.0)].tangent, 0.0f);
  EXPECT_EQ(slopes[fence.cellAt(70.0, 80.0)].tangent, 0.0f);
  const UpwindSlope& near = slopes[fence.cellAt(66.0, 60.0)];
  EXPECT_EQ(shelterFactor(near, 0.0, settings), 0.0);
  EXPECT_GT(shelterFactor(near, 1.5, settings), 0.5);  // a drift fills the lee
  EXPECT_EQ(shelterFactor({}, 0.0, settings), 1.0);
  EXPECT_EQ(upwindSlopes(fence.graph, fence.obstacles, {0, 0}, settings, backend)[5].tangent, 0.0f);
}

TEST(WindShelter, PyramidsKnowTheHighest) {
  const Raster<float> heights =
      land(37, 1.0, [](double x, double y) { return x == 20 && y == 11 ? 9.0 : 0.1 * x; });
  const HeightPyramid pyramid(heights);
  EXPECT_NEAR(pyramid.highest(20.0, 12.0, 1.0), 2.0, 1e-6);
  EXPECT_EQ(pyramid.highest(21.0, 11.0, 2.5), 9.0);
  EXPECT_EQ(pyramid.highest(0.0, 0.0, 100.0), 9.0);
  EXPECT_FALSE(pyramid.covers(37.0, 0.0));
}

}  // namespace
}  // namespace spin
