// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/pair_loop.h"

#include "core/base/check.h"

namespace spin {

namespace isa_baseline {
PairLoops pairLoops();
}
namespace isa_avx2 {
PairLoops pairLoops();
}
namespace isa_avx512 {
PairLoops pairLoops();
}

PairLoops pairLoopsFor(Isa isa) {
  SPIN_CHECK(cpuRuns(isa), "this processor does not have the instruction set");
  switch (isa) {
    case Isa::Avx512:
      return isa_avx512::pairLoops();
    case Isa::Avx2:
      return isa_avx2::pairLoops();
    case Isa::Baseline:
      break;
  }
  return isa_baseline::pairLoops();
}

}  // namespace spin
