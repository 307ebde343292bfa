// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/air/air_solver.h"
#include "core/base/parallel.h"
#include "core/base/units.h"

namespace spin {
namespace {

using Solver = std::unique_ptr<AirSolver>;

/// Open air over level ground, in bricks that come and go.
AirConfig valley() {
  AirConfig c;
  c.cell = 0.5;
  c.highBrick = {4, 12, 12};
  c.settling = {0.02, 0.5};
  c.solids.push_back({[](Vec3d p) { return p.z - 1.3; }, {}});
  return c;
}

Solver make(const AirConfig& config, int threads = 1, Isa isa = bestIsa()) {
  auto made = makeAirSolverCpu(config, CpuBackend(threads), isa);
  if (!made) ADD_FAILURE() << made.error().text();
  return made ? std::move(*made) : nullptr;
}

/// A ball of sources round a place, m.
std::vector<AirSource> puff(Vec3d middle, double radius, AirAmounts each, Vec3d impulse = {}) {
  std::vector<AirSource> sources;
  for (int k = 0; k < 200; ++k) {
    const double z = 1.0 - 2.0 * (k + 0.5) / 200, angle = 2.39996 * k,
                 r = radius * std::cbrt((k % 7 + 0.5) / 7.0);
    const double across = r * std::sqrt(1.0 - z * z);
    sources.push_back(
        {middle + Vec3d{across * std::cos(angle), across * std::sin(angle), r * z}, each, impulse});
  }
  return sources;
}

double closing(const AirBudget& b, std::size_t a) {
  const double gone = b.leftSides[a] + b.deposited[a] + b.givenUp[a];
  return std::abs(b.present[a] + gone - b.added[a] - b.condensed[a] - b.enteredSides[a]) /
         std::max(b.added[a] + std::abs(b.condensed[a]), 1e-12);
}

void expectClosed(const AirSolver& solver) {
  for (const std::size_t a : {0u, 1u, 3u}) EXPECT_LT(closing(solver.budget(), a), 1e-5) << "scalar " << a;
}

double speedNear(const AirSolver& solver, Vec3d place) {
  return length(solver.velocities({place}).front());
}

TEST(AirHard, MistIsConservedOverGroundWithWindAndOpenSides) {
  AirConfig c = valley();
  c.wind = [](Vec3d p) { return Vec3d{3.0 + 0.1 * p.z, 0.5, 0.0}; };
  const Solver solver = make(c);
  for (int k = 0; k < 100; ++k) {
    if (k < 20) {
      ASSERT_TRUE(solver->add(puff({8, 10, 4}, 1.5, {2e-3, 1e-3, 1e-3, 0})).ok());
    }
    const auto done = solver->step(0.1);
    ASSERT_TRUE(done.ok()) << done.error().text();
    EXPECT_TRUE(done->reached);
  }
  const AirBudget b = solver->budget();
  EXPECT_GT(b.leftSides[0], 0.1 * b.added[0]) << "the wind blows it out";
  EXPECT_GT(b.deposited[1], 0.0);
  expectClosed(*solver);
}

TEST(AirHard, BricksComeWithTheCloudAndGoWithIt) {
  AirConfig c = valley();
  c.least = {1e-4, 1e-4, 0.2, 1e-3};
  c.leastSpeed = 0.5;
  c.viscosity = 0.5;  // as of eddies, so that the air comes to rest
  const Solver solver = make(c);
  EXPECT_EQ(solver->cells(), 0u);
  ASSERT_TRUE(solver->step(0.1).ok());
  ASSERT_TRUE(solver->add(puff({8, 10, 6}, 1.0, {0, 1e-3, 0, 0})).ok());
  ASSERT_TRUE(solver->step(0.1).ok());
  const std::size_t most = solver->cells();
  EXPECT_GT(most, 0u);
  EXPECT_LT(most, 4u * 12u * 12u * kBrickCells) << "not everywhere";
  for (int k = 0; k < 300 && solver->cells() > 0; ++k) ASSERT_TRUE(solver->step(0.2).ok());
  EXPECT_EQ(solver->cells(), 0u) << "the snow has come down and the air is calm";
  double down = 0.0;
  for (const AirDeposit& d : solver->takeDeposits()) down += d.snow;
  const AirBudget b = solver->budget();
  EXPECT_NEAR(down, b.deposited[1], 1e-5 * b.added[1]);
  EXPECT_GT(down, 0.9 * b.added[1]);
  expectClosed(*solver);
}

TEST(AirHard, SolidEverywhereStandsStill) {
  AirConfig c = valley();
  c.everywhere = true;
  c.solids = {{[](Vec3d) { return -1.0; }, {}}};
  const Solver solver = make(c);
  ASSERT_TRUE(solver->add(puff({8, 10, 6}, 1.0, {1e-3, 0, 0, 0}, {1, 2, 3})).ok());
  const auto done = solver->step(0.1);
  ASSERT_TRUE(done.ok());
  EXPECT_EQ(done->fastest, 0.0);
  const AirBudget b = solver->budget();
  EXPECT_NEAR(b.solidImpulse.x, 200.0, 1e-9);
  expectClosed(*solver);
}

TEST(AirHard, AClosedPocketKeepsItsMistAndStaysFinite) {
  AirConfig c = valley();
  c.everywhere = true;
  // A hollow shell in the open air, heated inside.
  c.solids = {{[](Vec3d p) { return std::abs(length(p - Vec3d{16, 12, 12}) - 6.0) - 1.0; }, {}}};
  const Solver solver = make(c);
  for (int k = 0; k < 30; ++k) {
    ASSERT_TRUE(solver->add(puff({16, 12, 10}, 2.0, {1e-4, 0, 0.02, 0})).ok());
    const auto done = solver->step(0.1);
    ASSERT_TRUE(done.ok()) << done.error().text();
    EXPECT_TRUE(done->reached) << done->residual;
  }
  EXPECT_GT(speedNear(*solver, {16, 12, 12}), 0.05) << "it turns over inside";
  EXPECT_LT(speedNear(*solver, {16, 20.5, 12}), 1e-3) << "nothing gets through the shell";
  AirBudget b = solver->budget();
  EXPECT_EQ(b.leftSides[0], 0.0);
  expectClosed(*solver);
}

TEST(AirHard, ABodyThatMovesIntoAPocketChangesNothingThatCannotMove) {
  AirConfig c = valley();
  c.everywhere = true;
  c.closed.fill(true);
  const auto ball = [](double x, double speed) {
    return AirSolid{[x](Vec3d p) {
                      return length(p - Vec3d{x, 12, 12}) - 4.0;
                    },
                    [speed](Vec3d) {
                      return Vec3d{speed, 0, 0};
                    },
                    {x - 5, 7, 7},
                    {x + 5, 17, 17}};
  };
  c.solids = {ball(10, 2.0)};
  const Solver solver = make(c);
  ASSERT_TRUE(solver->add(puff({16, 12, 12}, 1.0, {1e-3, 0, 0, 0})).ok());
  for (int k = 1; k <= 20; ++k) {
    const auto done = solver->step(0.1);
    ASSERT_TRUE(done.ok()) << done.error().text();
    ASSERT_TRUE(solver->moveSolids({ball(10 + 0.2 * k, 2.0)}).ok());
  }
  EXPECT_LT(speedNear(*solver, {16.5, 18.5, 12}), 5.0);
  EXPECT_GT(speedNear(*solver, {18.6, 12, 12}), 0.8) << "it pushes the air before it";
}

TEST(AirHard, LongStepsAndStrongWindStayFinite) {
  AirConfig c = valley();
  c.mostCourant = 20.0;
  c.wind = [](Vec3d) { return Vec3d{60.0, 0.0, 0.0}; };
  c.solids.push_back({[](Vec3d p) { return length(p - Vec3d{14, 12, 4}) - 3.0; }, {}});
  const Solver solver = make(c);
  double fastest = 0.0;
  for (int k = 0; k < 6; ++k) {
    ASSERT_TRUE(solver->add(puff({8, 12, 5}, 1.0, {1e-3, 0, 0, 0})).ok());
    const auto done = solver->step(10.0 / 60.0);
    ASSERT_TRUE(done.ok()) << done.error().text();
    fastest = std::max(fastest, done->fastest);
  }
  EXPECT_LT(fastest, 250.0);
  expectClosed(*solver);
}

TEST(AirHard, AGapOneCellWideLetsTheAirThrough) {
  AirConfig c = valley();
  c.everywhere = true;
  c.wind = [](Vec3d) { return Vec3d{2.0, 0.0, 0.0}; };
  // A wall across the wind, with a slit.
  c.solids = {{[](Vec3d p) {
                 const double wall = std::abs(p.x - 16.25) - 0.75, slit = 0.26 - std::abs(p.z - 12.25);
                 return std::max(wall, slit);
               },
               {}}};
  const Solver solver = make(c);
  for (int k = 0; k < 30; ++k) {
    const auto done = solver->step(0.1);
    ASSERT_TRUE(done.ok()) << done.error().text();
  }
  EXPECT_GT(solver->velocities({{16.25, 12.25, 12.25}}).front().x, 1.0);
  EXPECT_LT(speedNear(*solver, {16.25, 12.25, 6.25}), 0.5) << "within the wall";
}

TEST(AirHard, PowderOfFiftyKilogramsFallsAndRuns) {
  AirConfig c = valley();
  c.everywhere = true;
  c.closed = {true, true, true, true, true, false};
  c.settling = {0.0, 0.0};
  const Solver solver = make(c);
  // A column of 50 kg/m3, 3 m wide and 6 m high, at one side of a closed valley floor.
  std::vector<AirSource> column;
  for (int z = 3; z < 15; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 6; ++x)
        column.push_back({0.5 * Vec3d{x + 0.5, y + 0.5, z + 0.5}, {0, 50.0 * 0.125, 0, 0}, {}});
  ASSERT_TRUE(solver->add(column).ok());
  double fastest = 0.0;
  for (int k = 0; k < 20; ++k) {
    const auto done = solver->step(0.05);
    ASSERT_TRUE(done.ok()) << done.error().text();
    EXPECT_TRUE(done->reached) << done->residual;
    fastest = std::max(fastest, done->fastest);
  }
  // Nearly free fall at first: far more than Boussinesq's push in air that carries along, less than sqrt(2 g
  // h).
  EXPECT_GT(fastest, 4.0);
  EXPECT_LT(fastest, 20.0);
  expectClosed(*solver);
}

TEST(AirHard, WhenAllIsGoneThereIsNothing) {
  const Solver solver = make(valley());
  ASSERT_TRUE(solver->step(1.0).ok());
  AirPart part;
  solver->publish(true, part);
  EXPECT_TRUE(part.bricks.empty());
  EXPECT_TRUE(solver->takeDeposits().empty());
  EXPECT_EQ(solver->budget().present[0], 0.0);
  EXPECT_EQ(solver->velocities({{1, 1, 5}}).front(), (Vec3d{}));
}

TEST(AirHard, ThreadsDoNotCountAndSetsAgree) {
  AirConfig c = valley();
  c.wind = [](Vec3d) { return Vec3d{1.0, 0.2, 0.0}; };
  const auto run = [&](int threads, Isa isa) {
    const Solver solver = make(c, threads, isa);
    for (int k = 0; k < 8; ++k) {
      EXPECT_TRUE(solver->add(puff({8, 10, 4}, 1.5, {1e-3, 2e-2, 0.01, 1e-4}, {0.1, 0, 0})).ok());
      EXPECT_TRUE(solver->step(0.1).ok());
    }
    return solver->state();
  };
  const AirState one = run(1, bestIsa());
  EXPECT_EQ(one.values, run(2, bestIsa()).values);
  EXPECT_EQ(one.values, run(4, bestIsa()).values);
  for (const Isa isa : runnableIsas()) {
    const AirState other = run(1, isa);
    ASSERT_EQ(other.bricks, one.bricks) << isaName(isa);
    double apart = 0.0;
    for (std::size_t k = 0; k < 3 * one.bricks.size() * kBrickCells; ++k)
      apart = std::max(apart, std::abs(static_cast<double>(other.values[k] - one.values[k])));
    EXPECT_LT(apart, 0.02) << isaName(isa);
  }
}

TEST(AirHard, GoesOnFromAStateBitForBit) {
  AirConfig c = valley();
  c.wind = [](Vec3d p) { return Vec3d{1.0, 0.1 * p.z, 0.0}; };
  c.viscosity = 0.05;
  const auto steps = [&](AirSolver& solver, int from, int to) {
    for (int k = from; k < to; ++k) {
      EXPECT_TRUE(solver.add(puff({8 + 0.2 * k, 10, 4}, 1.5, {1e-3, 1e-2, 0.01, 1e-4})).ok());
      std::vector<AirDrag> drops(20, {{9, 10.2, 5}, {0, 0, -6}, 0.01, 2.0});
      EXPECT_TRUE(solver.drag(drops, 0.1).ok());
      EXPECT_TRUE(solver.step(0.1).ok());
      static_cast<void>(solver.takeDeposits());
    }
  };
  const Solver whole = make(c), first = make(c), second = make(c);
  steps(*whole, 0, 9);
  steps(*first, 0, 5);
  ASSERT_TRUE(second->restore(first->state()).ok());
  steps(*second, 5, 9);
  const AirState a = whole->state(), b = second->state();
  EXPECT_EQ(a.bricks, b.bricks);
  EXPECT_EQ(a.values, b.values);
  EXPECT_EQ(a.upper, b.upper);
  EXPECT_EQ(a.budget.deposited, b.budget.deposited);
}

TEST(AirHard, GoesOnBitForBitWhileBricksGo) {
  // Puffs that rise apart, so that bricks beside the cloud come and go again.
  AirConfig c = valley();
  c.cell = 1.0;
  c.highBrick = {4, 16, 16};
  c.temperature = 285.0, c.humidity = 0.6;
  c.wind = [](Vec3d p) { return Vec3d{1.5 + 0.02 * p.z, 0.5, 0.0}; };
  c.leastSpeed = 0.6, c.least = {1e-4, 1e-4, 0.5, 1e-3};
  c.solids = {{[](Vec3d p) { return 0.96 * (p.z - 0.3 * p.x); }, {}}};
  const Solver whole = make(c), again = make(c);
  std::size_t gone = 0;
  for (int k = 0; k < 48; ++k) {
    const double turn = 0.7 * k;
    const Vec3d place{12 + 6 * std::cos(turn), 30 + 8 * std::sin(turn), 26 + 6 * std::sin(1.7 * turn)};
    if (k < 25) {
      ASSERT_TRUE(whole->add({{place, {0.3, 0, 30, 0}, {0, 3, 8}}}).ok());
    }
    const std::size_t cells = whole->cells();
    const AirState before = whole->state();
    ASSERT_TRUE(whole->step(0.25).ok());
    static_cast<void>(whole->takeDeposits());
    gone += whole->cells() < cells;
    if (k % 4 != 3) continue;
    ASSERT_TRUE(again->restore(before).ok());
    ASSERT_TRUE(again->step(0.25).ok());
    static_cast<void>(again->takeDeposits());
    EXPECT_EQ(again->state().values, whole->state().values) << k;
    EXPECT_EQ(again->state().upper, whole->state().upper) << k;
  }
  EXPECT_GT(gone, 3u);
}

TEST(AirHard, WindThatGrowsWithHeightIsNoReasonToComputeTheAir) {
  AirConfig c = valley();
  c.wind = [](Vec3d p) { return Vec3d{0.5 * p.z, 0.0, 0.0}; };
  const Solver solver = make(c);
  ASSERT_TRUE(solver->add(puff({8, 12, 3}, 1.0, {1e-4, 0, 0, 0})).ok());
  for (int k = 0; k < 20; ++k) ASSERT_TRUE(solver->step(0.1).ok());
  EXPECT_LT(solver->cells(), 4u * 12u * 12u * kBrickCells / 3) << "the cloud lies near the ground";
}

TEST(AirHard, WindThatBlowsIntoASlopeIsNoReasonEither) {
  AirConfig c = valley();
  c.highBrick = {8, 24, 24};
  // Level wind, which no steep slope lets be, through one small cloud.
  c.wind = [](Vec3d) { return Vec3d{4.0, 0.0, 0.0}; };
  c.solids = {{[](Vec3d p) { return 0.7 * (p.z - 2.0 - std::max(p.x - 30.0, 0.0)); }, {}}};
  const Solver solver = make(c);
  ASSERT_TRUE(solver->add(puff({24, 24, 6}, 1.0, {1e-4, 0, 0, 0})).ok());
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(solver->step(0.1).ok());
  EXPECT_LT(solver->cells(), 8u * 24u * 24u * kBrickCells / 4);
  // A gust without a cloud is computed, too.
  const Solver gusty = make(c);
  ASSERT_TRUE(gusty->add({{{8, 24, 20}, {}, {50, 0, 0}}}).ok());
  for (int k = 0; k < 5; ++k) ASSERT_TRUE(gusty->step(0.02).ok());
  EXPECT_GT(gusty->velocities({{9, 24, 20}}).front().x, 5.0);
}

TEST(AirHard, DragKeepsMomentumAndStaysStable) {
  AirConfig c = valley();
  c.everywhere = true;
  c.stages = {false, false, false, false, false};
  const Solver solver = make(c);
  // Ten thousand times as heavy as the air of a cell, and held to it hard.
  std::vector<AirDrag> drops;
  for (int k = 0; k < 50; ++k) drops.push_back({{10 + 0.1 * k, 12, 8}, {5, 0, -20}, 40.0, 1e4});
  Vec3d before{};
  for (const AirDrag& d : drops) before += d.mass * d.velocity;
  ASSERT_TRUE(solver->drag(drops, 0.1).ok());
  Vec3d after{};
  for (const AirDrag& d : drops) {
    after += d.mass * d.velocity;
    EXPECT_LE(length(d.velocity), 21.0);
  }
  const AirBudget b = solver->budget();
  EXPECT_LT(length(before - after - b.addedImpulse - b.solidImpulse), 1e-9 * length(before));
  // What the air was given is in its faces.
  const AirState s = solver->state();
  const double density = 101325.0 / (287.05 * 273.15), cell = c.cell * c.cell * c.cell;
  double z = 0.0;
  const std::size_t cells = s.bricks.size() * kBrickCells;
  for (std::size_t k = 2 * cells; k < 3 * cells; ++k) z += static_cast<double>(s.values[k]) * density * cell;
  EXPECT_NEAR(z, b.addedImpulse.z, 0.01 * std::abs(b.addedImpulse.z));
}

/// What the solver says, of a state in which one number has been changed.
std::string saidOf(AirConfig config, std::size_t field, float value, bool everywhere) {
  config.everywhere = everywhere;
  const Solver solver = make(config);
  EXPECT_TRUE(solver->add(puff({8, 10, 6}, 2.0, {1e-3, 1e-3, 1e-3, 0})).ok());
  AirState s = solver->state();
  std::size_t brick = 0;
  while (s.bricks[brick] != std::array<std::int32_t, 3>{1, 5, 3}) ++brick;
  s.values[(field * s.bricks.size() + brick) * kBrickCells + 37] = value;
  EXPECT_TRUE(solver->restore(s).ok());
  const auto done = solver->step(0.1);
  return done ? "fine" : done.error().text();
}

TEST(AirHard, HeavyAirIsHardToDrag) {
  AirConfig c = valley();
  c.everywhere = true;
  c.stages = {false, false, false, false, false};
  const Solver solver = make(c);
  const double volume = 0.125, air = 1.29;
  ASSERT_TRUE(solver->add({{{10.25, 12.25, 8.25}, {0, 50.0 * volume, 0, 0}, {}}}).ok());
  // Held to the air so hard that both end with one speed.
  std::vector<AirDrag> lumps{{{10.25, 12.25, 8.25}, {10, 0, 0}, 5.0, 1e7},
                             {{4.25, 12.25, 8.25}, {10, 0, 0}, 5.0, 1e7}};
  ASSERT_TRUE(solver->drag(lumps, 0.1).ok());
  EXPECT_NEAR(lumps[0].velocity.x, 50.0 / (5.0 + (50.0 + air) * volume), 0.01);
  EXPECT_NEAR(lumps[1].velocity.x, 50.0 / (5.0 + air * volume), 0.01);
}

TEST(AirHard, SaysWhatIsWrongAndWhere) {
  const AirConfig c = valley();
  // Cell (5, 2, 0) of the brick.
  const std::string place = "(10.75, 11.25, 6.25) m";
  for (const bool everywhere : {false, true}) {
    EXPECT_EQ(saidOf(c, 5, 1.0f, everywhere), "fine");
    for (const float warmth : {-273.15f, -400.0f, -230.0f}) {
      const std::string said = saidOf(c, 5, warmth, everywhere);
      EXPECT_NE(said.find(" K at " + place), std::string::npos) << said;
      EXPECT_NE(said.find("stage 'weight'"), std::string::npos) << said;
    }
    EXPECT_NE(saidOf(c, 3, -5.0f, everywhere).find("weighs nothing at " + place), std::string::npos);
    EXPECT_NE(saidOf(c, 1, 1e38f, everywhere).find("along y is 1e+38 m/s at " + place), std::string::npos);
  }
  AirConfig dry = c;
  dry.evaporates = false;
  EXPECT_NE(saidOf(dry, 5, -400.0f, true), "fine");
  const Solver solver = make(c);
  EXPECT_FALSE(solver->add({{{8, 10, 6}, {0, 0, NAN, 0}, {}}}).ok());
  const Status cold = solver->add({{{8, 10, 6}, {0, 0, -300.0 * 0.125, 0}, {}}});
  ASSERT_FALSE(cold.ok());
  EXPECT_NE(cold.error().text().find("stage 'exchange'"), std::string::npos) << cold.error().text();
}

TEST(AirHard, RefusesWhatCannotBe) {
  AirConfig c = valley();
  c.cell = 0.0;
  EXPECT_FALSE(makeAirSolverCpu(c, CpuBackend(1), bestIsa()).ok());
  c = valley();
  c.highBrick[1] = c.lowBrick[1];
  EXPECT_FALSE(makeAirSolverCpu(c, CpuBackend(1), bestIsa()).ok());
  const Solver solver = make(valley());
  EXPECT_FALSE(solver->add({{{NAN, 0, 0}, {}, {}}}).ok());
  AirState state;
  state.bricks = {{0, 0, 0}};
  EXPECT_FALSE(solver->restore(state).ok());
}

}  // namespace
}  // namespace spin
