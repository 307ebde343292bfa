// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/cpu_features.h"
#include "core/sph/slice_view.h"

namespace spin {

/// The two pair passes of one instruction set over rows [rowBegin, rowEnd). Arrays must be readable for
/// kPairPadding elements past their end.
struct PairLoops {
  void (*density)(const SliceView& view, std::uint32_t rowBegin, std::uint32_t rowEnd);
  void (*force)(const SliceView& view, std::uint32_t rowBegin, std::uint32_t rowEnd);
};

/// The loops built for a set; the caller has asked cpuRuns().
PairLoops pairLoopsFor(Isa isa);

}  // namespace spin
