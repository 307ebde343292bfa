// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/bench_case.h"

namespace spin {

// Each case is one file of this folder that defines its function, such as `BenchCase massCase();`, declared
// here and called once in the list below.
BenchCase sphSpeedCase();

const std::vector<BenchCase>& builtInBenchCases() {
  static const std::vector<BenchCase> cases = {
      sphSpeedCase(),
  };
  return cases;
}

}  // namespace spin
