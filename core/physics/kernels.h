// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/math/scalar_ops.h"

/// Smoothing kernels W(r) = norm / h^3 * shape(q), q = r / h, h the support radius, in three dimensions.
/// A shape is what changes from pair to pair; its factor is applied once per particle (or once per step).
/// T is a number or a pack (core/math/simd_pack.h). Shapes and slopes are zero for q >= 1.
namespace spin {

/// Cubic spline, W = (8 / pi h^3) (2 (1 - q)^3_+ - 8 (1/2 - q)^3_+): Monaghan 1992 in the form of Koschier et
/// al. 2019, with both pieces written as one truncated power each.
struct CubicSpline {
  static constexpr double kNorm = 8.0 / kPi;

  template <class T>
  SPIN_HD_INLINE static T shape(T q) {
    const T a = maximum(T(1.0f) - q, T(0.0f));
    const T b = maximum(T(0.5f) - q, T(0.0f));
    return mulAdd(T(2.0f) * a, a * a, T(-8.0f) * b * (b * b));
  }

  /// shape'(q) / q, finite at q = 0: grad W = norm / h^5 * slopeOverQ * (x_i - x_j).
  template <class T>
  SPIN_HD_INLINE static T slopeOverQ(T q) {
    const T inside = minimum(q, T(1.0f));
    const T inner = mulAdd(T(18.0f), inside, T(-12.0f));
    const T outer = T(-6.0f) * (T(1.0f) / maximum(inside, T(0.5f)) + (inside - T(2.0f)));
    return selectLess(inside, T(0.5f), inner, outer);
  }

  /// Integral of W over a plane at distance s h from the centre, times h; s of either sign.
  /// Integrated in closed form from shape().
  template <class T>
  SPIN_HD_INLINE static T planeIntegral(T s) {
    const T distance = maximum(s, -s);
    const T a = maximum(T(1.0f) - distance, T(0.0f));
    const T b = maximum(T(0.5f) - distance, T(0.0f));
    const T a2 = a * a, b2 = b * b;
    return T(16.0f) * (a2 * a2 * mulAdd(T(-0.4f), a, T(0.5f)) + b2 * b2 * mulAdd(T(1.6f), b, T(-1.0f)));
  }

  /// Integral of W over the half-space beyond a plane at distance s h; s < 0 when the centre lies inside it:
  /// 1/2 at s = 0, 0 from s = 1, 1 below s = -1.
  template <class T>
  SPIN_HD_INLINE static T halfSpaceIntegral(T s) {
    const T distance = maximum(s, -s);
    const T a = maximum(T(1.0f) - distance, T(0.0f));
    const T b = maximum(T(0.5f) - distance, T(0.0f));
    const T a2 = a * a, b2 = b * b;
    const T outside = T(16.0f) * (a2 * a2 * a * mulAdd(T(-1.0f / 15.0f), a, T(0.1f)) +
                                  b2 * b2 * b * mulAdd(T(4.0f / 15.0f), b, T(-0.2f)));
    return selectLess(s, T(0.0f), T(1.0f) - outside, outside);
  }

  /// Integral of halfSpaceIntegral() from s to 1, s >= 0.
  template <class T>
  SPIN_HD_INLINE static T halfSpaceMoment(T s) {
    const T a = maximum(T(1.0f) - s, T(0.0f));
    const T b = maximum(T(0.5f) - s, T(0.0f));
    const T a3 = a * a * a, b3 = b * b * b;
    return T(16.0f) * (a3 * a3 * mulAdd(T(-1.0f / 105.0f), a, T(1.0f / 60.0f)) +
                       b3 * b3 * mulAdd(T(4.0f / 105.0f), b, T(-1.0f / 30.0f)));
  }
};

/// poly6 of Mueller et al. 2003, eq. 20: needs no square root; for densities. Its gradient vanishes at the
/// centre, so it is none for pressure.
struct Poly6 {
  static constexpr double kNorm = 315.0 / (64.0 * kPi);

  /// Takes q squared.
  template <class T>
  SPIN_HD_INLINE static T shapeOfSquare(T q2) {
    const T a = maximum(T(1.0f) - q2, T(0.0f));
    return a * a * a;
  }
  /// shape'(q) / q, of q squared: grad W = norm / h^5 * slopeOverQ * (x_i - x_j).
  template <class T>
  SPIN_HD_INLINE static T slopeOverQOfSquare(T q2) {
    const T a = maximum(T(1.0f) - q2, T(0.0f));
    return T(-6.0f) * a * a;
  }
};

/// Spiky kernel of Desbrun and Gascuel 1996 as used by Mueller et al. 2003: for pressure gradients only, its
/// sum over a lattice is far from one (1.24 at two spacings).
struct Spiky {
  static constexpr double kNorm = 15.0 / kPi;

  template <class T>
  SPIN_HD_INLINE static T shape(T q) {
    const T a = maximum(T(1.0f) - q, T(0.0f));
    return a * a * a;
  }
  /// shape'(q); the gradient at q = 0 has no direction, the caller divides by a q it keeps above zero.
  template <class T>
  SPIN_HD_INLINE static T slope(T q) {
    const T a = maximum(T(1.0f) - q, T(0.0f));
    return T(-3.0f) * a * a;
  }
};

/// Viscosity kernel of Mueller et al. 2003, eq. 22: made for its Laplacian, which is positive everywhere and
/// linear; the shape itself has a pole at the centre and is no density.
struct ViscosityKernel {
  static constexpr double kNorm = 15.0 / (2.0 * kPi);

  /// q > 0.
  template <class T>
  SPIN_HD_INLINE static T shape(T q) {
    const T inside = minimum(q, T(1.0f));
    return mulAdd(inside * inside, mulAdd(T(-0.5f), inside, T(1.0f)), T(0.5f) / inside - T(1.0f));
  }
  /// shape'(q), q > 0.
  template <class T>
  SPIN_HD_INLINE static T slope(T q) {
    const T inside = minimum(q, T(1.0f));
    return mulAdd(inside, mulAdd(T(-1.5f), inside, T(2.0f)), T(-0.5f) / (inside * inside));
  }
  /// Laplacian of the shape; of W it is norm / h^5 times that.
  template <class T>
  SPIN_HD_INLINE static T laplacian(T q) {
    return T(6.0f) * maximum(T(1.0f) - q, T(0.0f));
  }
};

}  // namespace spin
