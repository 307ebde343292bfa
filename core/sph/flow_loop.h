// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/cpu_features.h"
#include "core/sph/flow_view.h"

namespace spin {

/// The pair passes of one instruction set over the sorted particles [begin, end). Arrays must be readable for
/// kPairPadding elements past their end.
struct FlowLoops {
  using Loop = void (*)(const FlowView& view, std::uint32_t begin, std::uint32_t end);
  Loop density = nullptr;
  Loop shear = nullptr;
  Loop force[2][2] = {};          ///< [smooth][continuity]
  Loop solve[kSolvePasses] = {};  ///< by SolvePass
};

/// The loops built for a set; the caller has asked cpuRuns().
FlowLoops flowLoopsFor(Isa isa);

}  // namespace spin
