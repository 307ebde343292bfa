// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/support/flow_contract.h"

/// What the implicit pressure and the other forms of viscosity must do on every device and instruction set;
/// instantiate FlowImplicitContract as FlowContract.
namespace spin::contract {

template <class Traits>
class FlowImplicitContract : public FlowContract<Traits> {
 protected:
  /// Momentum and the sum of its sizes, of all that lives.
  struct Momentum {
    Vec3d sum{};
    double size = 0.0;
  };
  static Momentum momentumOf(const FlowSolver& solver, const FlowConfig& c) {
    Momentum all;
    for (const FlowSample& s : solver.samples()) {
      const double mass = c.particleMass(s.particle.material);
      all.sum += s.particle.velocity * mass;
      all.size += length(s.particle.velocity) * mass;
    }
    return all;
  }
  static double rmsSpeed(const FlowSolver& solver) {
    double squares = 0.0;
    for (const FlowSample& s : solver.samples()) squares += dot(s.particle.velocity, s.particle.velocity);
    return std::sqrt(squares / static_cast<double>(solver.count()));
  }
  /// Water that fills a box, periodic along all axes, stirred.
  static FlowConfig fullBox() {
    FlowConfig c = testing::freeConfig(12, 12, 12);
    c.domainMin = {};
    c.periodic[2] = true;
    return c;
  }
  static FlowStep stepOnce(FlowSolver& solver, double most) {
    const Result<FlowStep> done = solver.step(most);
    if (!done) throw std::runtime_error(done.error().text());
    return *done;
  }
};
TYPED_TEST_SUITE_P(FlowImplicitContract);

TYPED_TEST_P(FlowImplicitContract, AColumnAtRestStands) {
  const int layers = 12;
  for (const bool sticks : {false, true}) {
    FlowConfig c = testing::boxConfig(8, 8, 24);
    c.pressure = PressureMode::Implicit;
    c.materials[0].rheology.viscosity = 20.0f;
    if (!sticks) c.walls.surfaces[0].friction = WallFriction::FreeSlip;
    const double depth = layers * c.spacing;
    const Solver solver = this->start(c, testing::lattice(c, 8, 8, layers));
    this->runFor(*solver, 1.0);
    double top = 0.0, low = 1.0, weight = 0.0;
    constexpr int kMeans = 20;
    for (int k = 0; k < kMeans; ++k) {
      this->run(*solver, 1.0, 1);
      for (const FlowSample& s : solver->samples()) weight += s.pressure / kMeans;
    }
    for (const FlowSample& s : solver->samples()) {
      top = std::max(top, s.particle.position.z);
      low = std::min(low, s.particle.position.z);
    }
    EXPECT_NEAR(top + 0.5 * c.spacing, depth, c.spacing) << sticks;
    EXPECT_GT(low, 0.0) << sticks;
    EXPECT_LT(this->rmsSpeed(*solver), 0.02 * std::sqrt(9.80665 * depth)) << sticks;
    // On the average over the column the pressure is half of that at the floor.
    EXPECT_NEAR(weight / static_cast<double>(solver->count()), 0.5 * 9806.65 * depth, 0.1 * 9806.65 * depth);
  }
}

TYPED_TEST_P(FlowImplicitContract, CompressionStaysWithinItsError) {
  // A block that falls on the floor and spreads: after the impact, too.
  for (const double error : {0.01, 0.001}) {
    if (!TypeParam::kLongRuns && error < 0.005) continue;
    FlowConfig c = testing::boxConfig(24, 16, 40);
    c.pressure = PressureMode::Implicit;
    c.densityError = error;
    const Solver solver = this->start(c, testing::lattice(c, 10, 10, 10, 0.0, {0, 0, 2 * c.spacing}));
    double largest = 0.0, t = 0.0;
    for (int steps = 0; t < 0.4; ++steps) {
      const FlowStep done = this->stepOnce(*solver, 0.4 - t + 1e-6);
      t += done.seconds;
      ASSERT_LT(steps, 1000);
      if (t > 0.02) largest = std::max(largest, done.compression);
      EXPECT_GE(done.largestCompression, done.compression);
      EXPECT_TRUE(done.pressure.reached) << t;
    }
    // The impact itself goes a little beyond what is asked of the accurate one.
    EXPECT_LT(largest, error < 0.005 ? 2.5 * error : error) << error;
    EXPECT_GT(largest, 0.0);
  }
}

TYPED_TEST_P(FlowImplicitContract, SolvesConserveMomentum) {
  for (const ViscosityMode viscosity :
       {ViscosityMode::Pairwise, ViscosityMode::Stress, ViscosityMode::Implicit}) {
    FlowConfig c = this->fullBox();
    c.pressure = PressureMode::Implicit;
    c.viscosity = viscosity;
    c.materials[0].rheology.viscosity = viscosity == ViscosityMode::Implicit ? 500.0f : 1.0f;
    c.materials.push_back(c.materials[0]);
    c.materials[1].restDensity = 400.0;
    auto particles = testing::lattice(c, 12, 12, 12, 0.15);
    testing::stir(particles, 1.0);
    testing::wrap(c, particles);
    for (std::size_t i = 0; i < particles.size(); i += 3) particles[i].material = 1;
    Vec3d before{};
    double size = 0.0;
    for (const FlowParticle& p : particles) {
      before += p.velocity * c.particleMass(p.material);
      size += length(p.velocity) * c.particleMass(p.material);
    }
    const Solver solver = this->start(c, particles);
    for (int s = 0; s < 10; ++s) {
      const FlowStep done = this->stepOnce(*solver, 1.0);
      EXPECT_EQ(done.viscosity, viscosity);
      EXPECT_GT(done.pressure.iterations, 0);
      EXPECT_EQ(done.viscous.iterations > 0, viscosity == ViscosityMode::Implicit);
    }
    const auto after = this->momentumOf(*solver, c);
    EXPECT_LT(length(after.sum - before), 1e-6 * size) << static_cast<int>(viscosity);
  }
}

TYPED_TEST_P(FlowImplicitContract, ABreakingDamIsStableAtTheStepOfItsFlow) {
  if (!TypeParam::kLongRuns) GTEST_SKIP() << "too slow in this form";
  FlowConfig c = testing::boxConfig(60, 16, 60);
  c.periodic[0] = false;
  c.pressure = PressureMode::Implicit;
  c.domainMin.x = -4 * c.spacing;
  const double end = 2.0;
  c.walls.planes = {
      {{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 0}, {1, 0, 0}, {}, 0}, {{end, 0, 0}, {-1, 0, 0}, {}, 0}};
  c.walls.surfaces[0].friction = WallFriction::FreeSlip;
  const Solver solver = this->start(c, testing::lattice(c, 16, 16, 16));
  const auto energy = [&] {
    double sum = 0.0;
    for (const FlowSample& s : solver->samples())
      sum += 0.5 * dot(s.particle.velocity, s.particle.velocity) + 9.80665 * s.particle.position.z;
    return sum / static_cast<double>(solver->count());
  };
  const double before = 0.5 * 9.80665 * 16 * c.spacing;
  int steps = 0, byFlow = 0;
  for (double t = 0.0; t < 0.8; ++steps) {
    const FlowStep done = this->stepOnce(*solver, 1.0);
    t += done.seconds;
    byFlow += done.limit == StepLimit::Flow;
    ASSERT_LT(done.compression, 0.01) << t;
    ASSERT_LT(steps, 600);
    if (steps % 20 == 0) {
      ASSERT_LT(energy(), 1.03 * before) << t;
    }
  }
  EXPECT_GT(byFlow, steps / 2);
  EXPECT_EQ(solver->count(), 16u * 16u * 16u);
}

TYPED_TEST_P(FlowImplicitContract, AnIterationLimitIsReported) {
  FlowConfig c = testing::boxConfig(8, 8, 40);
  c.pressure = PressureMode::Implicit;
  c.viscosity = ViscosityMode::Implicit;
  c.materials[0].rheology.viscosity = 1000.0f;
  c.densityError = 1e-5;
  c.viscosityError = 1e-6;
  c.mostIterations = 2;
  auto particles = testing::lattice(c, 8, 8, 20);
  testing::stir(particles, 1.0);
  const Solver solver = this->start(c, particles);
  const FlowStep done = this->stepOnce(*solver, 1e-3);
  EXPECT_FALSE(done.pressure.reached);
  EXPECT_EQ(done.pressure.iterations, 2);
  EXPECT_GT(done.pressure.error, 0.0);
  EXPECT_FALSE(done.viscous.reached);
  EXPECT_EQ(done.viscous.iterations, 2);
}

TYPED_TEST_P(FlowImplicitContract, StatesThatAreNotFiniteStopTheSolve) {
  FlowConfig c = testing::freeConfig(8, 8, 8);
  c.pressure = PressureMode::Implicit;
  c.viscosity = ViscosityMode::Implicit;
  auto particles = testing::lattice(c, 4, 4, 4);
  particles[17].velocity = {3e38, 3e38, 0};
  const Solver solver = this->start(c, particles);
  const Result<FlowStep> done = solver->step(1e-3);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().where.find("particle 17"), std::string::npos) << done.error().text();
  EXPECT_NE(done.error().where.find("stage"), std::string::npos) << done.error().text();
}

