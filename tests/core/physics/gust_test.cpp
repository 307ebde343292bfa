// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/gust.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace spin {
namespace {

Vec3d placeIn(double box, std::uint64_t k) {
  const CounterRandom random{11, 3};
  return Vec3d{random.uniformDouble(k, 0), random.uniformDouble(k, 1), random.uniformDouble(k, 2)} * box;
}

TEST(TurnSine, IsTheSine) {
  for (double x = -7.3; x < 7.3; x += 0.00317) {
    EXPECT_NEAR(turnSine(x), std::sin(2.0 * kPi * x), 1e-8);
    EXPECT_NEAR(turnCosine(x), std::cos(2.0 * kPi * x), 1e-8);
    EXPECT_NEAR(turnSine(static_cast<float>(x)), std::sin(2.0 * kPi * x), 6e-6);
  }
}

TEST(Gust, HasTheMeanAndTheIntensityAskedForInEveryDirection) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const GustModes modes = makeGustModes(seed, 20.0);
    const GustState state{1.7, {12.0, -3.0, 0.0}, 4.0};
    Vec3d mean{}, square{};
    const int n = 200000;
    for (int k = 0; k < n; ++k) {
      const Vec3d v = gustAt(modes, state, placeIn(3000.0, static_cast<std::uint64_t>(k)));
      mean += v;
      square += Vec3d{v.x * v.x, v.y * v.y, v.z * v.z};
    }
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(mean[axis] / n, 0.0, 0.03);
      EXPECT_NEAR(std::sqrt(square[axis] / n), 1.7, 0.03);
    }
  }
}

TEST(Gust, HasTheSameStatisticsInTimeAsInSpace) {
  const GustModes modes = makeGustModes(5, 20.0);
  GustState state{1.0, {}, 0.0};
  Vec3d mean{};
  double square = 0.0;
  const int n = 100000;
  for (int k = 0; k < n; ++k) {
    state.carried += Vec3d{5.0, 0.0, 0.0} * 0.5;
    state.eddyWay += kEddyTurnover * state.strength * 0.5;
    const Vec3d v = gustAt(modes, state, {3.0, 4.0, 5.0});
    mean += v;
    square += dot(v, v);
  }
  EXPECT_LT(length(mean) / n, 0.02);
  EXPECT_NEAR(square / n, 3.0, 0.1);
}

TEST(Gust, HasNoDivergenceAnywhere) {
  const GustModes modes = makeGustModes(7, 15.0);
  const GustState state{2.0, {1.0, 2.0, 3.0}, 0.5};
  const double h = 1e-3;
  double largest = 0.0, shear = 0.0;
  for (std::uint64_t k = 0; k < 500; ++k) {
    const Vec3d p = placeIn(200.0, k);
    const auto slope = [&](Vec3d e) {
      return (gustAt(modes, state, p + e * h) - gustAt(modes, state, p - e * h)) / (2.0 * h);
    };
    const Vec3d x = slope({1, 0, 0}), y = slope({0, 1, 0}), z = slope({0, 0, 1});
    largest = std::max(largest, std::abs(x.x + y.y + z.z));
    shear = std::max({shear, length(x), length(y), length(z)});
  }
  EXPECT_GT(shear, 1.0);  // 1/s
  EXPECT_LT(largest, 1e-5 * shear);
}

TEST(Gust, WavesNeverPointUpAndPushAcross) {
  for (std::uint64_t seed = 0; seed < 50; ++seed)
    for (const GustMode& mode : makeGustModes(seed, 20.0)) {
      EXPECT_LE(mode.wave.z, 0.0);
      EXPECT_NEAR(dot(mode.wave, mode.push), 0.0, 1e-12);
    }
}

/// A body taken through all waves from where it would be without gusts.
GustPoint<double> blown(const GustModes& modes, const GustState& state, Vec3d p, Vec3d v, Vec3d wind) {
  GustPoint<double> b{p.x, p.y, p.z, v.x, v.y, v.z};
  for (const GustMode& m : modes) {
    const Vec3d reach = m.push * (state.strength * gustReach(m, state.strength, -v.z, 0.0));
    followGust(b, {m.wave.x, m.wave.y, m.wave.z, reach.x, reach.y, reach.z, gustTurns(m, state, {}),
                   length(m.wave) * kEddyTurnover * state.strength - dot(m.wave, wind)});
  }
  return b;
}

TEST(Gust, BodiesStayEvenlySpreadAndTheirVelocityIsTheRateOfTheirPlace) {
  const GustModes modes = makeGustModes(3, 20.0);
  const Vec3d wind{4.0, 1.0, 0.0}, fall{4.0, 1.0, -1.0};
  const GustState state{1.2, {7.0, 2.0, 0.0}, 3.0};
  const double h = 1e-5;
  for (std::uint64_t k = 0; k < 300; ++k) {
    const Vec3d p = placeIn(100.0, k);
    const GustPoint<double> now = blown(modes, state, p, fall, wind);
    const GustState later{state.strength, state.carried + wind * h,
                          state.eddyWay + kEddyTurnover * state.strength * h};
    const GustPoint<double> then = blown(modes, later, p + fall * h, fall, wind);
    EXPECT_NEAR((then.x - now.x) / h, now.vx, 1e-3);
    EXPECT_NEAR((then.y - now.y) / h, now.vy, 1e-3);
    EXPECT_NEAR((then.z - now.z) / h, now.vz, 1e-3);
    // Volumes: the determinant of the map's slopes.
    const auto slope = [&](Vec3d e) {
      const GustPoint<double> a = blown(modes, state, p + e * h, fall, wind),
                              b = blown(modes, state, p - e * h, fall, wind);
      return Vec3d{a.x - b.x, a.y - b.y, a.z - b.z} / (2.0 * h);
    };
    EXPECT_NEAR(dot(slope({1, 0, 0}), cross(slope({0, 1, 0}), slope({0, 0, 1}))), 1.0, 1e-5);
  }
}

/// What a flake does in the gusts is what the wind does where it is, the better the weaker they are: waves
/// act one after the other, so each knows only what those before it have done.
TEST(Gust, BodiesGoWithTheWindWhereTheyAre) {
  for (const auto& [strength, least] : {std::pair(0.5, 0.8), std::pair(1.5, 0.65)}) {
    double own = 0.0, field = 0.0, both = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const GustModes modes = makeGustModes(seed, 25.0);
      const Vec3d wind{5.0, 0.0, 0.0}, fall{5.0, 0.0, -1.0};
      const GustState state{strength, {30.0, 0.0, 0.0}, 5.0};
      for (std::uint64_t k = 0; k < 4000; ++k) {
        const GustPoint<double> b = blown(modes, state, placeIn(500.0, k), fall, wind);
        const Vec3d v{b.vx - fall.x, b.vy - fall.y, b.vz - fall.z};
        const Vec3d w = gustAt(modes, state, {b.x, b.y, b.z});
        own += dot(v, v), field += dot(w, w), both += dot(v, w);
      }
    }
    EXPECT_GT(both / std::sqrt(own * field), least) << strength;
    EXPECT_NEAR(std::sqrt(own / field), 1.0, 0.15) << strength;
  }
}

}  // namespace
}  // namespace spin
