// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/fields/terrain_surface.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

Frame framesOf(const SceneSnapshot& scene, int frames) {
  SnowRun run(scene, makeBvhRayScene, 2);
  const Status status = run.run(frames);
  EXPECT_TRUE(status.ok());
  return run.frame();
}

void expectClosed(const Frame& frame) {
  const MassBudget& budget = frame.info.budget;
  EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-6);
  EXPECT_LT(std::abs(budget.get("sampling_residual")), 0.005 * std::abs(budget.get("emitted")));
}

TEST(Cover, LevelGroundGetsTheRateTimesTheTime) {
  const SceneSnapshot scene = TestScene().land(12, 9, 2.0, [](double, double) { return 5.0; }).build();
  const Frame frame = framesOf(scene, 3);
  const CoverPart& cover = test::coverOf(frame);
  const double expected = 0.002 * 300.0;
  for (std::size_t c = 0; c < cover.values[0].swe.size(); ++c) {
    EXPECT_NEAR(cover.values[0].swe[c], expected, 1e-6);
    EXPECT_NEAR(cover.values[0].depth[c], expected / 100.0, 1e-8);
    EXPECT_EQ(cover.exposure->grids[0][c], 1.0f);
  }
  // All of 22 x 16 m lies there; the air holds the rest of what came in.
  EXPECT_NEAR(frame.info.budget.get("deposited"), expected * 22 * 16, 1e-3);
  EXPECT_NEAR(frame.info.budget.get("shed"), 0.0, 1e-9);
  EXPECT_NEAR(frame.info.budget.get("left"), 0.0, 1e-6);
  expectClosed(frame);
}

TEST(Cover, FrameZeroIsBareAndItsAirIsFull) {
  const SceneSnapshot scene = TestScene().land(6, 6, 2.0, [](double, double) { return 0.0; }).build();
  const Frame frame = framesOf(scene, 0);
  EXPECT_EQ(test::massOn(test::coverOf(frame), 0), 0.0);
  // 10 x 10 x 1 m of air above the ground (1 m up to the top of the domain).
  const SizeSpectrum spectrum = makeSizeSpectrum(kUnrimedDendriteAggregate, 0.002);
  EXPECT_NEAR(frame.info.budget.get("aloft"), spectrum.massConcentration * 100.0, 1e-9);
  EXPECT_EQ(frame.info.budget.get("emitted"), frame.info.budget.get("aloft"));
}

TEST(Cover, OldSnowLiesFromTheFirstFrameOnAndIsBooked) {
  TestScene test;
  test.snowfall.oldSnowDepth = 0.8;
  test.snowfall.oldSnowDensity = 250.0;
  // Half level, half at 45 degrees, where half of the snow is shed.
  const SceneSnapshot scene =
      test.land(12, 12, 2.0, [](double x, double) { return std::max(x - 10.0, 0.0); }).build();
  for (const int frames : {0, 2}) {
    const Frame frame = framesOf(scene, frames);
    const CoverPart& cover = test::coverOf(frame);
    const double fallen = 0.2 * frames;
    const auto at = [&](int i, int j) { return static_cast<std::size_t>(12 * j + i); };
    EXPECT_NEAR(cover.values[0].swe[at(2, 6)], 200.0 + fallen, 1e-3);
    EXPECT_NEAR(cover.values[0].depth[at(2, 6)], 0.8 + fallen / 100.0, 1e-5);
    EXPECT_NEAR(cover.values[0].swe[at(9, 6)], 0.5 * (200.0 + fallen), 1e-3 * 200.0);
    const MassBudget& budget = frame.info.budget;
    EXPECT_NEAR(budget.get("fallen_before"), 200.0 * 22 * 22, 1e-2 * 200.0 * 22 * 22);
    EXPECT_NEAR(budget.get("shed"), 0.5 * (200.0 + fallen) * 12 * 22, 2e-3 * 200.0 * 22 * 22);
    EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-6);
  }
}