TYPED_TEST_P(FlowImplicitContract, ImplicitViscosityIsTheExplicitOneForSmallSteps) {
  // Both forms of the same force: what differs is of second order in the step.
  FlowConfig c = this->fullBox();
  c.clampTension = true;
  c.materials[0].soundSpeed = 0.01;
  c.materials[0].rheology.viscosity = 5.0f;
  auto particles = testing::lattice(c, 12, 12, 12);
  testing::stir(particles, 0.1);
  c.viscosityError = 1e-6;
  const double limit = 0.125 * c.spacing * c.spacing / 0.005, step = 0.02 * limit;
  std::vector<FlowSample> change[2];
  for (const bool implicit : {false, true}) {
    c.viscosity = implicit ? ViscosityMode::Implicit : ViscosityMode::Pairwise;
    const Solver solver = this->start(c, particles);
    this->run(*solver, step, 1);
    change[implicit] = solver->samples();
  }
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec3d a = change[0][i].particle.velocity, b = change[1][i].particle.velocity;
    difference += dot(a - b, a - b);
    size += dot(a - particles[i].velocity, a - particles[i].velocity);
  }
  ASSERT_GT(size, 0.0);
  EXPECT_LT(std::sqrt(difference / size), 0.02);
}

TYPED_TEST_P(FlowImplicitContract, AStiffFluidMovesAsOneAtAThousandTimesTheViscousStep) {
  FlowConfig c = testing::freeConfig(16, 16, 16);
  c.pressure = PressureMode::Implicit;
  c.viscosity = ViscosityMode::Implicit;
  c.viscosityError = 1e-4;
  c.mostIterations = 1000;
  auto particles = testing::lattice(c, 8, 8, 8, 0.0, {0.2, 0.2, 0.2});
  testing::stir(particles, 0.5);
  Vec3d mean{};
  for (FlowParticle& p : particles) p.velocity += Vec3d{0.3, -0.1, 0.2}, mean += p.velocity;
  mean = mean / static_cast<double>(particles.size());
  const double step = 0.002, viscous = step / 1000.0;
  c.materials[0].rheology.viscosity = static_cast<float>(0.125 * c.spacing * c.spacing / viscous * 1000.0);
  const Solver solver = this->start(c, particles);
  for (int s = 0; s < 20; ++s) EXPECT_TRUE(this->stepOnce(*solver, step).viscous.reached);
  double apart = 0.0;
  Vec3d after{};
  for (const FlowSample& s : solver->samples()) {
    after += s.particle.velocity;
    apart = std::max(apart, length(s.particle.velocity - mean));
  }
  // What is left is a turn of the whole.
  EXPECT_LT(apart, 0.1);
  EXPECT_LT(length(after / static_cast<double>(particles.size()) - mean), 1e-5);
}

