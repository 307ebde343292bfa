// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flow_implicit_contract.h"

#include "core/base/parallel.h"
#include "core/sph/flow_solver_impl.h"

namespace spin {
namespace {

using contract::Solver;

/// The thread-per-particle passes on the processor.
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

using ImplicitTypes =
    ::testing::Types<PlainTraits, IsaTraits<Isa::Baseline>, IsaTraits<Isa::Avx2>, IsaTraits<Isa::Avx512>>;
namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowImplicitContract, ImplicitTypes);
}

namespace {

/// A disordered block that falls on rough ground: implicit pressure, with the viscosity asked for.
struct Scene {
  FlowConfig config;
  std::vector<FlowParticle> particles;
};
Scene splash(ViscosityMode viscosity) {
  Scene s;
  s.config = testing::boxConfig(32, 16, 48);
  s.config.pressure = PressureMode::Implicit;
  s.config.viscosity = viscosity;
  s.config.smoothing = 0.2;
  s.config.walls.surfaces[0] = {WallFriction::Coulomb, 0.4f};
  Rheology& r = s.config.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = viscosity == ViscosityMode::Implicit ? 100.0f : 1.0f;
  r.exponent = 0.8f;
  r.cohesion = 2.0f;
  r.most = viscosity == ViscosityMode::Implicit ? 500.0f : 5.0f;
  s.particles = testing::lattice(s.config, 14, 16, 14, 0.2, {0, 0, s.config.spacing});
  testing::stir(s.particles, 0.5);
  testing::wrap(s.config, s.particles);
  return s;
}

std::vector<FlowSample> runScene(Solver solver, const Scene& s, int steps) {
  EXPECT_TRUE(solver->add(s.particles).ok());
  for (int k = 0; k < steps; ++k) EXPECT_TRUE(solver->step(1e-3).ok());
  return solver->samples();
}

Solver cpuSolver(const FlowConfig& config, int threads, Isa isa) {
  Result<Solver> solver = makeFlowSolverCpu(config, threads, isa);
  EXPECT_TRUE(solver.ok());
  return std::move(solver).value();
}

TEST(FlowImplicitTest, ThreadCountDoesNotChangeABit) {
  for (const ViscosityMode viscosity : {ViscosityMode::Stress, ViscosityMode::Implicit}) {
    const Scene s = splash(viscosity);
    const auto one = runScene(cpuSolver(s.config, 1, bestIsa()), s, 20);
    for (const int threads : {2, 4}) {
      const auto more = runScene(cpuSolver(s.config, threads, bestIsa()), s, 20);
      ASSERT_EQ(one.size(), more.size());
      for (std::size_t i = 0; i < one.size(); ++i) {
        ASSERT_EQ(one[i].particle.position, more[i].particle.position) << i;
        ASSERT_EQ(one[i].particle.velocity, more[i].particle.velocity) << i;
        ASSERT_EQ(one[i].pressure, more[i].pressure) << i;
      }
    }
  }
}

TEST(FlowImplicitTest, InstructionSetsAgreeWithThePlainFormWithinRounding) {
  for (const ViscosityMode viscosity :
       {ViscosityMode::Pairwise, ViscosityMode::Stress, ViscosityMode::Implicit}) {
    const Scene s = splash(viscosity);
    const auto plain = runScene(plainSolver(s.config), s, 3);
    double pressure = 0.0;
    for (const FlowSample& p : plain) pressure = std::max(pressure, p.pressure);
    for (const Isa isa : runnableIsas()) {
      const auto packed = runScene(cpuSolver(s.config, 2, isa), s, 3);
      ASSERT_EQ(packed.size(), plain.size());
      for (std::size_t i = 0; i < plain.size(); ++i) {
        ASSERT_LT(length(packed[i].particle.velocity - plain[i].particle.velocity), 1e-3)
            << isaName(isa) << " " << i;
        ASSERT_NEAR(packed[i].pressure, plain[i].pressure, 1e-3 * pressure) << isaName(isa) << " " << i;
      }
    }
  }
}

TEST(FlowImplicitTest, RefusesWhatTheImplicitPressureCannotDo) {
  FlowConfig good = testing::boxConfig(8, 8, 8);
  good.pressure = PressureMode::Implicit;
  ASSERT_TRUE(makeFlowSolverCpu(good, 1, Isa::Baseline).ok());
  std::vector<FlowConfig> bad(6, good);
  bad[0].density = DensityMode::Continuity;
  bad[1].leapFrog = true;
  bad[2].densityError = 0.0;
  bad[3].mostIterations = 0;
  bad[4].courantFlow = 2.0;
  bad[5].viscosityError = 0.5;
  for (const FlowConfig& config : bad) EXPECT_FALSE(makeFlowSolverCpu(config, 1, Isa::Baseline).ok());
}

TEST(FlowImplicitTest, StagesOfTheSolvesAreTimedByName) {
  const Scene s = splash(ViscosityMode::Implicit);
  const Solver solver = cpuSolver(s.config, 2, bestIsa());
  ASSERT_TRUE(solver->add(s.particles).ok());
  ASSERT_TRUE(solver->step(1e-3).ok());
  for (const char* stage :
       {"density", "pressure", "shear rate", "force", "viscosity solve", "pressure solve"})
    EXPECT_GT(solver->timings().seconds(stage), 0.0) << stage;
}

}  // namespace
}  // namespace spin
