// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/scalar_ops.h"

namespace spin {

/// Linear state equation p = c^2 (rho - rho0), Pa, from excess = rho / rho0 - 1: the density is kept as its
/// excess because c^2 (rho - rho0) would cancel most digits of a float.
template <class T>
SPIN_HD_INLINE T linearPressure(T excess, T restDensity, T soundSpeed) {
  return restDensity * soundSpeed * soundSpeed * excess;
}

/// Tait's equation p = rho0 c^2/gamma ((rho/rho0)^gamma - 1) with gamma = 7 (Monaghan 1994), Pa, from excess.
/// The power is expanded, so that small excesses keep their digits.
template <class T>
SPIN_HD_INLINE T taitPressure(T excess, T restDensity, T soundSpeed) {
  // ((1 + e)^7 - 1) / e
  T sum = excess + T(7.0f);
  sum = sum * excess + T(21.0f);
  sum = sum * excess + T(35.0f);
  sum = sum * excess + T(35.0f);
  sum = sum * excess + T(21.0f);
  sum = sum * excess + T(7.0f);
  return restDensity * soundSpeed * soundSpeed / T(7.0f) * excess * sum;
}

/// Negative pressure pulls particles together (tensile instability); free-surface flows clamp it, and what
/// coheres bears a little of it: `strength` >= 0, Pa.
template <class T>
SPIN_HD_INLINE T clampTension(T pressure, T strength) {
  return maximum(pressure, T(0.0f) - strength);
}

}  // namespace spin