TYPED_TEST_P(FlowImplicitContract, AWallThatSticksStopsAStiffFluid) {
  for (const PressureMode pressure : {PressureMode::EquationOfState, PressureMode::Implicit}) {
    FlowConfig c = testing::boxConfig(8, 8, 24);
    c.pressure = pressure;
    c.viscosity = ViscosityMode::Implicit;
    c.materials[0].rheology.viscosity = 1e5f;
    auto particles = testing::lattice(c, 8, 8, 8);
    for (FlowParticle& p : particles) p.velocity.x = 1.0;
    const Solver solver = this->start(c, particles);
    this->run(*solver, 1e-3, 30);
    for (const FlowSample& s : solver->samples()) ASSERT_LT(std::abs(s.particle.velocity.x), 0.01);
  }
}

TYPED_TEST_P(FlowImplicitContract, FluidsBelowTheirYieldStayWhereTheyAre) {
  // On ground that pulls sideways with half of what the yield stress holds: creeps, but does not flow.
  if (!TypeParam::kLongRuns) GTEST_SKIP() << "too slow in this form";
  FlowConfig c = testing::boxConfig(8, 8, 24);
  c.pressure = PressureMode::Implicit;
  c.viscosity = ViscosityMode::Auto;
  Rheology& r = c.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = 10.0f;
  r.cohesion = 1000.0f;
  r.regularisation = 1000.0f;
  c.densityError = 0.001;
  c.gravity = {500.0 / (1000.0 * 8 * c.spacing), 0, -9.80665};
  const Solver solver = this->start(c, testing::lattice(c, 8, 8, 8));
  const FlowStep first = this->stepOnce(*solver, 1.0);
  EXPECT_EQ(first.viscosity, ViscosityMode::Implicit);
  this->runFor(*solver, 1.0);
  double creep = 0.0;
  for (const FlowSample& s : solver->samples()) creep = std::max(creep, std::abs(s.particle.velocity.x));
  EXPECT_LT(creep, 5e-3);
  c.gravity.x *= 4.0;  // and flows above
  const Solver flows = this->start(c, testing::lattice(c, 8, 8, 8));
  this->runFor(*flows, 0.2);
  double speed = 0.0;
  for (const FlowSample& s : flows->samples()) speed = std::max(speed, s.particle.velocity.x);
  EXPECT_GT(speed, 0.05);
}

