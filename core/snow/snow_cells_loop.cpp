// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/check.h"
#include "core/snow/snow_cells_view.h"

namespace spin {

namespace isa_baseline {
SnowCellsLoop snowCellsLoop();
}
namespace isa_avx2 {
SnowCellsLoop snowCellsLoop();
}
namespace isa_avx512 {
SnowCellsLoop snowCellsLoop();
}

SnowCellsLoop snowCellsLoopFor(Isa isa) {
  SPIN_CHECK(cpuRuns(isa), "this processor does not have the instruction set");
  switch (isa) {
    case Isa::Avx512:
      return isa_avx512::snowCellsLoop();
    case Isa::Avx2:
      return isa_avx2::snowCellsLoop();
    case Isa::Baseline:
      break;
  }
  return isa_baseline::snowCellsLoop();
}

}  // namespace spin
