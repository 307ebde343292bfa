// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/fall_wind.h"

#include <gtest/gtest.h>

#include "core/sim/shared_registry.h"
#include "core/snow/flake_field.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::boxMesh;
using test::modelOf;
using test::TestScene;

/// A plain with a block of 16 x 12 x 10 m in its middle; the wind blows along x.
TestScene blockOnAPlain(double wind = 5.0) {
  TestScene test;
  test.weather.windSpeed = wind;
  test.weather.windFromDegrees = 270.0;
  test.snowfall.gustIntensity = 0.0;
  test.snowfall.flutterAmplitude = 0.0;
  ModelNode placed;
  placed.position = {100.0, 100.0, 0.0};
  test.land(101, 101, 2.0, [](double, double) { return 0.0; });
  test.model("block", modelOf(boxMesh({-8, -6, 0}, {8, 6, 10})), placed);
  return test;
}

struct Blown {
  SceneSnapshot scene;
  SnowRun run;
  FallingFlakes flakes;
  CpuBackend backend{2};
  std::shared_ptr<const FallWind> wind;

  explicit Blown(TestScene test, int frames = 2) : scene(test.build()), run(scene, makeBvhRayScene, 2) {
    EXPECT_TRUE(run.run(frames).ok());
    flakes = test::flakesOf(run.frame());
    wind = FallWind::of(flakes, backend);
  }
};

TEST(FallWind, LevelGroundChangesNothing) {
  TestScene test;
  test.weather.windSpeed = 5.0;
  test.land(41, 41, 2.0, [](double, double) { return 3.0; });
  const Blown plain(test);
  ASSERT_TRUE(plain.wind);
  for (const double z : {3.0, 5.0, 20.0})
    for (double x = 5.0; x < 80.0; x += 9.0) {
      EXPECT_LT(length(plain.wind->shiftAt({x, 40.0, z})), 0.02);
      EXPECT_LT(length(plain.wind->velocityAt({x, 40.0, z}, {5.0, 0.0, -1.0})), 0.02);
    }
}

TEST(FallWind, CalmAirAndNoLandHaveNone) {
  EXPECT_FALSE(Blown(blockOnAPlain(0.0)).wind);
  TestScene test;
  test.weather.windSpeed = 5.0;
  test.model("block", modelOf(boxMesh({-1, -1, 0}, {1, 1, 2})), ModelNode{});
  EXPECT_FALSE(Blown(test).wind);
}

TEST(FallWind, FlakesAreSlowedBeforeABlockAndLeadRoundAndOverIt) {
  const Blown blown(blockOnAPlain());
  ASSERT_TRUE(blown.wind);
  const FallWind& wind = *blown.wind;
  const Vec3d way{5.0, 0.0, -1.0};
  EXPECT_LT(wind.velocityAt({89.0, 100.0, 3.0}, way).x, -1.0) << "in front";
  EXPECT_GT(wind.velocityAt({89.0, 100.0, 9.0}, way).z, 0.3) << "up before the wall";
  EXPECT_GT(wind.velocityAt({100.0, 100.0, 13.0}, way).x, 0.15) << "over the roof";
  EXPECT_GT(wind.velocityAt({100.0, 110.0, 3.0}, way).x, 0.3) << "beside it";
  const Vec3d left = wind.velocityAt({91.0, 112.0, 3.0}, way),
              right = wind.velocityAt({91.0, 88.0, 3.0}, way);
  EXPECT_GT(left.y, 0.3);
  EXPECT_NEAR(right.y, -left.y, 0.3 * left.y) << "it parts evenly";
  EXPECT_LT(length(wind.velocityAt({40.0, 100.0, 5.0}, way)), 0.25) << "far before it";
  EXPECT_LT(length(wind.shiftAt({100.0, 100.0, 70.0})), 0.3) << "far above it";
}

/// What the shift does to volumes: its divergence, where the air is free.
TEST(FallWind, KeepsVolumes) {
  const Blown blown(blockOnAPlain());
  ASSERT_TRUE(blown.wind);
  double squares = 0.0, shear = 0.0;
  int count = 0;
  const double h = 2.0;
  for (double x = 75.0; x < 130.0; x += 3.0)
    for (double y = 80.0; y < 121.0; y += 4.0)
      for (double z = 13.0; z < 26.0; z += 3.0) {
        double divergence = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3d step{axis == 0 ? h : 0.0, axis == 1 ? h : 0.0, axis == 2 ? h : 0.0};
          const Vec3d slope = (blown.wind->shiftAt({x + step.x, y + step.y, z + step.z}) -
                               blown.wind->shiftAt({x - step.x, y - step.y, z - step.z})) *
                              (0.5 / h);
          divergence += slope[axis];
          shear += dot(slope, slope);
        }
        squares += divergence * divergence;
        ++count;
      }
  EXPECT_GT(std::sqrt(shear / count), 0.05) << "it shears";
  EXPECT_LT(std::sqrt(squares / count), 0.3 * std::sqrt(shear / count));
  EXPECT_LT(std::sqrt(squares / count), 0.06);
}

