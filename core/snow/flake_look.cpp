// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/flake_look.h"

#include "core/base/check.h"

namespace spin {

namespace isa_baseline {
FlakeLook flakeLook();
}
namespace isa_avx2 {
FlakeLook flakeLook();
}
namespace isa_avx512 {
FlakeLook flakeLook();
}

FlakeLook flakeLookFor(Isa isa) {
  SPIN_CHECK(cpuRuns(isa), "this processor does not have the instruction set");
  switch (isa) {
    case Isa::Avx512:
      return isa_avx512::flakeLook();
    case Isa::Avx2:
      return isa_avx2::flakeLook();
    case Isa::Baseline:
      break;
  }
  return isa_baseline::flakeLook();
}

}  // namespace spin
