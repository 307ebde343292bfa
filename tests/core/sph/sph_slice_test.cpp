// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"
#include "core/sph/sph_slice_impl.h"
#include "tests/support/sph_contract.h"

namespace spin {
namespace {

using contract::Solver;

/// The processor with the thread-per-particle pair stages: the plain form of the same law.
struct PlainBackend : CpuBackend {
  using CpuBackend::CpuBackend;
};

Solver plainSolver(const SphSliceConfig& config) {
  return std::make_unique<SphSlice<PlainBackend>>(config, PlainBackend(1), PairStages<PlainBackend>{});
}

template <Isa kIsa>
struct IsaTraits {
  static constexpr bool kLongRuns = true;
  static Result<Solver> make(const SphSliceConfig& config) { return makeSphSliceCpu(config, 2, kIsa); }
  static bool available(std::string& why) {
    why = std::string("this processor does not have ") + isaName(kIsa);
    return cpuRuns(kIsa);
  }
};

struct PlainTraits {
  static constexpr bool kLongRuns = false;
  static Result<Solver> make(const SphSliceConfig& config) { return plainSolver(config); }
  static bool available(std::string&) { return true; }
};

}  // namespace

using SphTypes =
    ::testing::Types<PlainTraits, IsaTraits<Isa::Baseline>, IsaTraits<Isa::Avx2>, IsaTraits<Isa::Avx512>>;
namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, SphContract, SphTypes);
}

namespace {

struct Scene {
  SphSliceConfig config;
  std::vector<Vec3d> points, velocities;
};

/// A disordered block that falls on the floor, spray included: sparse rows, full rows, periodic seams.
Scene splash() {
  Scene s;
  s.config = testing::boxConfig(32, 16, 48);
  s.config.viscosity = 1.0;
  s.points = testing::lattice(s.config, 14, 16, 14, 0.3);
  const CounterRandom random{8, 3};
  for (std::uint64_t i = 0; i < 400; ++i)
    s.points.push_back({1.6 * random.uniformDouble(i, 0), 0.8 * random.uniformDouble(i, 1),
                        0.8 + 1.4 * random.uniformDouble(i, 2)});
  s.velocities = testing::randomVelocities(s.points.size(), 0.5);
  return s;
}

std::vector<SphParticle> runScene(Solver solver, const Scene& s, int steps) {
  EXPECT_TRUE(solver->setParticles(s.points, s.velocities).ok());
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(solver->step(s.config.stableTimeStep()).ok());
  return solver->particles();
}

Solver cpuSolver(const SphSliceConfig& config, int threads, Isa isa) {
  Result<Solver> solver = makeSphSliceCpu(config, threads, isa);
  EXPECT_TRUE(solver.ok());
  return std::move(solver).value();
}

TEST(SphSliceTest, ThreadCountDoesNotChangeABit) {
  const Scene s = splash();
  for (const Isa isa : runnableIsas()) {
    const auto one = runScene(cpuSolver(s.config, 1, isa), s, 60);
    for (const int threads : {2, 4}) {
      const auto more = runScene(cpuSolver(s.config, threads, isa), s, 60);
      for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].position, more[i].position) << isaName(isa) << " particle " << i;
        ASSERT_EQ(one[i].velocity, more[i].velocity) << isaName(isa) << " particle " << i;
        ASSERT_EQ(one[i].density, more[i].density) << isaName(isa) << " particle " << i;
      }
    }
  }
}

TEST(SphSliceTest, InstructionSetsAgreeWithThePlainFormWithinRounding) {
  // A few steps, so that the differences of rounding have no time to grow.
  const Scene s = splash();
  const auto plain = runScene(plainSolver(s.config), s, 3);
  double scale = 0.0;
  for (const SphParticle& p : plain) scale = std::max(scale, length(p.pairAcceleration));
  for (const Isa isa : runnableIsas()) {
    const auto packed = runScene(cpuSolver(s.config, 2, isa), s, 3);
    for (std::size_t i = 0; i < plain.size(); ++i) {
      ASSERT_NEAR(packed[i].density, plain[i].density, 1e-5 * s.config.restDensity)
          << isaName(isa) << " " << i;
      ASSERT_LT(length(packed[i].pairAcceleration - plain[i].pairAcceleration), 2e-5 * scale)
          << isaName(isa) << " " << i;
    }
  }
}

