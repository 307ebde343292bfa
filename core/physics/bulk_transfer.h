// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/bounded_math.h"

/// Turbulent exchange between a surface and the air by bulk transfer, C = k^2 / (ln(z_u/z0) ln(z_T/z_h))
/// f(Ri) with z_h = z0 / 10 and the stability functions of Louis 1979 / 1982.
namespace spin {

inline constexpr double kVonKarman = 0.4;

template <class V>
struct NeutralTransfer {
  V coefficient;  ///< of heat and vapour, neutral air
  V unstable;     ///< 75 C sqrt(z_u / z0): what bounds the unstable branch
};

/// Heights above the surface and roughness length, m.
template <class V>
SPIN_HD_INLINE NeutralTransfer<V> neutralTransfer(V windHeight, V airHeight, V roughness) {
  const V ratio = windHeight / roughness;
  const V lnWind = boundedLog(ratio);
  const V lnAir = boundedLog(lit<V>(10.0) * airHeight / roughness);
  const V c = lit<V>(kVonKarman * kVonKarman) / (lnWind * lnAir);
  return {c, lit<V>(75.0) * c * squareRoot(ratio)};
}

/// Factor on the neutral coefficient: below 1 over a surface colder than the air (Ri > 0), above 1 over a
/// warmer one.
template <class V>
SPIN_HD_INLINE V stabilityFactor(V richardson, V unstable) {
  const V one = lit<V>(1.0), fifteen = lit<V>(15.0);
  const V up = maximum(richardson, lit<V>(0.0));
  const V down = maximum(-richardson, lit<V>(0.0));
  const V stable = one / (one + fifteen * up * squareRoot(one + lit<V>(5.0) * up));
  return stable + fifteen * down / (one + unstable * squareRoot(down));
}

}  // namespace spin
