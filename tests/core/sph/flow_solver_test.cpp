// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/sph/flow_solver_impl.h"
#include "tests/support/flow_cells_contract.h"
#include "tests/support/flow_contract.h"
#include "tests/support/flow_state_contract.h"

namespace spin {
namespace {

using contract::Solver;

/// The processor with the thread-per-particle passes: the plain form of the same law.
struct PlainBackend : CpuBackend {
  using CpuBackend::CpuBackend;
};

Solver plainSolver(const FlowConfig& config) {
  return std::make_unique<FlowSolverOn<PlainBackend>>(config, PlainBackend(1), FlowPasses<PlainBackend>{});
}

template <Isa kIsa>
struct IsaTraits {
  static constexpr bool kLongRuns = true;
  static Result<Solver> make(const FlowConfig& config) { return makeFlowSolverCpu(config, 2, kIsa); }
  static bool available(std::string& why) {
    why = std::string("this processor does not have ") + isaName(kIsa);
    return cpuRuns(kIsa);
  }
};

struct PlainTraits {
  static constexpr bool kLongRuns = false;
  static Result<Solver> make(const FlowConfig& config) { return plainSolver(config); }
  static bool available(std::string&) { return true; }
};

}  // namespace

using FlowTypes =
    ::testing::Types<PlainTraits, IsaTraits<Isa::Baseline>, IsaTraits<Isa::Avx2>, IsaTraits<Isa::Avx512>>;
namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowContract, FlowTypes);
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowCellsContract, FlowTypes);
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowStateContract, FlowTypes);
}  // namespace contract

namespace {

struct Scene {
  FlowConfig config;
  std::vector<FlowParticle> particles;
};

/// A disordered block that falls on the floor, spray included: sparse rows, full rows, periodic seams, all
/// that pairs do.
Scene splash() {
  Scene s;
  s.config = testing::boxConfig(32, 16, 48);
  s.config.smoothing = 0.2;
  Rheology& r = s.config.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = 1.0f;
  r.exponent = 0.8f;
  r.cohesion = 2.0f;
  r.frictionTangent = 0.1f;
  r.most = 5.0f;
  s.particles = testing::lattice(s.config, 14, 16, 14, 0.3, {0, 0, s.config.spacing});
  const CounterRandom random{8, 3};
  for (std::uint64_t i = 0; i < 400; ++i) {
    FlowParticle p;
    p.position = {1.6 * random.uniformDouble(i, 0), 0.8 * random.uniformDouble(i, 1),
                  0.8 + 1.4 * random.uniformDouble(i, 2)};
    s.particles.push_back(p);
  }
  testing::stir(s.particles, 0.5);
  testing::wrap(s.config, s.particles);
  return s;
}

std::vector<FlowSample> runScene(Solver solver, const Scene& s, int steps) {
  EXPECT_TRUE(solver->add(s.particles).ok());
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(solver->step(1.0).ok());
  return solver->samples();
}

Solver cpuSolver(const FlowConfig& config, int threads, Isa isa) {
  Result<Solver> solver = makeFlowSolverCpu(config, threads, isa);
  EXPECT_TRUE(solver.ok());
  return std::move(solver).value();
}

TEST(FlowSolverTest, ThreadCountDoesNotChangeABit) {
  Scene s = splash();
  s.config.density = DensityMode::Continuity;
  for (const Isa isa : runnableIsas()) {
    const auto one = runScene(cpuSolver(s.config, 1, isa), s, 60);
    for (const int threads : {2, 4}) {
      const auto more = runScene(cpuSolver(s.config, threads, isa), s, 60);
      ASSERT_EQ(one.size(), more.size());
      for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].particle.position, more[i].particle.position) << isaName(isa) << " particle " << i;
        ASSERT_EQ(one[i].particle.velocity, more[i].particle.velocity) << isaName(isa) << " particle " << i;
        ASSERT_EQ(one[i].density, more[i].density) << isaName(isa) << " particle " << i;
        ASSERT_EQ(one[i].shearRate, more[i].shearRate) << isaName(isa) << " particle " << i;
      }
    }
  }
}

TEST(FlowSolverTest, InstructionSetsAgreeWithThePlainFormWithinRounding) {
  // A few steps, so that the differences of rounding have no time to grow.
  for (const DensityMode mode : {DensityMode::Summation, DensityMode::Continuity}) {
    Scene s = splash();
    s.config.density = mode;
    const auto plain = runScene(plainSolver(s.config), s, 3);
    double scale = 0.0, rate = 0.0;
    for (const FlowSample& p : plain)
      scale = std::max(scale, length(p.pairAcceleration)), rate = std::max(rate, p.shearRate);
    for (const Isa isa : runnableIsas()) {
      const auto packed = runScene(cpuSolver(s.config, 2, isa), s, 3);
      ASSERT_EQ(packed.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_NEAR(packed[i].density, plain[i].density, 1e-2) << isaName(isa) << " " << i;
        ASSERT_NEAR(packed[i].shearRate, plain[i].shearRate, 2e-4 * rate) << isaName(isa) << " " << i;
        ASSERT_LT(length(packed[i].pairAcceleration - plain[i].pairAcceleration), 5e-5 * scale)
            << isaName(isa) << " " << i;
      }
    }
  }
}

