// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/flow_walls_contract.h"

namespace spin {
namespace {

/// Solids act in stages that all instruction sets share; one is enough.
struct BestIsaWalls {
  static Result<std::unique_ptr<FlowSolver>> make(const FlowConfig& config) {
    return makeFlowSolverCpu(config, 2, bestIsa());
  }
  static bool available(std::string&) { return true; }
};

}  // namespace

namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, FlowWallsContract, BestIsaWalls);
}
}  // namespace spin