TYPED_TEST_P(FlowImplicitContract, SlidingPlatesGiveALinearProfileInEveryForm) {
  if (!TypeParam::kLongRuns) GTEST_SKIP() << "too slow in this form";
  const int across = 16;
  for (const ViscosityMode viscosity : {ViscosityMode::Stress, ViscosityMode::Implicit})
    for (const PressureMode pressure : {PressureMode::EquationOfState, PressureMode::Implicit}) {
      if (viscosity == ViscosityMode::Stress && pressure == PressureMode::Implicit) continue;
      FlowConfig c = testing::boxConfig(8, 8, across + 4);
      c.spacing = 1.0 / across;
      c.domainMin = {0, 0, -0.2};
      c.domainMax = {8 * c.spacing, 8 * c.spacing, 1.2};
      c.clampTension = pressure == PressureMode::Implicit;
      c.gravity = {};
      c.pressure = pressure;
      c.viscosity = viscosity;
      c.materials[0].rheology.viscosity = 1000.0f;
      c.materials[0].soundSpeed = 15.0;
      c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, 0}};
      auto particles = testing::lattice(c, 8, 8, across);
      for (FlowParticle& p : particles) p.velocity.x = p.position.z;
      const Solver solver = this->start(c, particles);
      for (double t = 0.0; t < 0.1;) t += this->run(*solver, 0.01, 1);
      double squares = 0.0, scale = 0.0;
      for (const FlowSample& s : solver->samples()) {
        const double u = s.particle.position.z;
        squares += (s.particle.velocity.x - u) * (s.particle.velocity.x - u);
        scale += u * u;
      }
      EXPECT_LT(std::sqrt(squares / scale), 0.025)
          << static_cast<int>(viscosity) << " " << static_cast<int>(pressure);
    }
}

