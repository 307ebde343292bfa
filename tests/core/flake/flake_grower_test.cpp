// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "core/base/hash.h"
#include "core/base/units.h"
#include "core/flake/flake_atlas.h"
#include "core/flake/flake_grower.h"
#include "core/flake/flake_measure.h"

namespace spin {
namespace {

FlakeSettings settingsOf(FlakeSymmetry symmetry, int particles, std::uint64_t seed = 1) {
  FlakeSettings settings;
  settings.symmetry = symmetry;
  settings.seed = seed;
  settings.radius = kLargestFlake;
  settings.particleDiameter = 2.5e-6;
  settings.particles = particles;
  return settings;
}

FlakeGrower grown(const FlakeSettings& settings) {
  FlakeGrower grower(settings);
  EXPECT_TRUE(grower.grow(static_cast<std::size_t>(settings.particles), CancelToken()).ok());
  EXPECT_TRUE(grower.done());
  return grower;
}

double distance(Vec2d a, Vec2d b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Number of discs that hang together with the first by touching.
std::size_t connected(const std::vector<Vec2d>& centres) {
  std::vector<bool> seen(centres.size(), false);
  std::queue<std::size_t> open;
  open.push(0), seen[0] = true;
  std::size_t count = 0;
  while (!open.empty()) {
    const Vec2d p = centres[open.front()];
    open.pop(), ++count;
    for (std::size_t k = 0; k < centres.size(); ++k)
      if (!seen[k] && distance(p, centres[k]) < 1.0 + 1e-6) open.push(k), seen[k] = true;
  }
  return count;
}

constexpr FlakeSymmetry kSymmetries[] = {FlakeSymmetry::Free, FlakeSymmetry::Six, FlakeSymmetry::Eight};

TEST(FlakeGrower, FlakesHangTogetherAndNoParticlesOverlap) {
  for (const FlakeSymmetry symmetry : kSymmetries)
    for (const double alignment : {0.0, 0.6, 1.0}) {
      FlakeSettings settings = settingsOf(symmetry, 1200);
      settings.alignment = alignment;
      settings.landings = 3;
      const FlakeGrower flake = grown(settings);
      const auto& c = flake.centres();
      ASSERT_GE(c.size(), 1200u);
      EXPECT_EQ(connected(c), c.size()) << static_cast<int>(symmetry) << " arms, alignment " << alignment;
      double nearest = 2.0;
      for (std::size_t a = 0; a < c.size(); ++a)
        for (std::size_t b = a + 1; b < c.size(); ++b) nearest = std::min(nearest, distance(c[a], c[b]));
      EXPECT_GT(nearest, 1.0 - 1e-6);
    }
}

TEST(FlakeGrower, SymmetryIsExact) {
  for (const int arms : {6, 8}) {
    const FlakeGrower flake = grown(settingsOf(static_cast<FlakeSymmetry>(arms), 3000));
    std::vector<Vec2d> sorted = flake.centres();
    const auto less = [](Vec2d a, Vec2d b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(sorted.begin(), sorted.end(), less);
    // Mirror images and half turns are there to the bit.
    for (const Vec2d& p : flake.centres()) {
      ASSERT_TRUE(std::binary_search(sorted.begin(), sorted.end(), Vec2d{-p.x, -p.y}, less));
      // A particle on the sector's other wall is its own mirror image but for rounding.
      const auto near = std::find_if(flake.centres().begin(), flake.centres().end(), [&](Vec2d q) {
        return distance(q, {p.x, -p.y}) < 1e-12 * flake.reach();
      });
      ASSERT_NE(near, flake.centres().end());
    }
    // One arm on: to rounding.
    const double angle = 2.0 * kPi / arms, cosine = std::cos(angle), sine = std::sin(angle);
    for (std::size_t k = 0; k < flake.centres().size(); k += 7) {
      const Vec2d p = flake.centres()[k], q{p.x * cosine - p.y * sine, p.x * sine + p.y * cosine};
      double nearest = 1.0;
      for (const Vec2d& r : flake.centres()) nearest = std::min(nearest, distance(q, r));
      ASSERT_LT(nearest, 1e-12 * flake.reach());
    }
  }
}

TEST(FlakeGrower, SameSeedSameBitsHoweverItIsCut) {
  for (const FlakeSymmetry symmetry : kSymmetries) {
    const FlakeSettings settings = settingsOf(symmetry, 1500, 42);
    const FlakeGrower whole = grown(settings);
    FlakeGrower pieces(settings);
    while (!pieces.done()) ASSERT_TRUE(pieces.grow(7, CancelToken()).ok());
    EXPECT_EQ(whole.centres(), pieces.centres());
    EXPECT_NE(whole.centres(), grown(settingsOf(symmetry, 1500, 43)).centres());
  }
}

/// Two rows that outrun the tip on both sides of it would split an arm: a dark line along its middle.
TEST(FlakeGrower, ArmsAreWholeAlongTheirAxis) {
  for (const FlakeSymmetry symmetry : {FlakeSymmetry::Six, FlakeSymmetry::Eight})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      FlakeSettings settings;
      settings.symmetry = symmetry;
      settings.seed = seed;
      settings.radius = 0.8e-3;
      settings.particles = 20000;
      const FlakeGrower flake = grown(settings);
      std::vector<double> axis;
      for (const Vec2d& p : flake.centres())
        if (p.y == 0.0 && p.x > 0.0) axis.push_back(p.x);
      std::sort(axis.begin(), axis.end());
      ASSERT_FALSE(axis.empty());
      for (std::size_t k = 1; k < axis.size(); ++k) EXPECT_LT(axis[k] - axis[k - 1], 1.0 + 1e-6);
      EXPECT_GT(axis.back(), 0.45 * flake.reach()) << static_cast<int>(symmetry) << " arms, seed " << seed;
    }
}

/// The numbers themselves, so that another compiler or machine that grows another flake is noticed.
TEST(FlakeGrower, GrowsTheFlakeThatItAlwaysGrew) {
  Hasher hasher;
  for (const FlakeSymmetry symmetry : kSymmetries) {
    const FlakeGrower flake = grown(settingsOf(symmetry, 1000));
    for (const Vec2d& p : flake.centres()) hasher.add(p.x).add(p.y);
  }
  EXPECT_EQ(hasher.digest().hex(), "e7cf9802cdb184534c9fe3f69e3ef6ab");
}

TEST(FlakeGrower, FreeClusterHasTheDimensionOfDiffusionLimitedAggregation) {
  double sum = 0.0, byRadius = 0.0;
  for (std::uint64_t run = 1; run <= 8; ++run) {
    const FlakeGrower flake = grown(settingsOf(FlakeSymmetry::Free, 10000, run));
    sum += gyrationDimension(flake.centres()) / 8.0;
    byRadius += massRadiusLaw(flake.centres()).dimension / 8.0;
  }
  EXPECT_NEAR(sum, 1.71, 0.05);
  EXPECT_NEAR(byRadius, 1.71, 0.1);
}

TEST(FlakeMeasure, TellsTheDimensionsOfALineAndADisc) {
  std::vector<Vec2d> line, disc;
  for (int k = 0; k < 4000; ++k) line.push_back({k % 2 ? -0.5 * k : 0.5 * k, 0.0});
  for (int k = 0; k < 20000; ++k) {  // a sunflower's seeds, even from the middle outwards
    const double r = std::sqrt(k + 0.5), a = 2.399963229728653 * k;
    disc.push_back({r * std::cos(a), r * std::sin(a)});
  }
  EXPECT_NEAR(gyrationDimension(line), 1.0, 0.01);
  EXPECT_NEAR(gyrationDimension(disc), 2.0, 0.01);
  const MassRadiusLaw law = massRadiusLaw(disc);
  EXPECT_NEAR(law.dimension, 2.0, 0.02);
  EXPECT_NEAR(law.density(50.0), 1.0, 0.02);
  EXPECT_NEAR(law.number(50.0), 2500.0, 50.0);
  EXPECT_EQ(gyrationDimension({}), 0.0);
  EXPECT_EQ(massRadiusLaw({}).dimension, 0.0);
}

TEST(FlakeGrower, StopsAtItsRadiusOrNumber) {
  FlakeSettings settings;
  settings.radius = 1e-3;
  FlakeGrower flake(settings);
  while (!flake.done()) ASSERT_TRUE(flake.grow(100, CancelToken()).ok());
  EXPECT_GE(flake.radius(), 1e-3);
  EXPECT_LT(flake.radius(), 1e-3 + 2.0 * settings.particleDiameter);
  EXPECT_EQ(flake.progress(), 1.0);
  EXPECT_NEAR(flake.radius(), (flake.reach() + 0.5) * settings.particleDiameter, 1e-15);
  const std::size_t size = flake.centres().size();
  ASSERT_TRUE(flake.grow(100, CancelToken()).ok());
  EXPECT_EQ(flake.centres().size(), size);
}

TEST(FlakeGrower, CancelStopsAtOnceAndGrowthGoesOnAsIfNothingHadBeen) {
  const FlakeSettings settings = settingsOf(FlakeSymmetry::Six, 3000);
  FlakeGrower flake(settings);
  ASSERT_TRUE(flake.grow(500, CancelToken()).ok());
  const CancelToken cancel;
  cancel.cancel();
  const std::size_t size = flake.centres().size();
  const Status status = flake.grow(1000, cancel);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::Cancelled);
  EXPECT_EQ(flake.centres().size(), size);
  while (!flake.done()) ASSERT_TRUE(flake.grow(500, CancelToken()).ok());
  EXPECT_EQ(flake.centres(), grown(settings).centres());
}

TEST(FlakeGrower, RefusesWhatMakesNoFlake) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](auto change) {
    FlakeSettings settings;
    change(settings);
    const Status status = checkFlakeSettings(settings);
    return !status.ok() && status.error().kind == ErrorKind::BadInput && !status.error().why.empty();
  };
  EXPECT_TRUE(checkFlakeSettings({}).ok());
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.particles = 0; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.particles = kMostFlakeParticles + 1; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.radius = 0.9 * kSmallestFlake; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.radius = 1.1 * kLargestFlake; }));
  EXPECT_TRUE(refused([&](FlakeSettings& s) { s.radius = nan; }));
  EXPECT_TRUE(refused([&](FlakeSettings& s) { s.particleDiameter = nan; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.particleDiameter = 0.0; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.particleDiameter = 0.9 * s.radius / kLargestReach; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.alignment = -0.1; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.landings = 0; }));
  EXPECT_TRUE(refused([](FlakeSettings& s) { s.symmetry = static_cast<FlakeSymmetry>(7); }));
}

TEST(GrownFlake, OneOutsideTheRangeIsGrownAgain) {
  FlakeSettings settings;
  settings.symmetry = FlakeSymmetry::Free;
  settings.radius = kLargestFlake;
  settings.particles = 600;
  // By number alone radii scatter; the range takes about the upper half of them.
  FlakeGrower once(settings);
  ASSERT_TRUE(once.grow(600, CancelToken()).ok());
  const auto larger = growFlake(settings, once.radius() + 1e-9, kLargestFlake, {});
  ASSERT_TRUE(larger.ok());
  EXPECT_GT(larger->radius, once.radius());
  EXPECT_NE(larger->centres, once.centres());
  const auto same = growFlake(settings, 0.99 * once.radius(), kLargestFlake, {});
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same->centres, once.centres());
  EXPECT_FALSE(growFlake(settings, 4e-3, kLargestFlake, {}).ok());
}

}  // namespace
}  // namespace spin
