// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/physics/snow_visibility.h"
#include "core/snow/flake_groups.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

std::vector<char> bytesOf(const FallingFlakes& flakes) {
  FlakesPart part;
  part.flakes = flakes;
  ByteWriter out;
  part.save(out);
  return out.take();
}

TEST(Fall, EachSizeFallsAtItsTerminalSpeedAndFollowsTheWind) {
  TestScene test;
  test.weather.windSpeed = 5.0;
  test.weather.windFromDegrees = 0.0;  // blows south
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.run(24).ok());
  const Frame frame = run.frame();
  const FallingFlakes& flakes = test::flakesOf(frame);
  ASSERT_EQ(flakes.classes.size(), static_cast<std::size_t>(kFlakeClasses));
  for (const FlakeClass& c : flakes.classes) {
    EXPECT_NEAR(c.fallSpeed, kUnrimedDendriteAggregate.terminalSpeed(c.diameter), 1e-12);
    EXPECT_NEAR(-c.velocity.z, c.fallSpeed, 1e-9);
    EXPECT_NEAR(c.velocity.y, -5.0, 1e-9);
    EXPECT_NEAR(-c.way.z, c.fallSpeed, 1e-9);  // after a second
    EXPECT_NEAR(c.way.y, -5.0, 1e-9);
  }
  EXPECT_NEAR(flakes.gust.carried.y, -5.0, 1e-9);
  EXPECT_NEAR(flakes.gust.strength, test.snowfall.gustIntensity * 5.0, 1e-12);
}

TEST(Fall, ByDragFlakesLagBehindAChangeOfWindAndByTheSineLawTheyDoNot) {
  for (const FlakePath path : {FlakePath::DragAndFlutter, FlakePath::DecayingSine}) {
    TestScene test;
    test.snowfall.path = path;
    SceneSnapshot scene = test.build();
    for (SceneNode& node : scene.nodes)
      if (node.as<WeatherNode>()) {
        AnimationCurve curve;
        curve.setKey({0.0, 0.0, Interpolation::Step});
        curve.setKey({0.5, 10.0, Interpolation::Step});
        node.curves["wind_speed_m_s"] = curve;
      }
    SnowRun run(scene, makeBvhRayScene, 1);
    ASSERT_TRUE(run.run(13).ok());  // a frame of 1/24 s after the wind has risen
    const Frame frame = run.frame();
    const FlakeClass& large = test::flakesOf(frame).classes[150];
    const double speed = std::hypot(large.velocity.x, large.velocity.y);
    if (path == FlakePath::DecayingSine) {
      EXPECT_NEAR(speed, 10.0, 1e-9);
    } else {
      EXPECT_GT(speed, 2.0);
      EXPECT_LT(speed, 9.9);
    }
  }
}

TEST(Fall, TheDecayingSineIsWiderAndFasterInWindAndTheSteadyOneIsNot) {
  const auto swingIn = [](double wind, FlakePath path) {
    TestScene test;
    test.weather.windSpeed = wind;
    test.snowfall.path = path;
    const SceneSnapshot scene = test.build();
    SnowRun run(scene, makeBvhRayScene, 1);
    EXPECT_TRUE(run.run(24).ok());
    return test::flakesOf(run.frame()).classes[120];
  };
  const FlakeClass calm = swingIn(0.0, FlakePath::DecayingSine),
                   windy = swingIn(8.0, FlakePath::DecayingSine);
  EXPECT_NEAR(windy.swingAmplitude / calm.swingAmplitude, 2.0, 1e-9);
  EXPECT_NEAR(windy.swingAngle / calm.swingAngle, 2.0, 1e-9);
  EXPECT_NEAR(calm.swingAngle, SnowfallNode().flutterRate, 1e-9);  // a second of it
  EXPECT_EQ(swingIn(0.0, FlakePath::DragAndFlutter).swingAmplitude,
            swingIn(8.0, FlakePath::DragAndFlutter).swingAmplitude);
}