TYPED_TEST_P(FlowImplicitContract, FluidThatFillsItsRoomIsNotPressedIntoALattice) {
  // Driven between plates, from a disordered start and the exact profile. What the solve asks for beyond
  // constant volume is a pressure without limit, and a fluid that is too stiff: 1e5 Pa and 14 % once.
  if (!TypeParam::kLongRuns) GTEST_SKIP() << "too slow in this form";
  const int across = 16;
  FlowConfig c = testing::boxConfig(8, 8, across + 4);
  c.spacing = 1.0 / across;
  c.domainMin = {0, 0, -0.2};
  c.domainMax = {8 * c.spacing, 8 * c.spacing, 1.2};
  c.clampTension = false;
  c.gravity = {8, 0, 0};
  c.pressure = PressureMode::Implicit;
  c.materials[0].rheology.viscosity = 1000.0f;
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 1}, {0, 0, -1}, {}, 0}};
  const auto exact = [](double z) { return 4.0 * z * (1.0 - z); };
  auto particles = testing::lattice(c, 8, 8, across, 0.1);
  for (FlowParticle& p : particles) p.velocity.x = exact(p.position.z);
  const Solver solver = this->start(c, particles);
  this->runFor(*solver, 0.4);
  double squares = 0.0, scale = 0.0, level = 0.0;
  for (const FlowSample& s : solver->samples()) {
    const double u = exact(s.particle.position.z);
    squares += (s.particle.velocity.x - u) * (s.particle.velocity.x - u);
    scale += u * u;
    level += s.pressure / static_cast<double>(solver->count());
  }
  EXPECT_LT(std::sqrt(squares / scale), 0.05);
  // rho u^2 of the fastest is 1000 Pa.
  EXPECT_LT(std::abs(level), 5000.0);
}

TYPED_TEST_P(FlowImplicitContract, AutoTakesTheImplicitFormOnlyWhereItPays) {
  FlowConfig c = testing::freeConfig(8, 8, 8);
  c.viscosity = ViscosityMode::Auto;
  const auto particles = testing::lattice(c, 8, 8, 4, 0.0, {0, 0, 0.1});
  for (const float stiff : {1.0f, 1e4f}) {
    c.materials[0].rheology.viscosity = stiff;
    const Solver solver = this->start(c, particles);
    const FlowStep done = this->stepOnce(*solver, 1.0);
    EXPECT_EQ(done.viscosity, stiff > 10.0f ? ViscosityMode::Implicit : ViscosityMode::Pairwise);
    EXPECT_EQ(done.limit, StepLimit::Sound);
  }
}

REGISTER_TYPED_TEST_SUITE_P(FlowImplicitContract, AColumnAtRestStands, CompressionStaysWithinItsError,
                            SolvesConserveMomentum, ABreakingDamIsStableAtTheStepOfItsFlow,
                            AnIterationLimitIsReported, StatesThatAreNotFiniteStopTheSolve,
                            ImplicitViscosityIsTheExplicitOneForSmallSteps,
                            AStiffFluidMovesAsOneAtAThousandTimesTheViscousStep,
                            AWallThatSticksStopsAStiffFluid, FluidsBelowTheirYieldStayWhereTheyAre,
                            SlidingPlatesGiveALinearProfileInEveryForm,
                            FluidThatFillsItsRoomIsNotPressedIntoALattice,
                            AutoTakesTheImplicitFormOnlyWhereItPays);

}  // namespace spin::contract
