// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/kernels.h"

/// What happens between two particles, written once for every instruction set and for CUDA: T is a number or
/// a pack of lanes. Offsets are x_j - x_i in units of the support radius. All particles have one rest volume
/// V0, so a pair's force is odd in i and j whatever their densities: momentum is conserved.
namespace spin {

template <class T>
struct PairVector {
  T x, y, z;
};

template <class T>
SPIN_HD_INLINE T distanceOf(const PairVector<T>& d) {
  return squareRoot(mulAdd(d.z, d.z, mulAdd(d.y, d.y, d.x * d.x)));
}

/// Summand of the density, without its factor: shape(q). A particle counts itself.
template <class T>
SPIN_HD_INLINE T densityTerm(const PairVector<T>& d) {
  return CubicSpline::shape(distanceOf(d));
}

/// Adds the force on i by j, without factors: symmetric pressure force -V0^2 (P_i + P_j) grad W with P = p
/// rho0^2/rho^2 (Monaghan 1992) and pairwise viscosity V0^2 (mu_i + mu_j) (grad W . x / r^2) (v_i - v_j)
/// (Morris et al. 1997, whose r^2 cancels here). `push` is P_i + P_j, `drag` mu_i + mu_j times the quotient
/// of both factors, `relative` v_i - v_j.
template <class T>
SPIN_HD_INLINE void addPairForce(const PairVector<T>& toOther, T slope, T push, T drag,
                                 const PairVector<T>& relative, PairVector<T>& sum) {
  const T pressure = push * slope;
  const T pull = drag * slope;
  sum.x = mulAdd(pull, relative.x, mulAdd(pressure, toOther.x, sum.x));
  sum.y = mulAdd(pull, relative.y, mulAdd(pressure, toOther.y, sum.y));
  sum.z = mulAdd(pull, relative.z, mulAdd(pressure, toOther.z, sum.z));
}

/// Sums of a particle's velocity gradient: sum V_j (v_j - v_i) (x) grad W, without the factor V0 norm/h^4,
/// and of the matrix sum V_j (x_j - x_i) (x) grad W, without V0 norm/h^3, which is the identity in a full
/// neighbourhood.
template <class T>
struct GradientSums {
  T g[9];  ///< at 3 a + b: component a of the velocity by coordinate b
  T m[6];  ///< xx, yy, zz, xy, xz, yz

  SPIN_HD_INLINE void clear() {
    for (T& value : g) value = T(0.0f);
    for (T& value : m) value = T(0.0f);
  }
  /// `relative` is v_i - v_j. grad W points from j to i where slope is negative: two signs cancel in g.
  SPIN_HD_INLINE void add(const PairVector<T>& d, const PairVector<T>& relative) {
    const T slope = CubicSpline::slopeOverQ(distanceOf(d));
    const PairVector<T> w{slope * d.x, slope * d.y, slope * d.z};
    g[0] = mulAdd(relative.x, w.x, g[0]);
    g[1] = mulAdd(relative.x, w.y, g[1]);
    g[2] = mulAdd(relative.x, w.z, g[2]);
    g[3] = mulAdd(relative.y, w.x, g[3]);
    g[4] = mulAdd(relative.y, w.y, g[4]);
    g[5] = mulAdd(relative.y, w.z, g[5]);
    g[6] = mulAdd(relative.z, w.x, g[6]);
    g[7] = mulAdd(relative.z, w.y, g[7]);
    g[8] = mulAdd(relative.z, w.z, g[8]);
    m[0] = m[0] - d.x * w.x;
    m[1] = m[1] - d.y * w.y;
    m[2] = m[2] - d.z * w.z;
    m[3] = m[3] - d.x * w.y;
    m[4] = m[4] - d.x * w.z;
    m[5] = m[5] - d.y * w.z;
  }
};

}  // namespace spin
