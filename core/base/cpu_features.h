// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// Instruction sets that the hot loops are compiled for, from narrow to wide. Baseline is what every x86-64
/// processor has.
enum class Isa { Baseline, Avx2, Avx512 };

/// "baseline", "avx2" or "avx512".
const char* isaName(Isa isa);

/// Whether this processor and operating system can run it (avx2: AVX2 and FMA; avx512: F, DQ, BW and VL).
bool cpuRuns(Isa isa);

/// All that this processor runs, from narrow to wide.
std::vector<Isa> runnableIsas();

/// The widest of runnableIsas().
Isa bestIsa();

/// Reads auto | avx512 | avx2 | baseline; auto is bestIsa(). Fails with Usage for another word and with
/// Failed where this processor lacks the set.
Result<Isa> chooseIsa(std::string_view request);

}  // namespace spin
