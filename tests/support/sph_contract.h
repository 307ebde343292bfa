// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/sph_scenes.h"

/// What the solver's slice must do on every device and instruction set, one text for all: instantiate
/// SphContract with a struct that has `static Result<Solver> make(config)` and
/// `static bool available(std::string& why)`.
namespace spin::contract {

using Solver = std::unique_ptr<SphSliceSolver>;

template <class Traits>
class SphContract : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    if (!Traits::available(why)) GTEST_SKIP() << why;
  }
  static Solver start(const SphSliceConfig& config, const std::vector<Vec3d>& positions,
                      const std::vector<Vec3d>& velocities = {}) {
    Result<Solver> made = Traits::make(config);
    if (!made) throw std::runtime_error(made.error().text());
    const Status set = (*made)->setParticles(positions, velocities);
    if (!set) throw std::runtime_error(set.error().text());
    return std::move(made).value();
  }
  static void run(SphSliceSolver& solver, double timeStep, int steps) {
    for (int s = 0; s < steps; ++s) {
      const Status ok = solver.step(timeStep);
      if (!ok) throw std::runtime_error(ok.error().text());
    }
  }
};
TYPED_TEST_SUITE_P(SphContract);

TYPED_TEST_P(SphContract, LatticeHasItsDensityWithinOnePercent) {
  SphSliceConfig c = testing::boxConfig(12, 12, 24);
  c.gravity = 0.0;
  c.floor = false;
  const Solver solver = this->start(c, testing::lattice(c, 12, 12, 24));
  this->run(*solver, 1e-9, 1);
  int inner = 0;
  for (const SphParticle& p : solver->particles()) {
    if (p.position.z < 3 * c.spacing || p.position.z > 21 * c.spacing) continue;
    ASSERT_NEAR(p.density / c.restDensity, 1.0, 0.01);
    ++inner;
  }
  EXPECT_EQ(inner, 12 * 12 * 18);
}

TYPED_TEST_P(SphContract, FloorReplacesTheMissingHalfOfTheDensity) {
  SphSliceConfig c = testing::boxConfig(12, 12, 24);
  const Solver solver = this->start(c, testing::lattice(c, 12, 12, 12));
  this->run(*solver, 1e-9, 1);
  for (const SphParticle& p : solver->particles()) {
    if (p.position.z > c.spacing) continue;
    // Half-space integral: 3 to 4 % above the bulk; without it the first layer lacks 15 % and more.
    ASSERT_GT(p.density / c.restDensity, 1.0);
    ASSERT_LT(p.density / c.restDensity, 1.05);
  }
}

TYPED_TEST_P(SphContract, PairForcesConserveMomentum) {
  SphSliceConfig c = testing::boxConfig(16, 16, 16);
  c.gravity = 0.0;
  c.floor = false;
  c.viscosity = 5.0;
  const std::vector<Vec3d> points = testing::lattice(c, 16, 16, 10, 0.3);
  const Solver solver = this->start(c, points, testing::randomVelocities(points.size(), 1.0));
  this->run(*solver, 1e-4, 1);
  Vec3d sum{};
  double size = 0.0;
  for (const SphParticle& p : solver->particles()) {
    sum += p.pairAcceleration;
    size += length(p.pairAcceleration);
  }
  ASSERT_GT(size, 1.0);
  EXPECT_LT(length(sum), 1e-6 * size);
}

TYPED_TEST_P(SphContract, ViscosityTakesEnergyAndKeepsMomentum) {
  SphSliceConfig c = testing::boxConfig(12, 12, 12);
  c.gravity = 0.0;
  c.floor = false;
  c.soundSpeed = 1.0;
  c.viscosity = 5.0;
  const std::vector<Vec3d> points = testing::lattice(c, 12, 12, 12);
  const std::vector<Vec3d> velocities = testing::randomVelocities(points.size(), 0.01);
  const Solver solver = this->start(c, points, velocities);
  const auto energyOf = [](const auto& list, const auto& velocityOf) {
    double sum = 0.0;
    for (const auto& item : list) sum += dot(velocityOf(item), velocityOf(item));
    return sum;
  };
  const double before = energyOf(velocities, [](const Vec3d& v) { return v; });
  Vec3d momentum{}, moved{};
  for (const Vec3d& v : velocities) momentum += v;
  this->run(*solver, 0.5 * c.stableTimeStep(), 40);
  const auto after = solver->particles();
  for (const SphParticle& p : after) moved += p.velocity;
  EXPECT_LT(energyOf(after, [](const SphParticle& p) { return p.velocity; }), 0.1 * before);
  EXPECT_LT(length(moved - momentum), 1e-5 * std::sqrt(before * static_cast<double>(points.size())));
}

