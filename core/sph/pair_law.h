// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/kernels.h"

/// What happens between two particles, written once for every instruction set and for CUDA: T is a number or
/// a pack of lanes. Distances are in units of the support radius.
namespace spin {

template <class T>
struct PairVector {
  T x, y, z;
};

/// Summand of the density, without its factor: shape(q). A particle counts itself.
template <class T>
SPIN_HD_INLINE T densityTerm(const PairVector<T>& d) {
  const T q2 = mulAdd(d.z, d.z, mulAdd(d.y, d.y, d.x * d.x));
  return CubicSpline::shape(squareRoot(q2));
}

/// Adds the acceleration of i by j: symmetric pressure force -(p_i/rho_i^2 + p_j/rho_j^2) m grad W
/// (Monaghan 1992) and pairwise viscosity 2 mu m / (rho_i rho_j) (grad W . x / r^2) (v_i - v_j) (Morris et
/// al. 1997, whose r^2 cancels here). Both are odd in i and j: momentum is conserved.
/// `toOther` is x_j - x_i; `pressureTerms` the sum of both; `drag` is
/// viscosityFactor / (rho_i rho_j); `relative` is v_i - v_j.
template <class T>
SPIN_HD_INLINE void addPairForce(const PairVector<T>& toOther, T pressureTerms, T drag,
                                 const PairVector<T>& relative, PairVector<T>& sum) {
  const T q2 = mulAdd(toOther.z, toOther.z, mulAdd(toOther.y, toOther.y, toOther.x * toOther.x));
  const T slope = CubicSpline::slopeOverQ(squareRoot(q2));
  const T push = pressureTerms * slope;
  const T pull = drag * slope;
  sum.x = mulAdd(pull, relative.x, mulAdd(push, toOther.x, sum.x));
  sum.y = mulAdd(pull, relative.y, mulAdd(push, toOther.y, sum.y));
  sum.z = mulAdd(pull, relative.z, mulAdd(push, toOther.z, sum.z));
}

}  // namespace spin
