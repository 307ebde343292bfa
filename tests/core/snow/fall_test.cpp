// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

Vec3d meanVelocity(const ParticleSet& flakes) {
  const std::vector<float>& v = test::valuesOf(flakes, "velocity");
  Vec3d sum{};
  for (std::size_t k = 0; k < v.size(); k += 3) sum += Vec3f{v[k], v[k + 1], v[k + 2]}.to<double>();
  return sum / static_cast<double>(flakes.size());
}

TEST(Fall, FlakesStayInTheirBoxUnderAnyWindAndStep) {
  for (const double wind : {0.0, 12.0, 80.0})
    for (const double rate : {1.0, 24.0}) {
      TestScene test;
      test.weather.windSpeed = wind;
      test.simulation.frameRate = rate;
      test.snowfall.flakeCount = 2000;
      test.snowfall.boxSize = 7.3;
      const SceneSnapshot scene = test.build();
      SnowRun run(scene, makeBvhRayScene, 2);
      ASSERT_TRUE(run.run(10).ok());
      const Frame frame = run.frame();
      const ParticleSet& flakes = test::flakesOf(frame);
      ASSERT_EQ(flakes.size(), 2000u);
      EXPECT_EQ(flakes.wrapBox, 7.3);
      for (const Vec3f& p : flakes.positions)
        for (int axis = 0; axis < 3; ++axis)
          ASSERT_TRUE(p[axis] >= 0.0f && static_cast<double>(p[axis]) < 7.3);
    }
}

TEST(Fall, EachFlakeFallsAtItsTerminalSpeedAndFollowsTheWind) {
  TestScene test;
  test.weather.windSpeed = 5.0;
  test.weather.windFromDegrees = 0.0;  // blows south
  test.snowfall.flutterAmplitude = 0.0;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.run(24).ok());
  const Frame frame = run.frame();
  const ParticleSet& flakes = test::flakesOf(frame);
  const std::vector<float>& v = test::valuesOf(flakes, "velocity");
  for (std::size_t k = 0; k < flakes.size(); ++k) {
    const double d = static_cast<double>(test::valuesOf(flakes, "diameter")[k]);
    EXPECT_NEAR(-v[3 * k + 2], kUnrimedDendriteAggregate.terminalSpeed(d), 1e-4);
    EXPECT_NEAR(v[3 * k + 1], -5.0, 1e-3);
    EXPECT_NEAR(v[3 * k], 0.0, 1e-3);
  }
}

TEST(Fall, FlutterSwingsWithoutDrift) {
  TestScene test;
  test.snowfall.flakeCount = 20000;
  test.snowfall.flutterAmplitude = 0.3;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(run.begin().ok());
  const Frame start = run.frame();
  for (int f = 0; f < 48; ++f) ASSERT_TRUE(run.step().ok());
  const Frame end = run.frame();
  const Vec3d mean = meanVelocity(test::flakesOf(end));
  EXPECT_NEAR(mean.x, 0.0, 0.01);
  EXPECT_NEAR(mean.y, 0.0, 0.01);
  // Over two seconds no flake leaves its place by more than twice the amplitude, and most do move.
  double sum = 0.0;
  for (std::size_t k = 0; k < 20000; ++k) {
    const Vec3f a = test::flakesOf(start).positions[k], b = test::flakesOf(end).positions[k];
    const double dx = std::remainder(static_cast<double>(b.x - a.x), test.snowfall.boxSize);
    const double dy = std::remainder(static_cast<double>(b.y - a.y), test.snowfall.boxSize);
    ASSERT_LT(std::hypot(dx, dy), 0.6 + 1e-3);
    sum += std::hypot(dx, dy);
  }
  EXPECT_GT(sum / 20000, 0.05);
}

TEST(Fall, NumberTimesWeightIsTheSpectrumWhateverTheCount) {
  for (const int count : {10, 1000}) {
    TestScene test;
    test.snowfall.flakeCount = count;
    const SceneSnapshot scene = test.build();
    SnowRun run(scene, makeBvhRayScene, 1);
    ASSERT_TRUE(run.begin().ok());
    const Frame frame = run.frame();
    const ParticleSet& flakes = test::flakesOf(frame);
    const double perVolume = flakes.weight * static_cast<double>(flakes.size()) / std::pow(flakes.wrapBox, 3);
    EXPECT_NEAR(perVolume / makeSizeSpectrum(kUnrimedDendriteAggregate, 0.002).numberDensity, 1.0, 1e-12);
  }
}

TEST(Fall, FilmTimeNotWeatherTimeMovesTheFlakes) {
  TestScene slow, fast;
  slow.simulation.timeScale = 1.0;
  fast.simulation.timeScale = 10000.0;
  const SceneSnapshot a = slow.build(), b = fast.build();
  SnowRun runA(a, makeBvhRayScene, 1), runB(b, makeBvhRayScene, 1);
  ASSERT_TRUE(runA.run(5).ok());
  ASSERT_TRUE(runB.run(5).ok());
  const Frame frameA = runA.frame(), frameB = runB.frame();
  EXPECT_EQ(test::flakesOf(frameA).positions, test::flakesOf(frameB).positions);
}

TEST(Fall, IdsStayAndNoFlakesAsked) {
  TestScene test, none;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.begin().ok());
  const Frame a = run.frame();
  ASSERT_TRUE(run.step().ok());
  const Frame b = run.frame();
  EXPECT_EQ(test::flakesOf(a).ids, test::flakesOf(b).ids);
  none.snowfall.flakeCount = 0;
  const SceneSnapshot empty = none.build();
  SnowRun emptyRun(empty, makeBvhRayScene, 1);
  ASSERT_TRUE(emptyRun.run(2).ok());
  const Frame c = emptyRun.frame();
  EXPECT_EQ(test::flakesOf(c).size(), 0u);
}

}  // namespace
}  // namespace spin
