// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/flake_field.h"

#include <gtest/gtest.h>

#include <map>

#include "core/physics/snow_visibility.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

/// A scene's flakes and looks at them.
struct Sky {
  TestScene test;
  std::unique_ptr<SceneSnapshot> scene;
  std::unique_ptr<SnowRun> run;
  FallingFlakes flakes;
  std::vector<FlakeGroup> groups;
  std::unique_ptr<FlakeField> field;

  Sky(double wind, double gusts, int count, int frames = 12, double frameRate = 24.0) {
    test.weather.windSpeed = wind;
    test.snowfall.gustIntensity = gusts;
    test.snowfall.flakeCount = count;
    test.simulation.frameRate = frameRate;
    scene = std::make_unique<SceneSnapshot>(test.build());
    run = std::make_unique<SnowRun>(*scene, makeBvhRayScene, 1);
    EXPECT_TRUE(run->run(frames).ok());
    take();
    field = std::make_unique<FlakeField>(flakes.seed, groups);
  }
  void take() {
    flakes = test::flakesOf(run->frame());
    groups = flakeGroups(test.snowfall, flakes.numberDensity);
  }
  void step() {
    EXPECT_TRUE(run->step().ok());
    take();
  }
  FlakeRecords look(const FlakeView& view, Isa isa = bestIsa(), int threads = 1) const {
    FlakeRecords seen;
    CpuBackend backend(threads);
    field->look(flakes, groups, view, backend, seen, isa);
    return seen;
  }
};

struct Seen {
  Vec3d place{}, velocity{};
  double fade = 0.0;
};
std::map<int, Seen> byNumber(const FlakeRecords& seen, Vec3d eye) {
  std::map<int, Seen> found;
  for (std::size_t k = 0; k < seen.count; ++k) {
    const auto at = [&](FlakeValue v) { return static_cast<double>(seen[v][k]); };
    const Vec3d p{at(FlakeValue::X), at(FlakeValue::Y), at(FlakeValue::Z)};
    found[static_cast<int>(at(FlakeValue::Number))] = {
        eye + p, {at(FlakeValue::VX), at(FlakeValue::VY), at(FlakeValue::VZ)}, at(FlakeValue::Fade)};
  }
  return found;
}

FlakeView from(Vec3d eye) {
  FlakeView view;
  view.eye = eye;
  return view;
}

/// What a flake's fade may change by over a short way: the steepest ramp is the first border. Gusts may
/// stretch a way to twice its length.
double steepest(const std::vector<FlakeGroup>& groups) {
  return 2.0 * 1.5 / (2.0 * kGroupBlend * groups.front().farthest);
}

TEST(FlakeField, AMovedCameraMovesNoFlake) {
  const Sky sky(6.0, 0.4, 40000);
  for (const double way : {1e-4, 0.01, 0.4}) {
    const Vec3d a{120.0, -40.0, 15.0}, b = a + Vec3d{0.6, -0.64, 0.48} * way;
    const auto here = byNumber(sky.look(from(a)), a), there = byNumber(sky.look(from(b)), b);
    int same = 0;
    for (const auto& [number, flake] : here) {
      const auto other = there.find(number);
      if (other == there.end()) {
        // Gone behind a border: it must have been fading.
        EXPECT_LT(flake.fade, 2e-3 + steepest(sky.groups) * way);
        continue;
      }
      const double moved = length(other->second.place - flake.place);
      if (moved > 1.0) {
        // Another copy of the same flake, a box away: this one had faded, that one is still faint.
        EXPECT_LT(flake.fade, 2e-3 + steepest(sky.groups) * way);
        EXPECT_LT(other->second.fade, 2e-3 + steepest(sky.groups) * way);
        continue;
      }
      EXPECT_LT(moved, 1e-4);
      EXPECT_LT(length(other->second.velocity - flake.velocity), 1e-3);
      EXPECT_NEAR(other->second.fade, flake.fade, 1e-3 + steepest(sky.groups) * way);
      ++same;
    }
    EXPECT_GT(same, 3000);
  }
}

TEST(FlakeField, AFlakeFadesBeforeItGoesRound) {
  Sky sky(8.0, 0.3, 20000, 12, 480.0);
  const Vec3d eye{3.0, 4.0, 5.0};
  auto before = byNumber(sky.look(from(eye)), eye);
  int rounds = 0, gone = 0;
  for (int f = 0; f < 60; ++f) {
    sky.step();
    auto now = byNumber(sky.look(from(eye)), eye);
    for (const auto& [number, flake] : before) {
      const auto later = now.find(number);
      const double way = 1.3 * length(flake.velocity) / 480.0;
      const double most = 2e-3 + steepest(sky.groups) * way;
      if (later == now.end()) {
        EXPECT_LT(flake.fade, most);
        ++gone;
        continue;
      }
      const double moved = length(later->second.place - flake.place);
      if (moved > 1.0) {
        EXPECT_LT(flake.fade, most);
        EXPECT_LT(later->second.fade, most);
        ++rounds;
        continue;
      }
      EXPECT_LT(moved, way + 1e-3);
      EXPECT_NEAR(later->second.fade, flake.fade, most);
    }
    before = std::move(now);
  }
  EXPECT_GT(rounds + gone, 100);
}

