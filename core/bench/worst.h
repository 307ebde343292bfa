// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace spin {

/// The larger of two errors; a NaN stays, so that it misses its bar instead of being passed over.
inline double worse(double a, double b) {
  return a >= b || a != a ? a : b;
}

}  // namespace spin