/// Mean height and pressure of every particle over the samples of a run.
struct ColumnMeans {
  std::vector<double> height, pressure;
  int samples = 0;

  void add(const SphSliceConfig& c, const std::vector<SphParticle>& particles) {
    height.resize(particles.size());
    pressure.resize(particles.size());
    for (std::size_t i = 0; i < particles.size(); ++i) {
      height[i] += particles[i].position.z;
      pressure[i] += c.soundSpeed * c.soundSpeed * (particles[i].density - c.restDensity);
    }
    ++samples;
  }
};

TYPED_TEST_P(SphContract, ColumnSettlesToHydrostaticPressure) {
  if (!TypeParam::kLongRuns) GTEST_SKIP() << "too slow in this form";
  SphSliceConfig c = testing::boxConfig(8, 8, 32);
  c.viscosity = 300.0;
  const int layers = 16;
  const Solver solver = this->start(c, testing::lattice(c, 8, 8, layers, 0.2));
  this->run(*solver, c.stableTimeStep(), 2500);
  // The column still rings a little: means over several of its acoustic periods (4 H / c = 0.16 s).
  ColumnMeans means;
  for (; means.samples < 150; means.add(c, solver->particles())) this->run(*solver, c.stableTimeStep(), 10);

  const double depth = layers * c.spacing, scale = c.restDensity * c.gravity * depth;
  double squares = 0.0;
  int counted = 0;
  for (std::size_t i = 0; i < means.height.size(); ++i) {
    const double z = means.height[i] / means.samples;
    ASSERT_TRUE(std::isfinite(z));
    EXPECT_GT(z, -0.1 * c.spacing);
    EXPECT_LT(z, depth + c.spacing);
    if (z > depth - 2.0 * c.spacing) continue;  // the free surface, where density lacks neighbours
    const double exact = c.restDensity * c.gravity * (depth - z);
    const double error = (means.pressure[i] / means.samples - exact) / scale;
    squares += error * error;
    ++counted;
  }
  ASSERT_GE(counted, 8 * 8 * (layers - 3));
  const double rms = std::sqrt(squares / counted);
  ::testing::Test::RecordProperty("pressure_rms_percent", std::to_string(100.0 * rms));
  // 3.7 % of rho g H at 16 spacings and support 2; without the wall's own pressure term it is 24 % and more.
  EXPECT_LT(rms, 0.05);
  double speed = 0.0;
  for (const SphParticle& p : solver->particles()) speed += dot(p.velocity, p.velocity);
  EXPECT_LT(std::sqrt(speed / static_cast<double>(means.height.size())), 0.02 * std::sqrt(c.gravity * depth));
}

TYPED_TEST_P(SphContract, MovingThePatternByWholeCellsChangesNothing) {
  SphSliceConfig c = testing::boxConfig(40, 12, 24);
  c.periodicX = c.periodicY = false;
  const std::vector<Vec3d> points = testing::lattice(c, 8, 8, 8, 0.2);
  std::vector<Vec3d> far = points;
  for (Vec3d& p : far) p.x += 10 * c.support();
  const Solver near = this->start(c, points), away = this->start(c, far);
  this->run(*near, c.stableTimeStep(), 5);
  this->run(*away, c.stableTimeStep(), 5);
  const auto a = near->particles(), b = away->particles();
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i].velocity, b[i].velocity) << i;
}