TEST(Cover, OldSnowIsSheltered) {
  TestScene test;
  test.snowfall.oldSnowDepth = 1.0;
  ModelNode placed;
  placed.position = {12.0, 12.0, 0.0};
  test.model("roof", test::modelOf(test::sheetMesh({-4, -4, 3}, {4, -4, 3}, {-4, 4, 3})), placed);
  const Frame frame = framesOf(test.land(13, 13, 2.0, [](double, double) { return 0.0; }).build(), 0);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_NEAR(cover.values[0].depth[13 * 6 + 6], 0.0, 1e-6);
  EXPECT_NEAR(cover.values[0].depth[13 * 1 + 1], 1.0, 1e-6);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
}

TEST(Cover, SteepPlaneShedsByTheSmoothStep) {
  const SceneSnapshot scene =
      TestScene().land(12, 12, 2.0, [](double x, double) { return x; }).build();  // 45 degrees
  const Frame frame = framesOf(scene, 1);
  const double all = 0.002 * 100.0 * 22 * 22;
  EXPECT_NEAR(frame.info.budget.get("deposited"), 0.5 * all, 1e-3 * all);
  EXPECT_NEAR(frame.info.budget.get("shed"), 0.5 * all, 1e-3 * all);
  expectClosed(frame);
}

TEST(Cover, DensityFollowsTheAirWhereNoneIsSet) {
  TestScene test;
  test.simulation.newSnowDensity = 0.0;
  test.weather.airTemperature = celsiusToKelvin(-2.59);
  const SceneSnapshot scene = test.land(4, 4, 2.0, [](double, double) { return 0.0; }).build();
  const Frame frame = framesOf(scene, 1);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_NEAR(cover.values[0].swe[5] / cover.values[0].depth[5], 67.9 + 51.3 * std::exp(-1.0), 1e-3);
}

TEST(Cover, WindWithHolesAndHillsCloses) {
  for (const double wind : {0.0, 3.0, 60.0}) {
    TestScene test;
    test.weather.windSpeed = wind;
    test.weather.windFromDegrees = 250.0;
    test.snowfall.fallSpreadDegrees = 15.0;
    test.simulation.exposureRays = 64;
    const SceneSnapshot scene = test.land(40, 30, 2.0,
                                          [](double x, double y) {
                                            if (std::hypot(x - 30, y - 30) < 9 || x + y < 14)
                                              return double(test::kHole);
                                            return 8.0 * std::sin(0.15 * x) * std::cos(0.11 * y);
                                          })
                                    .build();
    const Frame frame = framesOf(scene, 2);
    expectClosed(frame);
    EXPECT_GT(frame.info.budget.get("deposited"), 0.0);
    EXPECT_GT(frame.info.budget.get("left"), 0.0) << "snow leaves through the hole and the lee side";
    for (const double v :
         {frame.info.figures.at("residual_ground_share"), frame.info.figures.at("residual_left_share")})
      EXPECT_LT(std::abs(v), 0.01) << "wind " << wind;
  }
}

TEST(Cover, LevelGroundUnderWindGetsTheRateToo) {
  TestScene test;
  test.weather.windSpeed = 2.0;
  test.snowfall.fallSpreadDegrees = 15.0;
  const SceneSnapshot scene = test.land(8, 8, 2.0, [](double, double) { return 0.0; }).build();
  const Frame frame = framesOf(scene, 1);
  EXPECT_NEAR(frame.info.budget.get("deposited"), 0.2 * 14 * 14, 1e-4);
}

TEST(Cover, AnimatedPrecipitationFillsAndEmptiesTheAir) {
  TestScene test;
  SceneSnapshot scene = test.land(8, 8, 2.0, [](double, double) { return 0.0; }).build();
  for (SceneNode& node : scene.nodes) {
    if (node.id != "weather") continue;
    AnimationCurve& curve = node.curves["precipitation_rate_kg_m2_s"];
    curve.setKey({0.0, 0.0, Interpolation::Step});
    curve.setKey({2.0 / 24, 0.004, Interpolation::Step});
    curve.setKey({4.0 / 24, 0.0, Interpolation::Step});
  }
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.begin().ok());
  std::vector<Frame> frames{run.frame()};
  for (int f = 0; f < 6; ++f) {
    ASSERT_TRUE(run.step().ok());
    frames.push_back(run.frame());
    EXPECT_LT(std::abs(frames.back().info.budget.relativeImbalance()), 1e-6) << f;
  }
  const auto flakes = [](const Frame& f) { return test::flakesOf(f).numberDensity; };
  EXPECT_EQ(frames[1].info.budget.get("aloft"), 0.0);
  EXPECT_EQ(flakes(frames[1]), 0.0);
  EXPECT_GT(frames[3].info.budget.get("aloft"), 0.0);
  EXPECT_GT(flakes(frames[3]), 0.0);
  EXPECT_EQ(flakes(frames[5]), 0.0);
  EXPECT_EQ(frames[6].info.budget.get("aloft"), 0.0);
  // Two frames at 0.004 for 100 s each over 14 x 14 m.
  EXPECT_NEAR(frames[6].info.budget.get("deposited"), 0.8 * 196, 1e-3);
}