TEST(FlowSolverTest, ForceOfTwoParticlesIsTheLaw) {
  FlowConfig c = testing::freeConfig(8, 8, 8);
  c.clampTension = false;
  c.materials[0].rheology.viscosity = 3.0f;
  const double d = 0.7 * c.spacing, h = c.support(), q = d / h, m = c.particleMass(0), volume = m / 1000.0;
  const Vec3d relative{0.02, -0.03, 0.01};
  std::vector<FlowParticle> two(2);
  two[0].position = two[1].position = {0.2, 0.2, 0.2};
  two[0].velocity = relative;
  two[1].position.x += d;
  const Solver solver = cpuSolver(c, 1, Isa::Baseline);
  ASSERT_TRUE(solver->add(two).ok());
  ASSERT_TRUE(solver->step(1e-9).ok());
  // Written out independently from the cubic spline's pieces (q < 1/2).
  const double norm = 8.0 / (M_PI * h * h * h);
  const double w0 = norm, w = norm * (6 * q * q * q - 6 * q * q + 1);
  const double slope = norm / h * (18 * q * q - 12 * q);  // dW/dr
  const double density = m * (w0 + w);
  const double pressure = 400.0 * (density - 1000.0);
  const double push = -m * 2 * pressure / (density * density) * slope;  // along x_i - x_j
  const double drag = 2 * 3.0 * volume * volume / m * slope / d;
  const Vec3d expected = Vec3d{-push, 0, 0} + relative * drag;
  const auto p = solver->samples();
  EXPECT_NEAR(p[0].density, density, 1e-5 * density);
  EXPECT_LT(length(p[0].pairAcceleration - expected), 1e-4 * length(expected));
  EXPECT_LT(length(p[0].pairAcceleration + p[1].pairAcceleration), 1e-6 * length(expected));
}

TEST(FlowSolverTest, ContinuityGivesAQuietPressureInADeepColumn) {
  // 40 layers, 2 m: 2.5 % of rho g H; by summation it is 5.3 % here.
  const int layers = 40;
  FlowConfig c = testing::boxConfig(8, 8, 64);
  const double depth = layers * c.spacing;
  c.density = DensityMode::Continuity;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(9.80665 * depth);
  c.materials[0].rheology.viscosity = 150.0f;
  auto particles = testing::lattice(c, 8, 8, layers, 0.1);
  testing::wrap(c, particles);
  const Solver solver = cpuSolver(c, 2, bestIsa());
  ASSERT_TRUE(solver->add(particles).ok());
  for (int k = 0; k < 8000; ++k) ASSERT_TRUE(solver->step(1.0).ok());
  contract::ColumnMeans means;
  for (; means.samples < 100; means.add(solver->samples()))
    for (int k = 0; k < 20; ++k) ASSERT_TRUE(solver->step(1.0).ok());
  EXPECT_LT(means.rms(depth, c.spacing, 9806.65), 0.04);
}

TEST(FlowSolverTest, ShearRateOfALinearFlowIsExactAlsoAtTheSurface) {
  // u = rate z above a wall, free surface above: the correction makes up for what is missing there, and at a
  // wall that lets slide.
  for (const WallFriction friction : {WallFriction::NoSlip, WallFriction::Coulomb, WallFriction::FreeSlip})
    for (const double support : {2.0, 3.0}) {
      FlowConfig c = testing::boxConfig(12, 12, 16);
      c.supportSpacings = support;
      c.gravity = {};
      c.walls.surfaces = {{friction, 0.3f}};
      c.materials[0].rheology.law = RheologyLaw::Yield;
      auto particles = testing::lattice(c, 12, 12, 10, 0.1, {0, 0, 0.05 * c.spacing});
      for (FlowParticle& p : particles) p.velocity.x = 3.0 * p.position.z;
      testing::wrap(c, particles);
      const Solver solver = cpuSolver(c, 1, bestIsa());
      ASSERT_TRUE(solver->add(particles).ok());
      ASSERT_TRUE(solver->step(1e-9).ok());
      for (const FlowSample& s : solver->samples())
        ASSERT_NEAR(s.shearRate, 3.0, 0.1)
            << static_cast<int>(friction) << " " << support << " " << s.particle.position.z / c.spacing;
    }
}

