// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/flow_loop.h"

#include "core/base/check.h"

namespace spin {

namespace isa_baseline {
FlowLoops flowLoops();
}
namespace isa_avx2 {
FlowLoops flowLoops();
}
namespace isa_avx512 {
FlowLoops flowLoops();
}

FlowLoops flowLoopsFor(Isa isa) {
  SPIN_CHECK(cpuRuns(isa), "this processor does not have the instruction set");
  switch (isa) {
    case Isa::Avx512:
      return isa_avx512::flowLoops();
    case Isa::Avx2:
      return isa_avx2::flowLoops();
    case Isa::Baseline:
      break;
  }
  return isa_baseline::flowLoops();
}

}  // namespace spin
