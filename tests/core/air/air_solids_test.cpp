// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/air/brick_solids.h"
#include "core/base/parallel.h"

namespace spin {
namespace {

/// A ball that moves along x, known within a box.
AirSolid ball(Vec3d middle, double radius, double speed) {
  const Vec3d far = (radius + 2.0) * Vec3d{1, 1, 1};
  return {[=](Vec3d p) { return length(p - middle) - radius; },
          [=](Vec3d) {
            return Vec3d{speed, 0, 0};
          },
          middle - far, middle + far};
}

/// Sum of what the solids' motion takes out of all cells of a box, m3/s, and of its magnitude.
std::array<double, 2> pushed(const AirConfig& config) {
  std::array<double, 2> sums{};
  for (std::int32_t z = 0; z < config.highBrick[2]; ++z)
    for (std::int32_t y = 0; y < config.highBrick[1]; ++y)
      for (std::int32_t x = 0; x < config.highBrick[0]; ++x)
        for (const float flux : cutBrick(config, {x, y, z}).flux) {
          sums[0] += static_cast<double>(flux) * config.cell * config.cell;
          sums[1] += std::abs(static_cast<double>(flux)) * config.cell * config.cell;
        }
  return sums;
}

TEST(AirSolids, OnlyWhatMovesPushesTheAir) {
  AirConfig c;
  c.cell = 0.5;
  c.highBrick = {4, 12, 12};
  c.solids.push_back(ball({16, 12, 12}, 4.33, 2.0));
  const std::array<double, 2> alone = pushed(c);
  // What goes out before it comes in behind it: twice its section times its speed.
  EXPECT_NEAR(alone[0], 0.0, 1e-3);
  EXPECT_NEAR(alone[1], 2.0 * 2.0 * 3.14159 * 4.33 * 4.33, 6.0);
  // A steep slope that comes close to the ball, but no cell holds both.
  c.solids.push_back({[](Vec3d p) { return (p.z + p.x - 20.6) / std::sqrt(2.0); }, {}});
  const std::array<double, 2> beside = pushed(c);
  EXPECT_NEAR(beside[0], alone[0], 1e-3);
  EXPECT_NEAR(beside[1], alone[1], 1e-3);
}

std::unique_ptr<AirSolver> make(const AirConfig& config, int threads = 1) {
  auto made = makeAirSolverCpu(config, CpuBackend(threads), bestIsa());
  if (!made) ADD_FAILURE() << made.error().text();
  return made ? std::move(*made) : nullptr;
}

/// Air that is full of everything round a ball.
constexpr Vec3d kStart{8, 16, 16};
constexpr double kRadius = 4.0;
AirConfig mistyAir() {
  AirConfig c;
  c.everywhere = true;
  c.highBrick = {2, 8, 8};
  c.evaporates = false;
  return c;
}
Status fill(AirSolver& air) {
  std::vector<AirSource> sources;
  for (int z = 8; z < 24; ++z)
    for (int y = 8; y < 24; ++y)
      for (int x = 2; x < 28; ++x) {
        const Vec3d p{x + 0.5, y + 0.5, z + 0.5};
        if (length(p - kStart) > kRadius + 1.0) sources.push_back({p, {1e-3, 2e-3, -10.0, 1e-4}, {}});
      }
  return air.add(sources);
}

/// Share of all that was added that is in no term of the budget.
double unaccounted(const AirBudget& b, std::size_t a) {
  const double gone = b.leftSides[a] + b.deposited[a] + b.givenUp[a];
  return std::abs(b.added[a] + b.enteredSides[a] + b.condensed[a] - b.present[a] - gone) /
         std::abs(b.added[a]);
}
double largest(const AirState& s, std::size_t field) {
  float most = 0.0f;
  for (std::size_t k = 0; k < s.bricks.size() * kBrickCells; ++k)
    most = std::max(most, std::abs(s.values[field * s.bricks.size() * kBrickCells + k]));
  return static_cast<double>(most);
}

TEST(AirSolids, WhatMovesThroughMistKeepsItsMass) {
  // A fifth of a cell in a part, and two cells in a part.
  for (const double speed : {4.0, 40.0}) {
    AirConfig c = mistyAir();
    Vec3d middle = kStart;
    c.solids = {ball(middle, kRadius, speed)};
    const auto air = make(c);
    ASSERT_TRUE(fill(*air).ok());
    for (; middle.x < 22.0; middle.x += speed * 0.05) {
      ASSERT_TRUE(air->moveSolids({ball(middle, kRadius, speed)}).ok());
      const auto done = air->step(0.05);
      ASSERT_TRUE(done.ok()) << done.error().text();
    }
    const AirBudget b = air->budget();
    for (std::size_t a = 0; a < kAirScalars; ++a) {
      EXPECT_LT(unaccounted(b, a), 1e-5) << "scalar " << a;
      EXPECT_LT(std::abs(b.givenUp[a]), a == 2 ? 0.03 * std::abs(b.added[a]) : 1e-12) << "scalar " << a;
    }
    // Pushed aside, not heaped up.
    EXPECT_LT(largest(air->state(), 3), speed > 10.0 ? 4e-3 : 1.5e-3);
    EXPECT_LT(largest(air->state(), 5), speed > 10.0 ? 15.0 : 11.0);
  }
}

TEST(AirSolids, NoAirGoesThroughAFloorOrIntoABall) {
  AirConfig c = mistyAir();
  const auto place = [](double x) { return ball({x, 16, 16}, kRadius, 6.0); };
  c.solids = {{[](Vec3d p) { return p.z - 2.3; }, {}}, place(16.0)};
  const auto air = make(c);
  ASSERT_TRUE(air->add({{{5.5, 5.5, 4.5}, {}, {20, 0, -200}}}).ok());
  ASSERT_TRUE(air->step(0.05).ok());
  // The floor's cells have closed faces below, at z = 2.
  const double above = air->velocities({{5.5, 5.5, 2.999}}).front().z;
  EXPECT_LT(above, -0.1);
  EXPECT_NEAR(air->velocities({{5.5, 5.5, 2.001}}).front().z, 0.0, 0.01 * -above);
  EXPECT_NEAR(air->velocities({{16.5, 16.5, 16.5}}).front().x, 6.0, 1e-6);
  EXPECT_EQ(air->velocities({{16.5, 16.5, 16.5}}).front().z, 0.0);
  AirPart part;
  air->publish(false, part);
  const AirField& field = *part.find("velocity");
  const std::size_t brick = 4 * 2 * 8 + 4 * 2 + 1;  // holds the ball's middle
  ASSERT_EQ(part.bricks[brick], (std::array<std::int32_t, 3>{1, 4, 4}));
  EXPECT_NEAR(static_cast<double>(field.at(brick, 0, 0)), 6.0, 1e-2);
  EXPECT_NEAR(static_cast<double>(field.at(2, 2, 2 * 64 + 16 + 5)), 0.5 * above, 0.01 * -above);
}

TEST(AirSolids, WhatASolidEnclosesIsBooked) {
  AirConfig c = mistyAir();
  c.solids = {{[](Vec3d) { return 1.0; }, [](Vec3d) { return Vec3d{}; }}};
  const auto air = make(c);
  ASSERT_TRUE(fill(*air).ok());
  c.solids.front().distance = [](Vec3d) { return -1.0; };
  ASSERT_TRUE(air->moveSolids(c.solids).ok());
  const AirBudget b = air->budget();
  for (std::size_t a = 0; a < kAirScalars; ++a) {
    EXPECT_EQ(b.present[a], 0.0);
    EXPECT_NEAR(b.givenUp[a], b.added[a], 1e-5 * std::abs(b.added[a]));
  }
}

TEST(AirSolids, GoesOnFromAStateBitForBitWhereSolidsMove) {
  AirConfig c = mistyAir();
  const auto solid = [](int k) {
    return std::vector<AirSolid>{ball(kStart + Vec3d{0.3 * k, 0, 0}, kRadius, 6.0)};
  };
  c.solids = solid(0);
  const auto steps = [&](AirSolver& air, int from, int to) {
    for (int k = from; k < to; ++k) {
      ASSERT_TRUE(air.moveSolids(solid(k)).ok());
      ASSERT_TRUE(air.step(0.05).ok());
      static_cast<void>(air.takeDeposits());
    }
  };
  const auto whole = make(c, 3), first = make(c), second = make(c);
  ASSERT_TRUE(fill(*whole).ok() && fill(*first).ok());
  steps(*whole, 0, 9);
  steps(*first, 0, 5);
  ASSERT_TRUE(second->restore(first->state()).ok());
  EXPECT_EQ(second->state().values, first->state().values);
  steps(*second, 5, 9);
  EXPECT_EQ(whole->state().values, second->state().values);
  EXPECT_EQ(whole->budget().givenUp, second->budget().givenUp);
}

TEST(AirSolids, DistancesNeedNotBeTrueFarFromTheSurface) {
  // The height over the ground below, beside a cliff: what is solid is known, how near is not.
  AirConfig c;
  c.cell = 0.8;
  c.highBrick = {3, 4, 16};
  c.solids.push_back({[](Vec3d p) { return p.z - (p.x < 14.1 ? 40.0 : -1.0); }, {}});
  for (std::int32_t z = 0; z < c.highBrick[2]; ++z)
    for (std::int32_t x = 0; x < c.highBrick[0]; ++x) {
      const BrickSolids solids = cutBrick(c, {x, 1, z});
      for (int k = 0; k < static_cast<int>(kBrickCells); ++k) {
        const double right = c.cell * (x * kBrickX + k % kBrickX + 1),
                     top = c.cell * (z * kBrickZ + k / 64 + 1);
        if (right <= 14.1 && top <= 40.0) {
          EXPECT_EQ(solids.volume[static_cast<std::size_t>(k)], 0.0f) << right << ' ' << top;
        }
        if (right - c.cell >= 14.1) {
          EXPECT_EQ(solids.volume[static_cast<std::size_t>(k)], 1.0f) << right << ' ' << top;
        }
      }
    }
}

}  // namespace
}  // namespace spin
