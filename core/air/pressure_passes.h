// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_loop.h"
#include "core/physics/bounded_math.h"

/// Passes of the projection. The pressure's equation in lattice units is, for every open cell,
///   sum over its faces of c (p - p of the neighbour) = b,   b = -(net outflow of the velocities),
/// with c = open share of the face times the density round the cloud over the face's own; the pressure of
/// closed faces does not count and beyond the bricks it is 0.
namespace spin {

/// One level of the hierarchy: coefficients at lower faces and the inverse of their sum (0 in solids).
struct PressureView {
  AirStrides strides;
  const float *cx = nullptr, *cy = nullptr, *cz = nullptr, *inverse = nullptr;
};

/// Sum over faces of c (p - p of the neighbour).
template <class At>
SPIN_HD_INLINE typename At::Real pressureSum(const PressureView& v, const At& at, const float* p) {
  using Real = typename At::Real;
  const Real own = at.load(p);
  const int y = v.strides.y, z = v.strides.z;
  Real sum = at.load(v.cx) * (own - at.load(p, -1));
  sum = mulAdd(at.load(v.cx, 1), own - at.load(p, 1), sum);
  sum = mulAdd(at.load(v.cy), own - at.load(p, -y), sum);
  sum = mulAdd(at.load(v.cy, y), own - at.load(p, y), sum);
  sum = mulAdd(at.load(v.cz), own - at.load(p, -z), sum);
  return mulAdd(at.load(v.cz, z), own - at.load(p, z), sum);
}

/// 1 where a > 0, else 0.
template <class Real>
SPIN_HD_INLINE Real positive(Real a) {
  return selectLess(lit<Real>(0.0), a, lit<Real>(1.0), lit<Real>(0.0));
}

/// Coefficients of the finest level, over open bricks and those above them along each axis.
struct CoefficientPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float* area[3];  ///< open share of lower faces; negative: a wall of the domain
  const float* open;     ///< 1 in cells that are solved
  const float* load;     ///< density over that round the cloud, less 1; null = 0
  float* to[3];

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    axis(at, 0, 1);
    axis(at, 1, strides.y);
    axis(at, 2, strides.z);
  }

 private:
  template <class At>
  SPIN_HD_INLINE void axis(const At& at, int k, int step) const {
    using Real = typename At::Real;
    const Real solved = maximum(at.load(open), at.load(open, -step));
    Real c = maximum(at.load(area[k]), lit<Real>(0.0)) * solved;
    if (load) c = c / (lit<Real>(1.0) + lit<Real>(0.5) * (at.load(load) + at.load(load, -step)));
    at.store(c, to[k]);
  }
};

struct DiagonalPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float *cx, *cy, *cz;
  const float* solved;  ///< above 0 where a cell is: beside the rim others have faces too
  float* inverse;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real sum = at.load(cx) + at.load(cx, 1) + at.load(cy) + at.load(cy, strides.y) + at.load(cz) +
                     at.load(cz, strides.z);
    const Real least = lit<Real>(1e-6);
    const Real counts = sum * positive(at.load(solved));
    at.store(selectLess(least, counts, lit<Real>(1.0) / maximum(sum, least), lit<Real>(0.0)), inverse);
  }
};

/// Where a coarse cell's children are: cell X of the coarse lattice covers 2 (X - kBrickX) and the next one.
struct CoarseMap {
  AirStrides fine;
  SPIN_HD_INLINE int child(int x, int y, int z) const {
    return 2 * (z - kAirShiftZ) * fine.z + 2 * (y - kAirShiftY) * fine.y + 2 * (x - kAirShiftX);
  }
  static constexpr int kAirShiftX = 16, kAirShiftY = 4, kAirShiftZ = 4;
};