TYPED_TEST_P(SphContract, ParticlesBeyondTheBoxStillMeet) {
  SphSliceConfig c = testing::boxConfig(8, 8, 8);
  c.periodicX = c.periodicY = c.floor = false;
  c.gravity = 0.0;
  const double d = c.spacing;
  const std::vector<Vec3d> pairs = {{-3, -3, -3},  {-3 + d, -3, -3}, {9, 9, 9},
                                    {9, 9, 9 + d}, {9, -3, 2},       {9, -3, 2}};
  const Solver solver = this->start(c, pairs);
  this->run(*solver, 1e-9, 1);
  const auto p = solver->particles();
  const double self = 1.0 / M_PI, beside = 0.25 / M_PI;  // (m norm / rho0 h^3) shape(q) at q = 0 and 1/2
  for (int i : {0, 1, 2, 3}) EXPECT_NEAR(p[i].density / c.restDensity, self + beside, 1e-5) << i;
  for (int i : {4, 5}) EXPECT_NEAR(p[i].density / c.restDensity, 2 * self, 1e-5) << i;
}

TYPED_TEST_P(SphContract, PeriodicNeighboursAreSeenAcrossTheSeam) {
  SphSliceConfig c = testing::boxConfig(8, 8, 8);
  c.floor = false;
  c.gravity = 0.0;
  const double d = c.spacing, length = c.domainMax.x;
  const std::vector<Vec3d> points = {{0.25 * d, 0.1, 0.2},
                                     {length - 0.75 * d, 0.1, 0.2},
                                     {0.2, 0.25 * d, 0.05},
                                     {0.2, length - 0.75 * d, 0.05}};
  const Solver solver = this->start(c, points);
  this->run(*solver, 1e-9, 1);
  for (const SphParticle& p : solver->particles())
    EXPECT_NEAR(p.density / c.restDensity, 1.25 / M_PI, 1e-5) << p.position.x << " " << p.position.y;
}

TYPED_TEST_P(SphContract, CrowdsLargerThanABatchAreSummedWhole) {
  // 3000 particles on one spot: every one sees all.
  SphSliceConfig c = testing::boxConfig(8, 8, 8);
  c.floor = false;
  const Solver solver = this->start(c, std::vector<Vec3d>(3000, Vec3d{0.2, 0.2, 0.2}));
  this->run(*solver, 1e-9, 1);
  for (const SphParticle& p : solver->particles())
    ASSERT_NEAR(p.density / c.restDensity * M_PI / 3000, 1.0, 1e-4);
}

TYPED_TEST_P(SphContract, NothingToDoIsFine) {
  const SphSliceConfig c = testing::boxConfig(8, 8, 8);
  const Solver solver = this->start(c, {});
  this->run(*solver, 1e-3, 2);
  EXPECT_TRUE(solver->particles().empty());
}

TYPED_TEST_P(SphContract, RefusesWhatIsNotFinite) {
  const SphSliceConfig c = testing::boxConfig(8, 8, 8);
  Result<Solver> solver = TypeParam::make(c);
  ASSERT_TRUE(solver.ok());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE((*solver)->setParticles({{nan, 0, 0}}, {}).ok());
  EXPECT_FALSE((*solver)->setParticles({{0, 1e9, 0}}, {}).ok());
  EXPECT_FALSE((*solver)->setParticles({{0, 0, 0}}, {{0, nan, 0}}).ok());
  EXPECT_FALSE((*solver)->setParticles({{0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}).ok());
}

REGISTER_TYPED_TEST_SUITE_P(SphContract, LatticeHasItsDensityWithinOnePercent,
                            FloorReplacesTheMissingHalfOfTheDensity, PairForcesConserveMomentum,
                            ViscosityTakesEnergyAndKeepsMomentum, ColumnSettlesToHydrostaticPressure,
                            MovingThePatternByWholeCellsChangesNothing, ParticlesBeyondTheBoxStillMeet,
                            PeriodicNeighboursAreSeenAcrossTheSeam, CrowdsLargerThanABatchAreSummedWhole,
                            NothingToDoIsFine, RefusesWhatIsNotFinite);

}  // namespace spin::contract
