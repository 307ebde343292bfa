// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"
#include "tests/support/flow_bodies_contract.h"
#include "tests/support/flow_cells_contract.h"
#include "tests/support/flow_contract.h"
#include "tests/support/flow_hard_contract.h"
#include "tests/support/flow_implicit_contract.h"
#include "tests/support/flow_state_contract.h"
#include "tests/support/flow_walls_contract.h"

namespace spin {
namespace contract {

struct CudaFlowTraits {
  static constexpr bool kLongRuns = true;
  static Result<Solver> make(const FlowConfig& config) { return makeFlowSolverCuda(config); }
  static bool available(std::string& why) {
    if (!cudaAvailable()) why = cudaDevice().error().text();
    return cudaAvailable();
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowContract, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowWallsContract, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowBodiesContract, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowImplicitContract, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowCellsContract, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowHard, CudaFlowTraits);
INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, FlowStateContract, CudaFlowTraits);

}  // namespace contract

namespace {

TEST(CudaFlowTest, AgreesWithTheProcessorWithinRounding) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  FlowConfig c = testing::boxConfig(32, 16, 48);
  Rheology& r = c.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = 1.0f;
  r.cohesion = 2.0f;
  r.most = 5.0f;
  c.smoothing = 0.2;
  auto particles = testing::lattice(c, 14, 14, 14, 0.3, {c.spacing, c.spacing, c.spacing});
  testing::stir(particles, 0.5);
  auto cpu = makeFlowSolverCpu(c, 1, Isa::Baseline);
  auto card = makeFlowSolverCuda(c);
  ASSERT_TRUE(cpu.ok() && card.ok());
  for (auto* solver : {cpu->get(), card->get()}) {
    ASSERT_TRUE(solver->add(particles).ok());
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(solver->step(1e-4).ok());
  }
  const auto a = (*cpu)->samples(), b = (*card)->samples();
  double scale = 0.0, rate = 0.0;
  for (const FlowSample& s : a)
    scale = std::max(scale, length(s.pairAcceleration)), rate = std::max(rate, s.shearRate);
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_NEAR(b[i].density, a[i].density, 1e-2) << i;
    ASSERT_NEAR(b[i].shearRate, a[i].shearRate, 2e-4 * rate) << i;
    ASSERT_LT(length(b[i].pairAcceleration - a[i].pairAcceleration), 5e-5 * scale) << i;
  }
}

TEST(CudaFlowTest, RunsRepeatBitForBit) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  const FlowConfig c = testing::boxConfig(16, 16, 32);
  const auto particles = testing::lattice(c, 16, 16, 10, 0.0);
  std::vector<FlowSample> first;
  for (int run = 0; run < 2; ++run) {
    auto solver = makeFlowSolverCuda(c);
    ASSERT_TRUE(solver.ok() && (*solver)->add(particles).ok());
    for (int k = 0; k < 50; ++k) ASSERT_TRUE((*solver)->step(1.0).ok());
    const auto now = (*solver)->samples();
    if (run == 0) first = now;
    for (std::size_t i = 0; i < now.size(); ++i)
      ASSERT_EQ(now[i].particle.position, first[i].particle.position) << i;
  }
}

TEST(CudaDeviceTest, ChoiceFallsBackWithANoticeWhereThereIsNoCard) {
  std::string notice;
  setLogSink([&](LogLevel level, std::string_view text) {
    if (level == LogLevel::Warning) notice = text;
  });
  const auto automatic = chooseDevice("auto"), card = chooseDevice("cuda");
  setLogSink({});
  ASSERT_TRUE(automatic.ok() && card.ok());
  EXPECT_EQ(*automatic, *card);
  EXPECT_EQ(*card, cudaAvailable() ? Device::Cuda : Device::Cpu);
  EXPECT_EQ(notice.empty(), cudaAvailable());
  EXPECT_EQ(*chooseDevice("cpu"), Device::Cpu);
  EXPECT_EQ(chooseDevice("tpu").error().kind, ErrorKind::Usage);
}

TEST(CudaDeviceTest, SolverWithoutACardIsAnErrorThatSaysWhy) {
  const auto made = makeFlowSolverCuda(testing::boxConfig(8, 8, 8));
  ASSERT_EQ(made.ok(), cudaAvailable());
  if (made.ok()) {
    EXPECT_EQ(cudaDevice()->backend.rfind("cuda-sm", 0), 0u);
  } else {
    EXPECT_NE(made.error().text().find("CUDA cannot be used"), std::string::npos);
  }
}

}  // namespace
}  // namespace spin
