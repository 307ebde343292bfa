// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/sph/flow_solver.h"

namespace spin::contract {

using Solver = std::unique_ptr<FlowSolver>;

/// Starts and runs solvers of one device or instruction set: Traits has `static Result<Solver> make(config)`
/// and `static bool available(std::string& why)`.
template <class Traits>
class FlowRuns : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string why;
    if (!Traits::available(why)) GTEST_SKIP() << why;
  }
  static Solver start(const FlowConfig& config, const std::vector<FlowParticle>& particles) {
    Result<Solver> made = Traits::make(config);
    if (!made) throw std::runtime_error(made.error().text());
    const Status added = (*made)->add(particles);
    if (!added) throw std::runtime_error(added.error().text());
    return std::move(made).value();
  }
  static double run(FlowSolver& solver, double most, int steps) {
    double seconds = 0.0;
    for (int s = 0; s < steps; ++s) {
      const Result<FlowStep> done = solver.step(most);
      if (!done) throw std::runtime_error(done.error().text());
      seconds += done->seconds;
    }
    return seconds;
  }
  static void runFor(FlowSolver& solver, double seconds) {
    while (seconds > 1e-9) seconds -= run(solver, seconds, 1);
  }
};

}  // namespace spin::contract