TEST(FlowSolverTest, TheStepIsTheLeastOfItsLimitsAndSaysWhich) {
  FlowConfig c = testing::freeConfig(8, 8, 8);
  std::vector<FlowParticle> one(1);
  one[0].position = {0.2, 0.2, 0.2};
  const auto limitOf = [&](double most) {
    const Solver solver = cpuSolver(c, 1, Isa::Baseline);
    EXPECT_TRUE(solver->add(one).ok());
    return *solver->step(most);
  };
  EXPECT_EQ(limitOf(1e-7).limit, StepLimit::Asked);
  EXPECT_EQ(limitOf(1e-7).seconds, 1e-7);
  EXPECT_EQ(limitOf(1.0).limit, StepLimit::Sound);
  EXPECT_NEAR(limitOf(1.0).seconds, 0.25 * 0.05 / 20.0, 1e-8);
  c.materials[0].rheology.viscosity = 1e4f;
  EXPECT_EQ(limitOf(1.0).limit, StepLimit::Viscous);
  EXPECT_NEAR(limitOf(1.0).seconds, 0.125 * 0.05 * 0.05 / 10.0, 1e-9);
  c.materials[0].rheology.viscosity = 0.0f;
  c.gravity = {0, 0, -1e7};
  EXPECT_EQ(limitOf(1.0).limit, StepLimit::Force);
}

TEST(FlowSolverTest, LeapFrogFollowsAThrowExactly) {
  FlowConfig c = testing::boxConfig(8, 8, 200);
  c.walls.planes.clear();
  c.leapFrog = true;
  std::vector<FlowParticle> one(1);
  one[0].position = {0.2, 0.2, 1.0};
  one[0].velocity = {0, 0, 3.0};
  const Solver solver = cpuSolver(c, 1, Isa::Baseline);
  ASSERT_TRUE(solver->add(one).ok());
  double t = 0.0;
  for (int k = 0; k < 500; ++k) t += solver->step(5e-4)->seconds;
  // Second order: exact for a parabola. Semi-implicit Euler is off by g t dt / 2 = 0.6 mm here.
  EXPECT_NEAR(solver->samples()[0].particle.position.z, 1.0 + 3.0 * t - 0.5 * 9.80665 * t * t, 5e-6);
}

TEST(FlowSolverTest, RefusesConfigurationsThatCannotBe) {
  const FlowConfig good = testing::boxConfig(8, 8, 8);
  ASSERT_TRUE(makeFlowSolverCpu(good, 1, Isa::Baseline).ok());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<FlowConfig> bad(17, good);
  bad[0].spacing = 0.0;
  bad[1].spacing = nan;
  bad[2].materials[0].restDensity = -1.0;
  bad[3].materials[0].soundSpeed = 0.0;
  bad[4].materials[0].rheology.viscosity = -1.0f;
  bad[5].domainMax.x = bad[5].domainMin.x;
  bad[6].domainMax.x += 0.5 * good.spacing;  // periodic, not whole
  bad[7].domainMax.z = 1e6;
  bad[8].gravity.z = std::numeric_limits<double>::infinity();
  bad[9].materials.clear();
  bad[10].supportSpacings = 1.0;
  bad[11].walls.planes[0].normal = {};
  bad[12].walls.planes[0].surface = 3;
  bad[13].walls.surfaces.clear();
  bad[14].walls.ground = Raster<float>(4, 4, 0, 0, 1);
  bad[14].walls.groundSurfaces = Raster<std::uint8_t>(3, 4, 0, 0, 1);
  bad[15].smoothing = 1.5;
  bad[16].materials[0].rheology.exponent = static_cast<float>(nan);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const auto made = makeFlowSolverCpu(bad[i], 1, Isa::Baseline);
    ASSERT_FALSE(made.ok()) << i;
    EXPECT_EQ(made.error().kind, ErrorKind::BadInput) << i;
  }
}

TEST(FlowSolverTest, MemoryIsTakenOnlyWhereTheFlowIs) {
  // 100,000 particles in a domain of 1 km: cells of all of it would take gigabytes.
  FlowConfig c;
  c.spacing = 0.25;
  c.domainMax = {1000, 1000, 1000};
  c.density = DensityMode::Continuity;
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}};
  const Solver solver = cpuSolver(c, 2, bestIsa());
  ASSERT_TRUE(solver->add(testing::lattice(c, 100, 100, 10, 0.0, {300, 400, 0})).ok());
  ASSERT_TRUE(solver->step(1.0).ok());
  EXPECT_LE(solver->bytes(), 150u * 100'000u);
  EXPECT_GT(solver->bytes(), 40u * 100'000u);
}

TEST(FlowSolverTest, StagesAreTimedByName) {
  const Scene s = splash();
  const Solver solver = cpuSolver(s.config, 2, bestIsa());
  ASSERT_TRUE(solver->add(s.particles).ok());
  ASSERT_TRUE(solver->step(1e-4).ok());
  for (const char* stage : {"rows", "key", "sort", "gather", "cells", "density", "pressure", "shear rate",
                            "force", "step", "integrate"})
    EXPECT_GT(solver->timings().seconds(stage), 0.0) << stage;
}

}  // namespace
}  // namespace spin
