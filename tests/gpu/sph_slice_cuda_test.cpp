// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "gpu/sph_slice_cuda.h"
#include "core/base/log.h"
#include "gpu/cuda_device.h"
#include "tests/support/sph_contract.h"

namespace spin {
namespace contract {

struct CudaSphTraits {
  static constexpr bool kLongRuns = true;
  static Result<Solver> make(const SphSliceConfig& config) { return makeSphSliceCuda(config); }
  static bool available(std::string& why) {
    if (!cudaAvailable()) why = cudaDevice().error().text();
    return cudaAvailable();
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Cuda, SphContract, CudaSphTraits);

}  // namespace contract

namespace {

TEST(CudaSliceTest, AgreesWithTheProcessorWithinRounding) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  SphSliceConfig c = testing::boxConfig(32, 16, 48);
  c.viscosity = 1.0;
  const auto points = testing::lattice(c, 14, 16, 14, 0.3);
  const auto velocities = testing::randomVelocities(points.size(), 0.5);
  auto cpu = makeSphSliceCpu(c, 1, Isa::Baseline);
  auto card = makeSphSliceCuda(c);
  ASSERT_TRUE(cpu.ok() && card.ok());
  for (auto* solver : {cpu->get(), card->get()}) {
    ASSERT_TRUE(solver->setParticles(points, velocities).ok());
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(solver->step(c.stableTimeStep()).ok());
  }
  const auto a = (*cpu)->particles(), b = (*card)->particles();
  double scale = 0.0;
  for (const SphParticle& p : a) scale = std::max(scale, length(p.pairAcceleration));
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_NEAR(b[i].density, a[i].density, 1e-5 * c.restDensity) << i;
    ASSERT_LT(length(b[i].pairAcceleration - a[i].pairAcceleration), 2e-5 * scale) << i;
  }
}

TEST(CudaSliceTest, RunsRepeatBitForBit) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  const SphSliceConfig c = testing::boxConfig(16, 16, 32);
  const auto points = testing::lattice(c, 16, 16, 10, 0.3);
  std::vector<SphParticle> first;
  for (int run = 0; run < 2; ++run) {
    auto solver = makeSphSliceCuda(c);
    ASSERT_TRUE(solver.ok() && (*solver)->setParticles(points, {}).ok());
    for (int k = 0; k < 50; ++k) ASSERT_TRUE((*solver)->step(c.stableTimeStep()).ok());
    const auto now = (*solver)->particles();
    if (run == 0) first = now;
    for (std::size_t i = 0; i < now.size(); ++i) ASSERT_EQ(now[i].position, first[i].position) << i;
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
  const auto made = makeSphSliceCuda(testing::boxConfig(8, 8, 8));
  ASSERT_EQ(made.ok(), cudaAvailable());
  if (made.ok()) {
    EXPECT_EQ(cudaDevice()->backend.rfind("cuda-sm", 0), 0u);
  } else {
    EXPECT_NE(made.error().text().find("CUDA cannot be used"), std::string::npos);
  }
}

}  // namespace
}  // namespace spin