TEST(Fall, NumberTimesWeightIsTheSpectrumWhateverTheCount) {
  for (const int count : {10, 1000}) {
    TestScene test;
    test.snowfall.flakeCount = count;
    const SceneSnapshot scene = test.build();
    SnowRun run(scene, makeBvhRayScene, 1);
    ASSERT_TRUE(run.begin().ok());
    const Frame frame = run.frame();
    const SizeSpectrum spectrum = makeSizeSpectrum(kUnrimedDendriteAggregate, 0.002);
    for (const FlakeGroup& group : flakeGroups(test.snowfall, test::flakesOf(frame).numberDensity)) {
      const double perVolume = group.weight * group.flakes() / std::pow(group.box, 3);
      EXPECT_NEAR(perVolume / spectrum.numberDensity, 1.0, 1e-12);
    }
  }
}

TEST(Fall, TellsTheVisibilityOfItsPrecipitation) {
  TestScene test;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.begin().ok());
  const Frame frame = run.frame();
  const SizeSpectrum spectrum = makeSizeSpectrum(kUnrimedDendriteAggregate, 0.002);
  const double extinction = snowExtinction(spectrum.massConcentration);
  EXPECT_NEAR(frame.info.figures.at("visibility_m"), 3.912 / extinction, 1e-9);
  EXPECT_NEAR(test::flakesOf(frame).extinction, extinction, 1e-15);
  EXPECT_GT(test::flakesOf(frame).cover, 0.2);
  EXPECT_LT(test::flakesOf(frame).cover, 0.8);
}

TEST(Fall, WithoutPrecipitationNothingFalls) {
  TestScene test;
  test.weather.precipitationRate = 0.0;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.run(3).ok());
  const Frame frame = run.frame();
  EXPECT_EQ(test::flakesOf(frame).numberDensity, 0.0);
  EXPECT_EQ(frame.info.figures.count("visibility_m"), 0u);
}

TEST(Fall, FilmTimeNotWeatherTimeMovesTheFlakes) {
  TestScene slow, fast;
  slow.simulation.timeScale = 1.0;
  fast.simulation.timeScale = 10000.0;
  const SceneSnapshot a = slow.build(), b = fast.build();
  SnowRun runA(a, makeBvhRayScene, 1), runB(b, makeBvhRayScene, 1);
  ASSERT_TRUE(runA.run(5).ok());
  ASSERT_TRUE(runB.run(5).ok());
  EXPECT_EQ(bytesOf(test::flakesOf(runA.frame())), bytesOf(test::flakesOf(runB.frame())));
}

TEST(Fall, AFrameOfAMillionFlakesIsSmallAndReadsBack) {
  TestScene test;
  test.snowfall.flakeCount = 1000000;
  const SceneSnapshot scene = test.build();
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.run(3).ok());
  const std::vector<char> bytes = bytesOf(test::flakesOf(run.frame()));
  EXPECT_LT(bytes.size(), 40000u);
  ByteReader in(bytes.data(), bytes.size());
  const auto part = std::dynamic_pointer_cast<FlakesPart>(FlakesPart::load(in));
  ASSERT_TRUE(part);
  EXPECT_EQ(bytesOf(part->flakes), bytes);
  EXPECT_EQ(part->firstNonFinite(), "");
  for (std::size_t cut = 0; cut < bytes.size(); cut += 997) {
    ByteReader torn(bytes.data(), cut);
    EXPECT_FALSE(FlakesPart::load(torn)) << cut;
  }
  part->flakes.classes[7].way.x = std::nan("");
  EXPECT_NE(part->firstNonFinite(), "");
}

TEST(Fall, GoesOnFromACheckpointBitForBit) {
  TestScene test;
  test.weather.windSpeed = 7.0;
  const SceneSnapshot scene = test.build();
  SnowRun whole(scene, makeBvhRayScene, 1), first(scene, makeBvhRayScene, 1),
      second(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(whole.run(9).ok());
  ASSERT_TRUE(first.run(4).ok());
  ASSERT_TRUE(second.load(4, first.save()).ok());
  for (int f = 0; f < 5; ++f) ASSERT_TRUE(second.step().ok());
  EXPECT_EQ(bytesOf(test::flakesOf(whole.frame())), bytesOf(test::flakesOf(second.frame())));
}

}  // namespace
}  // namespace spin