TEST(FallWind, BeforeIsTheInverse) {
  const Blown blown(blockOnAPlain());
  ASSERT_TRUE(blown.wind);
  for (const Vec3d p : {Vec3d{80.0, 95.0, 6.0}, Vec3d{110.0, 120.0, 15.0}, Vec3d{60.0, 60.0, 2.0}}) {
    const Vec3d q = blown.wind->before(p);
    EXPECT_LT(length(q + blown.wind->shiftAt(q) - p), 0.05);
  }
}

std::map<int, std::pair<Vec3d, Vec3d>> seenFrom(const Blown& blown, const FlakeField& field,
                                                const std::vector<FlakeGroup>& groups, Vec3d eye) {
  FlakeView view;
  view.eye = eye;
  view.wind = blown.wind.get();
  FlakeRecords seen;
  CpuBackend backend(2);
  field.look(blown.flakes, groups, view, backend, seen);
  std::map<int, std::pair<Vec3d, Vec3d>> found;
  for (std::size_t k = 0; k < seen.count; ++k) {
    const auto at = [&](FlakeValue v) { return static_cast<double>(seen[v][k]); };
    found[static_cast<int>(at(FlakeValue::Number))] = {
        eye + Vec3d{at(FlakeValue::X), at(FlakeValue::Y), at(FlakeValue::Z)},
        {at(FlakeValue::VX), at(FlakeValue::VY), at(FlakeValue::VZ)}};
  }
  return found;
}

TEST(FallWind, AMovedCameraMovesNoFlakeAndVelocityIsTheRateOfThePlace) {
  TestScene test = blockOnAPlain();
  test.snowfall.flakeCount = 20000;
  test.simulation.frameRate = 480.0;
  Blown blown(test, 40);
  ASSERT_TRUE(blown.wind);
  const auto groups = flakeGroups(test.snowfall, blown.flakes.numberDensity);
  const FlakeField field(blown.flakes.seed, groups);
  const Vec3d eye{92.0, 108.0, 9.0};
  const auto here = seenFrom(blown, field, groups, eye),
             there = seenFrom(blown, field, groups, eye + Vec3d{0.3, -0.2, 0.1});
  ASSERT_TRUE(blown.run.step().ok());
  blown.flakes = test::flakesOf(blown.run.frame());
  const auto later = seenFrom(blown, field, groups, eye);
  int same = 0, turned = 0, other = 0;
  double error = 0.0;
  for (const auto& [number, flake] : here) {
    const auto moved = there.find(number), after = later.find(number);
    if (moved == there.end() || after == later.end()) continue;
    if (length(moved->second.first - flake.first) > 0.5 || length(after->second.first - flake.first) > 0.5) {
      ++other;  // another copy, a box away
      continue;
    }
    EXPECT_LT(length(moved->second.first - flake.first), 1e-3);
    const Vec3d way = after->second.first - flake.first;
    error += length(way * 480.0 - (flake.second + after->second.second) * 0.5);
    turned += std::abs(flake.second.y) > 0.3;
    ++same;
  }
  ASSERT_GT(same, 2000);
  EXPECT_LT(other, same / 20);
  EXPECT_GT(turned, 100) << "the wind parts before the block";
  EXPECT_LT(error / same, 0.08) << "m/s";
}

TEST(FallWind, ThreadsAndReadingBackChangeNothing) {
  const Blown blown(blockOnAPlain());
  ASSERT_TRUE(blown.wind);
  ByteWriter out;
  putShared(*blown.flakes.landWind, out);
  ByteReader in(out.bytes().data(), out.bytes().size());
  const auto read = std::static_pointer_cast<const WindTable>(loadWindTable(in));
  ASSERT_TRUE(read);
  EXPECT_EQ(read, blown.flakes.landWind) << "the same content is kept once";
  CpuBackend one(1);
  const std::shared_ptr<const FallWind> other = FallWind::of(blown.flakes, one);
  for (double x = 60.0; x < 140.0; x += 7.3) {
    const Vec3d p{x, 97.0, 6.0}, a = other->shiftAt(p), b = blown.wind->shiftAt(p);
    EXPECT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
  }
  for (const std::size_t cut : {std::size_t{3}, std::size_t{60}, out.bytes().size() - 5}) {
    ByteReader shortened(out.bytes().data(), cut);
    EXPECT_FALSE(loadWindTable(shortened));
  }
}

}  // namespace
}  // namespace spin
