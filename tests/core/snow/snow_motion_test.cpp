// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/core/snow/cover_land.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

/// A fence across a west wind on a plain with an even cover.
struct Plain {
  SceneSnapshot scene;
  SnowGroundPointer ground;
  SnowMotion motion;
  std::vector<double> depth, mass;

  explicit Plain(double wind) {
    TestScene build;
    build.land(61, 25, 5.0, [](double, double) { return 0.0; });
    build.terrain.coverDetailCell = 0.5;
    build.terrain.coverDetailMargin = 40.0;
    build.weather.windSpeed = wind;
    build.weather.windFromDegrees = 270.0;
    build.weather.airTemperature = 268.0;
    build.simulation.snowSlides = build.simulation.snowDrifts = true;
    ModelNode fence;
    fence.position = {150.0, 60.0, 0.0};
    build.model("fence", test::modelOf(test::sheetMesh({0, -20, 0}, {0, 20, 0}, {0, -20, 2})), fence);
    scene = build.build();
    ground = makeSnowGround(scene);
    motion.place(ground, std::make_shared<SnowScene>(*makeSnowScene(scene, *ground, 0.0, makeBvhRayScene)));
    depth.assign(motion.graph().size(), 0.0);
    mass = depth;
    for (std::uint32_t c = 0; c < depth.size(); ++c)
      if (motion.graph().area(c) > 0.0f) depth[c] = 0.4, mass[c] = 60.0;
  }
  MotionTotals step(double seconds, int threads = 2) {
    CpuBackend backend(threads);
    MovingSnow snow;
    snow.carried = {depth.data(), mass.data()};
    return motion.step(scene, motionSettings(scene, 0.0), seconds, snow, backend);
  }
  std::size_t cellAt(double x, double y) {
    const CoverGraph::Grid& fine = motion.graph().grids()[1];
    return fine.first +
           static_cast<std::size_t>(std::lround((y - fine.originY) / fine.cellSize) * fine.width +
                                    std::lround((x - fine.originX) / fine.cellSize));
  }
};

TEST(SnowMotion, ADriftGrowsBehindAFenceAndMassCloses) {
  Plain plain(13.0);
  double total = test::sumOver(plain.motion.graph(), plain.mass);
  for (int hour = 0; hour < 6; ++hour) {
    const MotionTotals totals = plain.step(3600.0);
    const double now = test::sumOver(plain.motion.graph(), plain.mass);
    EXPECT_NEAR(now, total + totals.net(1), 1e-9 * total);
    EXPECT_GT(totals.blownIn[1], 0.0);
    total = now;
  }
  EXPECT_GT(plain.depth[plain.cellAt(158.0, 60.0)], 0.6);
  EXPECT_NEAR(plain.depth[plain.cellAt(140.0, 60.0)], 0.4, 0.05);
  EXPECT_GT(plain.depth[plain.cellAt(158.0, 60.0)], plain.depth[plain.cellAt(185.0, 60.0)] + 0.1);
}

TEST(SnowMotion, WeakWindMovesNothingOnAPlain) {
  Plain plain(4.0);
  const std::vector<double> before = plain.mass;
  const MotionTotals totals = plain.step(3600.0);
  EXPECT_EQ(totals.eroded[1], 0.0);
  EXPECT_EQ(totals.slid[1], 0.0);
  for (std::size_t c = 0; c < before.size(); ++c) ASSERT_NEAR(plain.mass[c], before[c], 1e-9);
}

TEST(SnowMotion, ThreadsAndPlacingAgainChangeNoBit) {
  Plain one(13.0), other(13.0);
  one.step(1800.0, 1), one.step(1800.0, 1);
  other.step(1800.0, 3);
  other.motion.place(other.ground, std::make_shared<SnowScene>(
                                       *makeSnowScene(other.scene, *other.ground, 0.0, makeBvhRayScene)));
  other.step(1800.0, 3);
  EXPECT_EQ(0, std::memcmp(one.mass.data(), other.mass.data(), one.mass.size() * sizeof(double)));
}

TEST(SnowMotion, TheProcessBooksWhatMoves) {
  TestScene build;
  build.land(41, 41, 5.0, [](double x, double y) { return 1.1 * std::abs(x - 100.0) + 0.05 * y; });
  build.simulation.snowSlides = build.simulation.snowDrifts = true;
  build.simulation.smoothingWidth = 0.2;
  build.weather.windSpeed = 14.0;
  for (const CoverLaw law : {CoverLaw::Lies, CoverLaw::EnergyBalance}) {
    build.cover.law = law;
    const SceneSnapshot scene = build.build();
    SnowRun run(scene, makeBvhRayScene);
    ASSERT_TRUE(run.run(12).ok());
    const Frame frame = run.frame();
    EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
    EXPECT_GT(frame.info.figures.at("slid_kg"), 0.0);
    EXPECT_GT(frame.info.figures.at("taken_up_by_wind_kg"), 0.0);
    EXPECT_GT(frame.info.budget.get("drifted_out"), 0.0);
    // A run that goes on from a saved state goes on alike.
    SnowRun again(scene, makeBvhRayScene);
    ASSERT_TRUE(again.run(6).ok());
    const std::vector<char> state = again.save();
    SnowRun loaded(scene, makeBvhRayScene);
    ASSERT_TRUE(loaded.load(6, state).ok());
    for (int f = 6; f < 12; ++f) ASSERT_TRUE(loaded.step().ok());
    EXPECT_EQ(loaded.save(), run.save());
  }
}

TEST(SnowMotion, SlushRunsOffWhereDrySnowLies) {
  TestScene build;
  build.land(41, 41, 5.0, [](double x, double) { return 0.5 * std::abs(x - 100.0); });  // 27 degrees
  build.weather.windSpeed = 0.0;
  build.simulation.snowSlides = true;
  const SceneSnapshot scene = build.build();
  const SnowGroundPointer ground = makeSnowGround(scene);
  const auto standing = std::make_shared<SnowScene>(*makeSnowScene(scene, *ground, 0.0, makeBvhRayScene));
  for (const bool wet : {false, true}) {
    SnowMotion motion;
    motion.place(ground, standing);
    std::vector<double> depth(motion.graph().size(), 0.5), mass(depth.size(), 200.0),
        liquid(depth.size(), wet ? 80.0 : 0.0);
    CpuBackend backend(2);
    MovingSnow snow;
    snow.carried = {depth.data(), mass.data(), liquid.data()};
    snow.liquid = liquid.data();
    const MotionTotals totals = motion.step(scene, motionSettings(scene, 0.0), 600.0, snow, backend);
    EXPECT_EQ(totals.slid[1] > 0.0, wet);
  }
}

}  // namespace
}  // namespace spin