TEST(FlakeField, EachGroupHidesWhatThePrecipitationSays) {
  for (const int groups : {3, 5, 10}) {
    Sky sky(3.0, 0.2, 200000);
    sky.test.snowfall.groups = groups;
    sky.take();
    sky.field = std::make_unique<FlakeField>(sky.flakes.seed, sky.groups);
    ASSERT_EQ(sky.groups.size(), static_cast<std::size_t>(groups));
    std::size_t first = 0;
    double size = 0.0;
    for (const FlakeGroup& group : sky.groups) {
      double area = 0.0;
      for (std::size_t k = first; k < first + group.flakes(); k += kFlakeBlock) {
        const double d = flakeAt(sky.flakes, sky.field->classOf(k)).diameter;
        area += kFlakeBlock * 0.25 * kPi * d * d;
      }
      first += group.flakes();
      const double extinction = sky.flakes.cover * group.weight * area / std::pow(group.box, 3);
      EXPECT_NEAR(extinction / sky.flakes.extinction, 1.0, 0.03) << groups << " groups, box " << group.box;
      EXPECT_GT(group.weight, size) << "farther flakes stand for more";
      size = group.weight;
    }
    EXPECT_EQ(first, sky.field->size());
  }
}

/// Real flakes per volume in shells round the eye, borders included; the last border is blurred by the gusts,
/// which bring flakes over it in both directions.
TEST(FlakeField, NumbersAreTheSameAtEveryDistance) {
  const Sky sky(5.0, 0.3, 400000);
  const FlakeRecords seen = sky.look(from({10.0, 20.0, 30.0}));
  const double range = 0.5 * sky.groups.back().farthest;
  constexpr int kShells = 8;
  double numbers[kShells] = {};
  for (std::size_t k = 0; k < seen.count; ++k) {
    const double x = static_cast<double>(seen[FlakeValue::X][k]),
                 y = static_cast<double>(seen[FlakeValue::Y][k]),
                 z = static_cast<double>(seen[FlakeValue::Z][k]);
    const double share = std::log(std::sqrt(x * x + y * y + z * z) / 1.0) / std::log(range / 1.0);
    const int shell = static_cast<int>(std::floor(kShells * share));
    if (shell >= 0 && shell < kShells)
      numbers[shell] +=
          static_cast<double>(seen[FlakeValue::Weight][k]) * static_cast<double>(seen[FlakeValue::Fade][k]);
  }
  for (int s = 0; s < kShells; ++s) {
    const auto radius = [&](int edge) { return std::pow(range, edge / double(kShells)); };
    const double volume = 4.0 / 3.0 * kPi * (std::pow(radius(s + 1), 3) - std::pow(radius(s), 3));
    EXPECT_NEAR(numbers[s] / volume / sky.flakes.numberDensity, 1.0, 0.1) << "from " << radius(s) << " m";
  }
}

TEST(FlakeField, InstructionSetsAndThreadsAgree) {
  const Sky sky(7.0, 0.5, 20000);
  FlakeView all = from({500.0, 900.0, 40.0});
  all.leastFade = -1.0;
  const FlakeRecords best = sky.look(all, bestIsa(), 1), threads = sky.look(all, bestIsa(), 3);
  ASSERT_EQ(best.count, sky.field->size());
  ASSERT_EQ(threads.count, best.count);
  for (std::size_t v = 0; v < kFlakeRecord; ++v)
    EXPECT_TRUE(std::equal(best.values[v], best.values[v] + best.count, threads.values[v])) << v;
  for (const Isa isa : runnableIsas()) {
    const FlakeRecords other = sky.look(all, isa, 2);
    ASSERT_EQ(other.count, best.count);
    for (std::size_t v = 0; v < kFlakeRecord; ++v)
      for (std::size_t k = 0; k < best.count; ++k)
        ASSERT_NEAR(other.values[v][k], best.values[v][k], 3e-4) << isaName(isa) << " value " << v;
  }
}