TEST(Cover, NoiseChangesTheShapeAndNotTheMass) {
  TestScene test;
  test.land(40, 40, 2.0, [](double, double) { return 0.0; });
  const Frame plain = framesOf(test.build(), 1);
  test.simulation.exposureNoise = 0.3;
  const Frame uneven = framesOf(test.build(), 1);
  EXPECT_NEAR(uneven.info.budget.get("deposited") / plain.info.budget.get("deposited"), 1.0, 1e-6);
  const auto& values = test::coverOf(uneven).values[0].swe;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  EXPECT_GT(*high / *low, 1.2f);
  EXPECT_GT(*low, 0.5f * 0.2f);
  expectClosed(uneven);
}

TEST(Cover, OddSmallAndEmptyTerrainsWork) {
  const auto flat = [](double, double) { return 1.0; };
  const auto hole = [](double, double) { return double(test::kHole); };
  const auto corner = [](double x, double y) { return x + y < 0.5 ? double(test::kHole) : 1.0; };
  TestScene one, empty, torn, two;
  for (const SceneSnapshot& scene : {one.land(1, 1, 5.0, flat).build(), empty.land(7, 5, 5.0, hole).build(),
                                     torn.land(2, 2, 5.0, corner).build()}) {
    const Frame frame = framesOf(scene, 2);
    EXPECT_EQ(frame.info.budget.get("deposited"), 0.0);
    EXPECT_EQ(frame.info.budget.get("emitted"), 0.0);
    EXPECT_TRUE(std::isfinite(frame.info.budget.relativeImbalance()));
    for (const float a : test::coverOf(frame).layout->grids[0].area.values) EXPECT_EQ(a, 0.0f);
  }
  const Frame frame = framesOf(two.land(2, 2, 5.0, flat).build(), 1);
  EXPECT_NEAR(frame.info.budget.get("deposited"), 0.2 * 25, 1e-5);
}

TEST(Cover, NeedsSnowfallAndSomethingToLieOn) {
  TestScene nothing, bare;
  const SceneSnapshot air = nothing.build();
  EXPECT_TRUE(fallProcessType().needed(air));
  EXPECT_FALSE(exposureProcessType().needed(air));
  EXPECT_FALSE(coverProcessType().needed(air));
  const Frame frame = framesOf(air, 2);
  EXPECT_EQ(frame.part<CoverPart>("cover"), nullptr);
  EXPECT_GT(test::flakesOf(frame).numberDensity, 0.0);
  SceneSnapshot dry = bare.land(4, 4, 1.0, [](double, double) { return 0.0; }).build();
  for (SceneNode& n : dry.nodes)
    if (n.id == "snowfall") n.enabled = false;
  EXPECT_FALSE(fallProcessType().needed(dry));
  EXPECT_FALSE(coverProcessType().needed(dry));
}

TEST(Cover, CoarseAreasAreThoseOfTheSurface) {
  TestScene test;
  const SceneSnapshot scene =
      test.land(9, 7, 3.0,
                [](double x, double y) {
                  return x > 11 && y > 8 && x < 13 ? double(test::kHole) : x * y * 0.01;
                })
          .build();
  const SnowGroundPointer ground = makeSnowGround(scene);
  const TerrainSurface surface(scene.terrain->heights);
  const CoverGrid& grid = ground->layout->grids[0];
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(grid.area.at(i, j), surface.cellArea(i, j), 1e-5);
}

}  // namespace
}  // namespace spin
