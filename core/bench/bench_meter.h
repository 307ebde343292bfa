// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include "core/bench/bench_case.h"

namespace spin {

/// Measures one row: wall time and the highest resident memory of the process since construction. The
/// kernel's high-water mark is reset first (Linux, /proc/self/clear_refs), so that a row does not inherit the
/// peak of an earlier one; where that is not allowed the mark of the whole process is reported.
class BenchMeter {
 public:
  BenchMeter();
  double seconds() const;
  /// Writes seconds and peakBytes of the row.
  void finish(BenchRow& row) const;

 private:
  std::chrono::steady_clock::time_point m_start;
};

/// High-water mark of the resident memory in bytes since the last reset.
double peakResidentBytes();
/// Resident memory now, bytes.
double residentBytes();
/// Sets the mark to the present size. False where the system does not allow it.
bool resetPeakResidentBytes();

}  // namespace spin