TEST(FlakeField, VelocityIsTheRateOfThePlace) {
  Sky sky(6.0, 0.4, 5000, 240, 480.0);
  FlakeView all = from({});
  all.leastFade = -1.0;
  const FlakeRecords a = sky.look(all);
  sky.step();
  const FlakeRecords b = sky.look(all);
  const FlakeValue places[] = {FlakeValue::X, FlakeValue::Y, FlakeValue::Z};
  const FlakeValue speeds[] = {FlakeValue::VX, FlakeValue::VY, FlakeValue::VZ};
  const auto goneRound = [&](std::size_t k) {
    return std::any_of(std::begin(places), std::end(places),
                       [&](FlakeValue v) { return std::abs(b[v][k] - a[v][k]) > 1.0f; });
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t k = 0; k < a.count; ++k) {
      if (goneRound(k)) continue;
      const double way = static_cast<double>(b[places[axis]][k] - a[places[axis]][k]);
      const double mean = 0.5 * static_cast<double>(a[speeds[axis]][k] + b[speeds[axis]][k]);
      ASSERT_NEAR(way * 480.0, mean, 0.03) << k;
    }
}

TEST(FlakeField, AFrustumAndAShareLeaveOutOnlyWhatTheySay) {
  const Sky sky(4.0, 0.2, 40000);
  FlakeView wide = from({1.0, 2.0, 3.0}), narrow = wide, half = wide;
  narrow.tangentX = 0.5, narrow.tangentY = 0.3;
  half.share = 0.5;
  const auto all = byNumber(sky.look(wide), {}), seen = byNumber(sky.look(narrow), {});
  std::size_t inside = 0;
  for (const auto& [number, flake] : all) {
    const Vec3d p = flake.place;  // from the eye; it looks along y
    const bool in = p.y > 0.0 && std::abs(p.x) < 0.5 * p.y + 0.1 && std::abs(p.z) < 0.3 * p.y + 0.1;
    EXPECT_EQ(seen.count(number) == 1, in);
    inside += in;
  }
  EXPECT_EQ(seen.size(), inside);
  EXPECT_GT(inside, 200u);
  const auto few = byNumber(sky.look(half), {});
  EXPECT_NEAR(static_cast<double>(few.size()) / static_cast<double>(all.size()), 0.5, 0.03);
  for (const auto& [number, flake] : few) EXPECT_EQ(all.count(number), 1u);
}

TEST(FlakeField, ParticlesForExportStandRoundTheEyeAndWeighWhatFalls) {
  const Sky sky(5.0, 0.2, 100000);
  CpuBackend backend(2);
  const Vec3d eye{300.0, 400.0, 50.0};
  const ParticleSet set = flakesAround(sky.flakes, sky.test.snowfall, eye, backend);
  ASSERT_GT(set.size(), 10000u);
  EXPECT_EQ(set.wrapBox, 0.0);
  for (const ParticleAttribute& a : set.attributes)
    EXPECT_EQ(a.values.size(), set.size() * static_cast<std::size_t>(a.components));
  const ParticleAttribute *diameter = set.find("diameter"), *mass = set.find("mass");
  ASSERT_TRUE(diameter && mass && set.find("velocity") && set.find("weight"));
  std::size_t inside = 0;
  for (std::size_t k = 0; k < set.size(); ++k) {
    // Gusts bring some of those in from farther away.
    const double distance = length(set.positions[k].to<double>() - eye);
    ASSERT_LT(distance, sky.test.snowfall.boxSize);
    inside += distance < 0.5 * sky.test.snowfall.boxSize;
    const double expected = kUnrimedDendriteAggregate.mass(static_cast<double>(diameter->values[k]));
    ASSERT_NEAR(static_cast<double>(mass->values[k]) / expected, 1.0, 0.08);
  }
  EXPECT_GT(static_cast<double>(inside), 0.8 * static_cast<double>(set.size()));
}

TEST(FlakeGroups, NoFlakesNoGroups) {
  SnowfallNode snowfall;
  snowfall.flakeCount = 0;
  EXPECT_TRUE(flakeGroups(snowfall, 1000.0).empty());
  EXPECT_EQ(flakeCountOf({}), 0u);
}

TEST(SpriteSize, ThePinholeLawIsPerspective) {
  const double fov = 0.9;
  const SpriteSizeLaw law = pinholeSizeLaw(fov);
  // A thing as tall as the view is fills the viewport.
  for (const double distance : {0.5, 3.0, 200.0})
    EXPECT_NEAR(law.pixels(720.0, 2.0 * distance * std::tan(0.5 * fov), distance), 720.0, 1e-9);
  EXPECT_LT((SpriteSizeLaw{1.0, 0.0, law.c}.pixels(720, 0.01, 0.1)), law.pixels(720, 0.01, 0.1));
}

TEST(Visibility, FollowsKoschmieder) {
  EXPECT_NEAR(snowExtinction(1e-3), 10.36e-3, 1e-9);
  EXPECT_NEAR(snowExtinction(2e-3) / snowExtinction(1e-3), std::pow(2.0, 0.7776), 1e-9);
  EXPECT_EQ(snowExtinction(0.0), 0.0);
  EXPECT_NEAR(visibilityOf(3.912e-3), 1000.0, 1e-9);
}

}  // namespace
}  // namespace spin
