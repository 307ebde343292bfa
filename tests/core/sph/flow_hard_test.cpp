// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flow_hard_contract.h"

namespace spin::contract {

/// The best instruction set; that all of them agree is tested elsewhere.
struct BestTraits {
  static Result<Solver> make(const FlowConfig& config) { return makeFlowSolverCpu(config, 2, bestIsa()); }
  static bool available(std::string&) { return true; }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowHard, BestTraits);

}  // namespace spin::contract
