// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/bounded_math.h"

/// Sine and cosine of angles in turns, from sums and products alone, so that one text serves a number, a pack
/// and CUDA.
namespace spin {

/// The nearest whole number for |x| < 4e6: a number of 1.5 * 2^23 (of doubles 1.5 * 2^52) has no fraction.
template <class V>
SPIN_HD_INLINE V nearestWhole(V x) {
  const V magic = lit<V>(std::is_same_v<V, double> ? 6755399441055744.0 : 12582912.0);
  return (x + magic) - magic;
}

/// The largest whole number that is not above x, or the one below it where x is whole by a rounding.
template <class V>
SPIN_HD_INLINE V wholeBelow(V x) {
  return nearestWhole(x - lit<V>(0.5));
}

/// sin(2 pi x): error below 4e-9 and the scalar's own rounding of x. The coefficients are a least-squares fit
/// over a quarter of a turn.
template <class V>
SPIN_HD_INLINE V turnSine(V x) {
  const V r = x - nearestWhole(x);
  const V y = minimum(maximum(r, lit<V>(-0.5) - r), lit<V>(0.5) - r);
  const V y2 = y * y;
  V p = lit<V>(39.53576999786988);
  p = mulAdd(p, y2, lit<V>(-76.54965079075426));
  p = mulAdd(p, y2, lit<V>(81.60099791798186));
  p = mulAdd(p, y2, lit<V>(-41.34165492479648));
  p = mulAdd(p, y2, lit<V>(6.283185159591733));
  return p * y;
}
template <class V>
SPIN_HD_INLINE V turnCosine(V x) {
  return turnSine(x + lit<V>(0.25));
}

}  // namespace spin