TEST(SphSliceTest, ForceOfTwoParticlesIsTheLaw) {
  SphSliceConfig c = testing::boxConfig(8, 8, 8);
  c.floor = c.clampTension = false;
  c.gravity = 0.0;
  c.viscosity = 3.0;
  const double d = 0.7 * c.spacing, h = c.support(), q = d / h, m = c.particleMass();
  const Vec3d relative{0.02, -0.03, 0.01};
  const Solver solver = cpuSolver(c, 1, Isa::Baseline);
  ASSERT_TRUE(solver->setParticles({{0.2, 0.2, 0.2}, {0.2 + d, 0.2, 0.2}}, {relative, {}}).ok());
  ASSERT_TRUE(solver->step(1e-9).ok());
  // Written out independently from the cubic spline's pieces (q < 1/2).
  const double norm = 8.0 / (M_PI * h * h * h);
  const double w0 = norm, w = norm * (6 * q * q * q - 6 * q * q + 1);
  const double slope = norm / h * (18 * q * q - 12 * q);  // dW/dr
  const double density = m * (w0 + w);
  const double pressure = c.soundSpeed * c.soundSpeed * (density - c.restDensity);
  const double push = -m * 2 * pressure / (density * density) * slope;  // along x_i - x_j
  const double drag = m * 2 * c.viscosity / (density * density) * slope / d;
  const Vec3d expected = Vec3d{-push, 0, 0} + relative * drag;
  const auto p = solver->particles();
  EXPECT_NEAR(p[0].density, density, 1e-5 * density);
  EXPECT_LT(length(p[0].pairAcceleration - expected), 1e-4 * length(expected));
  EXPECT_LT(length(p[0].pairAcceleration + p[1].pairAcceleration), 1e-6 * length(expected));
}

TEST(SphSliceTest, RefusesConfigurationsThatCannotBe) {
  const SphSliceConfig good = testing::boxConfig(8, 8, 8);
  ASSERT_TRUE(makeSphSliceCpu(good, 1, Isa::Baseline).ok());
  std::vector<SphSliceConfig> bad(9, good);
  bad[0].spacing = 0.0;
  bad[1].spacing = std::numeric_limits<double>::quiet_NaN();
  bad[2].restDensity = -1.0;
  bad[3].soundSpeed = 0.0;
  bad[4].viscosity = -1.0;
  bad[5].domainMax.x = bad[5].domainMin.x;
  bad[6].domainMax.x += 0.5 * good.spacing;  // periodic, not whole
  bad[7].domainMax.z = 1e6;
  bad[8].gravity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const auto made = makeSphSliceCpu(bad[i], 1, Isa::Baseline);
    ASSERT_FALSE(made.ok()) << i;
    EXPECT_EQ(made.error().kind, ErrorKind::BadInput) << i;
  }
  SphSliceConfig huge = testing::boxConfig(8, 8, 8);
  huge.periodicX = huge.periodicY = false;
  huge.domainMax = {100, 100, 100};
  EXPECT_EQ(makeSphSliceCpu(huge, 1, Isa::Baseline).error().kind, ErrorKind::OutOfResources);
}

TEST(SphSliceTest, UsesNoMoreMemoryThanPromised) {
  const Scene s = splash();
  const Solver solver = cpuSolver(s.config, 1, Isa::Baseline);
  std::vector<Vec3d> many(100000, Vec3d{0.1, 0.1, 0.1});
  ASSERT_TRUE(solver->setParticles(many, {}).ok());
  EXPECT_GT(solver->bytes(), 40u * many.size());
  EXPECT_LE(solver->bytes(), 150u * many.size());
}

TEST(SphSliceTest, StagesAreTimedByName) {
  const Scene s = splash();
  const Solver solver = cpuSolver(s.config, 2, bestIsa());
  ASSERT_TRUE(solver->setParticles(s.points, s.velocities).ok());
  ASSERT_TRUE(solver->step(1e-4).ok());
  for (const char* stage : {"key", "sort", "gather", "cells", "density", "pressure", "force", "integrate"})
    EXPECT_GT(solver->timings().seconds(stage), 0.0) << stage;
}

}  // namespace
}  // namespace spin