/// Coefficients of a coarser level. A coarse cell stands for its children that are solved, so it is as long
/// along an axis as they are together, and a pressure that grows evenly has to cost as much as on the finer
/// level: the sum of the children's coefficients times the distance of their centres over that of the coarse
/// ones'. Where no cell is solved the pressure is 0, half a cell of the finest level away.
struct CoarsenPass {
  static constexpr AirResult kResult = AirResult::None;
  CoarseMap map;
  const float* c[3];
  const float* inverse;     ///< of the finer level
  const float* lengths[3];  ///< of the finer level's cells, in cells of the finest; null = 1 where solved
  float* to[3];
  float* toLengths[3];

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    const int child = map.child(at.x, at.y, at.z), y = map.fine.y, z = map.fine.z;
    axis(at, 0, child, 1, y, z);
    axis(at, 1, child, y, 1, z);
    axis(at, 2, child, z, 1, y);
  }

 private:
  template <class At>
  SPIN_HD_INLINE typename At::Real childLength(int k, int child) const {
    return lengths[k] ? At::even(lengths[k] + child) : positive(At::even(inverse + child));
  }
  /// Of a coarse cell: of its longest pair of children.
  template <class At>
  SPIN_HD_INLINE typename At::Real coarseLength(int k, int child, int step, int s, int t) const {
    using Real = typename At::Real;
    const auto pair = [&](int at) SPIN_INLINE_LAMBDA {
      return childLength<At>(k, at) + childLength<At>(k, at + step);
    };
    const Real low = maximum(pair(child), pair(child + s)),
               high = maximum(pair(child + t), pair(child + s + t));
    return maximum(low, high);
  }
  /// Between centres; beside what is not solved as from half a cell of the finest level.
  template <class Real>
  SPIN_HD_INLINE static Real apart(Real a, Real b) {
    const Real zero = lit<Real>(0.0), one = lit<Real>(1.0);
    return lit<Real>(0.5) * (selectLess(zero, a, a, one) + selectLess(zero, b, b, one));
  }
  template <class At>
  SPIN_HD_INLINE typename At::Real chain(int k, int child, int step) const {
    return At::even(c[k] + child) * apart(childLength<At>(k, child), childLength<At>(k, child - step));
  }
  template <class At>
  SPIN_HD_INLINE void axis(const At& at, int k, int child, int step, int s, int t) const {
    using Real = typename At::Real;
    const Real own = coarseLength<At>(k, child, step, s, t);
    const Real below = coarseLength<At>(k, child - 2 * step, step, s, t);
    const Real sum = chain<At>(k, child, step) + chain<At>(k, child + s, step) +
                     chain<At>(k, child + t, step) + chain<At>(k, child + s + t, step);
    at.store(sum / apart(own, below), to[k]);
    at.store(own, toLengths[k]);
  }
};

/// Net outflow of a cell, and its negative as the right side; the sum of its squares.
struct AirDivergencePass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float* area[3];
  const float* u[3];
  const float* solidFlux;  ///< outflow by solids' own motion, null = none
  const float* inverse;    ///< 0 where nothing is solved
  float* right;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    Real sum = face(at, 0, 1) - face(at, 0, 0);
    sum = sum + face(at, 1, strides.y) - face(at, 1, 0);
    sum = sum + face(at, 2, strides.z) - face(at, 2, 0);
    if (solidFlux) sum = sum + at.load(solidFlux);
    const Real b = -sum * positive(at.load(inverse));
    at.store(b, right);
    return b * b;
  }

 private:
  template <class At>
  SPIN_HD_INLINE typename At::Real face(const At& at, int k, int offset) const {
    return maximum(at.load(area[k], offset), lit<typename At::Real>(0.0)) * at.load(u[k], offset);
  }
};

/// r = b - A p; sum of squares.
struct ResidualPass {
  static constexpr AirResult kResult = AirResult::Sum;
  PressureView v;
  const float *p, *b;
  float* r;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    const auto left = (at.load(b) - pressureSum(v, at, p)) * positive(at.load(v.inverse));
    at.store(left, r);
    return left * left;
  }
};

/// Two sweeps of damped Jacobi from zero in one.
struct FirstSmoothPass {
  static constexpr AirResult kResult = AirResult::None;
  PressureView v;
  const float* b;
  float* x;
  float first, second;  ///< damping factors

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const int y = v.strides.y, z = v.strides.z;
    const Real own = once(at, 0), inverse = at.load(v.inverse), b0 = at.load(b);
    Real sum = at.load(v.cx) * (own - once(at, -1));
    sum = mulAdd(at.load(v.cx, 1), own - once(at, 1), sum);
    sum = mulAdd(at.load(v.cy), own - once(at, -y), sum);
    sum = mulAdd(at.load(v.cy, y), own - once(at, y), sum);
    sum = mulAdd(at.load(v.cz), own - once(at, -z), sum);
    sum = mulAdd(at.load(v.cz, z), own - once(at, z), sum);
    at.store(mulAdd(Real(second) * inverse, b0 - sum, own), x);
  }

 private:
  template <class At>
  SPIN_HD_INLINE typename At::Real once(const At& at, int offset) const {
    return typename At::Real(first) * at.load(b, offset) * at.load(v.inverse, offset);
  }
};

