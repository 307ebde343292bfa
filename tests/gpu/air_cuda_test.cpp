// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"
#include "gpu/air_solver_cuda.h"
#include "gpu/cuda_device.h"

namespace spin {
namespace {

/// A warm, misty, then dense puff over a hill, in bricks that come and go.
AirConfig hill() {
  AirConfig c;
  c.cell = 0.5;
  c.lowBrick = {0, 0, 0};
  c.highBrick = {6, 16, 16};
  c.wind = [](Vec3d p) { return Vec3d{1.0 + 0.05 * p.z, 0.0, 0.0}; };
  c.viscosity = 0.01;
  c.settling = {0.02, 0.3};
  c.tolerance = 1e-5;
  c.solids.push_back({[](Vec3d p) {
                        const double x = p.x - 24.0, y = p.y - 16.0;
                        return 0.9 * (p.z - 6.0 * std::exp(-(x * x + y * y) / 60.0) - 1.0);
                      },
                      {}});
  return c;
}

Status run(AirSolver& solver, int steps) {
  for (int k = 0; k < steps; ++k) {
    std::vector<AirSource> sources;
    for (int i = 0; i < 64; ++i)
      sources.push_back({{14.0 + 0.25 * (i % 4), 15.0 + 0.25 * (i / 4 % 4), 5.0 + 0.25 * (i / 16)},
                         {0.001, k > 3 ? 0.05 : 0.0, 0.05, 0.0005},
                         {0.01, 0.0, 0.02}});
    if (const Status added = solver.add(sources); !added) return added;
    std::vector<AirDrag> drops;
    for (int i = 0; i < 32; ++i) drops.push_back({{12.0 + 0.3 * i, 16.0, 8.0}, {0.0, 0.0, -5.0}, 0.01, 3.0});
    if (const Status dragged = solver.drag(drops, 0.04); !dragged) return dragged;
    const auto done = solver.step(0.04);
    if (!done) return done.error();
  }
  return {};
}

TEST(CudaAirTest, AgreesWithTheProcessor) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  auto cpu = makeAirSolverCpu(hill(), CpuBackend(2), Isa::Baseline);
  auto card = makeAirSolverCuda(hill());
  ASSERT_TRUE(cpu.ok() && card.ok());
  ASSERT_TRUE(run(**cpu, 12).ok());
  ASSERT_TRUE(run(**card, 12).ok());
  const AirState a = (*cpu)->state(), b = (*card)->state();
  ASSERT_EQ(a.bricks, b.bricks);
  const std::size_t cells = a.bricks.size() * kBrickCells;
  for (std::size_t f = 0; f < 7; ++f) {
    double largest = 1e-9, apart = 0.0;
    for (std::size_t k = f * cells; k < (f + 1) * cells; ++k) {
      largest = std::max(largest, std::abs(static_cast<double>(a.values[k])));
      apart = std::max(apart, std::abs(static_cast<double>(a.values[k] - b.values[k])));
    }
    EXPECT_LT(apart, 2e-3 * largest) << "field " << f;
  }
  const AirBudget x = (*cpu)->budget(), y = (*card)->budget();
  for (std::size_t s = 0; s < kAirScalars; ++s) {
    EXPECT_NEAR(x.present[s], y.present[s], 1e-4 * std::abs(x.added[s]) + 1e-9);
    EXPECT_NEAR(x.deposited[s], y.deposited[s], 1e-3 * std::abs(x.added[s]) + 1e-9);
  }
}

TEST(CudaAirTest, RunsRepeatBitForBit) {
  if (!cudaAvailable()) GTEST_SKIP() << cudaDevice().error().text();
  std::vector<float> first;
  for (int k = 0; k < 2; ++k) {
    auto card = makeAirSolverCuda(hill());
    ASSERT_TRUE(card.ok() && run(**card, 6).ok());
    const AirState s = (*card)->state();
    if (k == 0) first = s.values;
    EXPECT_EQ(first, s.values);
  }
}

}  // namespace
}  // namespace spin
