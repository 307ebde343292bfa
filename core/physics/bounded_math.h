// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "core/math/scalar_ops.h"

/// Exponential, logarithm and hyperbolic tangent from sums, products, quotients and roots alone, so that one
/// text serves a number, a pack and CUDA with the same rounding in every instruction set.
namespace spin {

/// A constant in the scalar of a law; packs are made of floats.
template <class V>
SPIN_HD_INLINE V lit(double x) {
  if constexpr (std::is_same_v<V, double>)
    return x;
  else
    return V(static_cast<float>(x));
}

template <class V>
SPIN_HD_INLINE V clampBetween(V x, V least, V most) {
  return minimum(maximum(x, least), most);
}

/// exp(x) for |x| <= 16, held at its ends beyond: relative error below 5e-6. The series runs on x / 32,
/// five squarings bring it back.
template <class V>
SPIN_HD_INLINE V boundedExp(V x) {
  const V y = clampBetween(x, lit<V>(-16.0), lit<V>(16.0)) * lit<V>(1.0 / 32.0);
  V p = lit<V>(1.0 / 5040.0);
  p = mulAdd(p, y, lit<V>(1.0 / 720.0));
  p = mulAdd(p, y, lit<V>(1.0 / 120.0));
  p = mulAdd(p, y, lit<V>(1.0 / 24.0));
  p = mulAdd(p, y, lit<V>(1.0 / 6.0));
  p = mulAdd(p, y, lit<V>(0.5));
  p = mulAdd(p, y, lit<V>(1.0));
  p = mulAdd(p, y, lit<V>(1.0));
  for (int i = 0; i < 5; ++i) p = p * p;
  return p;
}

/// ln(x) for 1 <= x <= 1e7, held at its ends beyond: error below 1e-5. Five roots bring x below 1.66, where
/// the series of the area tangent converges fast.
template <class V>
SPIN_HD_INLINE V boundedLog(V x) {
  V y = clampBetween(x, lit<V>(1.0), lit<V>(1e7));
  for (int i = 0; i < 5; ++i) y = squareRoot(y);
  const V s = (y - lit<V>(1.0)) / (y + lit<V>(1.0));
  const V s2 = s * s;
  V p = lit<V>(1.0 / 9.0);
  p = mulAdd(p, s2, lit<V>(1.0 / 7.0));
  p = mulAdd(p, s2, lit<V>(1.0 / 5.0));
  p = mulAdd(p, s2, lit<V>(1.0 / 3.0));
  p = mulAdd(p, s2, lit<V>(1.0));
  return lit<V>(64.0) * s * p;
}

/// tanh(x) for x >= 0, error below 5e-6.
template <class V>
SPIN_HD_INLINE V positiveTanh(V x) {
  return lit<V>(1.0) - lit<V>(2.0) / (boundedExp(x + x) + lit<V>(1.0));
}

}  // namespace spin