/// One sweep of damped Jacobi; the sum of its result times b.
struct SmoothPass {
  static constexpr AirResult kResult = AirResult::Sum;
  PressureView v;
  const float *b, *x;
  float* to;
  float damping;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real right = at.load(b);
    const Real next = mulAdd(Real(damping) * at.load(v.inverse), right - pressureSum(v, at, x), at.load(x));
    at.store(next, to);
    return next * right;
  }
};

/// One colour of a Gauss-Seidel sweep; the other colour is copied.
struct ColourPass {
  static constexpr AirResult kResult = AirResult::None;
  PressureView v;
  const float *b, *x;
  float* to;
  int colour;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real own = at.load(x);
    const Real next = mulAdd(at.load(v.inverse), at.load(b) - pressureSum(v, at, x), own);
    // The parity of x + y + z + colour, exact in floats.
    const Real place = at.lanesX() + lit<Real>(static_cast<double>(at.y + at.z + colour));
    const Real half = place * lit<Real>(0.5);
    const Real odd = half - toFloat(toInt(half));
    at.store(selectLess(lit<Real>(0.25), odd, own, next), to);
  }
};

/// Residuals of eight children summed up.
struct RestrictPass {
  static constexpr AirResult kResult = AirResult::None;
  CoarseMap map;
  const float* fine;
  float* coarse;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    const float* p = fine + map.child(at.x, at.y, at.z);
    const int y = map.fine.y, z = map.fine.z;
    at.store(At::pairSum(p) + At::pairSum(p + y) + At::pairSum(p + z) + At::pairSum(p + y + z), coarse);
  }
};

/// Adds the coarse level's correction; over the finer level's bricks.
struct ProlongPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides coarseStrides;
  const float *coarse, *inverse;
  float* x;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    const float* row = coarse + ((at.z >> 1) + CoarseMap::kAirShiftZ) * coarseStrides.z +
                       ((at.y >> 1) + CoarseMap::kAirShiftY) * coarseStrides.y + CoarseMap::kAirShiftX;
    at.store(mulAdd(at.doubled(row), positive(at.load(inverse)), at.load(x)), x);
  }
};

/// s = z + factor s.
struct DirectionPass {
  static constexpr AirResult kResult = AirResult::None;
  const float* z;
  float* s;
  float factor;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    at.store(mulAdd(typename At::Real(factor), at.load(s), at.load(z)), s);
  }
};

/// q = A s; sum of s q.
struct ProductPass {
  static constexpr AirResult kResult = AirResult::Sum;
  PressureView v;
  const float* s;
  float* q;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    const auto product = pressureSum(v, at, s) * positive(at.load(v.inverse));
    at.store(product, q);
    return product * at.load(s);
  }
};

/// x += step s, r -= step q; sum of the squares of r.
struct AdvancePass {
  static constexpr AirResult kResult = AirResult::Sum;
  const float *s, *q;
  float *x, *r;
  float step;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    at.store(mulAdd(Real(step), at.load(s), at.load(x)), x);
    const Real left = mulAdd(Real(-step), at.load(q), at.load(r));
    at.store(left, r);
    return left * left;
  }
};

/// Takes the pressure's gradient off the velocities; over open bricks and those above them.
struct CorrectPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float* area[3];
  const float* c[3];
  const float* p;
  float* u[3];

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    axis(at, 0, 1);
    axis(at, 1, strides.y);
    axis(at, 2, strides.z);
  }

 private:
  template <class At>
  SPIN_HD_INLINE void axis(const At& at, int k, int step) const {
    using Real = typename At::Real;
    const Real share = at.load(c[k]) / maximum(at.load(area[k]), lit<Real>(1e-6));
    at.store(mulAdd(-share, at.load(p) - at.load(p, -step), at.load(u[k])), u[k]);
  }
};

}  // namespace spin
