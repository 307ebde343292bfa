// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_trace.h"
#include "core/air/pressure_passes.h"

/// Passes over velocities, which lie at the lower faces of cells. Places are in cells from the lattice's
/// corner.
namespace spin {

/// 1 where a lower face's velocity is computed: it is open and a solved cell touches it.
template <class At>
SPIN_HD_INLINE typename At::Real faceMoves(const At& at, const float* area, const float* open, int step) {
  return positive(at.load(area)) * maximum(at.load(open), at.load(open, -step));
}

/// Semi-Lagrangian: `from` where the air comes from; the least and largest round that where asked.
template <int axis>
struct CarryPass {
  static constexpr AirResult kResult = AirResult::None;
  VelocityView v;
  const float *from, *area, *open;
  float *to, *least, *most;
  float cells;  ///< time over cell size

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real moves = faceMoves(at, area, open, axis == 0 ? 1 : axis == 1 ? v.strides.y : v.strides.z);
    const LatticePlace<Real> d = traced<axis>(v, at, -cells);
    if (!least) {
      const Real value = displaced<axis, axis>(v, from, at, d, allWithin<At>(d, 1.0));
      at.store(selectLess(lit<Real>(0.0), moves, value, at.load(from)), to);
      return;
    }
    const HeldValue<Real> held = heldAt<axis>(v, from, at, d);
    at.store(selectLess(lit<Real>(0.0), moves, held.value, at.load(from)), to);
    at.store(held.least, least);
    at.store(held.most, most);
  }
};

/// MacCormack (Selle et al. 2008): half of what carrying forth and back leaves is taken off, within the
/// values round the place that the air comes from.
template <int axis>
struct CarryBackPass {
  static constexpr AirResult kResult = AirResult::None;
  VelocityView v;
  const float *from, *carried, *area, *open, *least, *most;
  float* to;
  float cells;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real moves = faceMoves(at, area, open, axis == 0 ? 1 : axis == 1 ? v.strides.y : v.strides.z);
    const LatticePlace<Real> d = traced<axis>(v, at, cells);
    const Real back = displaced<axis, axis>(v, carried, at, d, allWithin<At>(d, 1.0));
    const Real own = at.load(from), mended = mulAdd(lit<Real>(0.5), own - back, at.load(carried));
    const Real held = minimum(maximum(mended, at.load(least)), at.load(most));
    at.store(selectLess(lit<Real>(0.0), moves, held, own), to);
  }
};

/// Clamped cubic interpolation (Catmull and Rom) where the air comes from.
template <int axis>
struct CarryCubicPass {
  static constexpr AirResult kResult = AirResult::None;
  VelocityView v;
  const float *from, *area, *open;
  float* to;
  float cells;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real moves = faceMoves(at, area, open, axis == 0 ? 1 : axis == 1 ? v.strides.y : v.strides.z);
    LatticePlace<Real> p = moved(faceOf<axis>(at), traced<axis>(v, at, -cells));
    // Two samples are needed on either side.
    p.x = inside(p.x, v.dims.x);
    p.y = inside(p.y, v.dims.y);
    p.z = inside(p.z, v.dims.z);
    const Corners<At> corners = cornersOf<At>(v, axis, p);
    Real low, high;
    corners.linear(from, v.strides, low, high);
    Real wx[4], wy[4], wz[4];
    weights(corners.fx, wx);
    weights(corners.fy, wy);
    weights(corners.fz, wz);
    Real sum = lit<Real>(0.0);
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j) {
        const float* row = from + (k - 1) * v.strides.z + (j - 1) * v.strides.y - 1;
        Real along = wx[0] * gather(row, corners.first);
        for (int i = 1; i < 4; ++i) along = mulAdd(wx[i], gather(row + i, corners.first), along);
        sum = mulAdd(wz[k] * wy[j], along, sum);
      }
    const Real held = minimum(maximum(sum, low), high);
    at.store(selectLess(lit<Real>(0.0), moves, held, at.load(from)), to);
  }

 private:
  template <class Real>
  SPIN_HD_INLINE static Real inside(Real p, int cells) {
    return minimum(maximum(p, lit<Real>(1.6)), lit<Real>(static_cast<double>(cells) - 2.6));
  }
  template <class Real>
  SPIN_HD_INLINE static void weights(Real f, Real* w) {
    const Real half = lit<Real>(0.5), f2 = f * f, f3 = f2 * f;
    w[0] = half * (lit<Real>(2.0) * f2 - f - f3);
    w[1] = half * (lit<Real>(2.0) - lit<Real>(5.0) * f2 + lit<Real>(3.0) * f3);
    w[2] = half * (f + lit<Real>(4.0) * f2 - lit<Real>(3.0) * f3);
    w[3] = half * (f3 - f2);
  }
};

/// Of a face that is open less than this the velocity may be many times that of the air beside it, so that
/// the flux is right. It must not be carried into cells that hold many times the air: momentum would come
/// from nowhere.
inline constexpr double kThinFace = 0.25;

/// Gives closed faces beside open ones a velocity to interpolate with: that of the open ones where the air
/// slides, mirrored at the wall's where it sticks. Thin faces get that of the others, too. Over the
/// bricks that hold such faces.
template <int axis>
struct GhostPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float *area, *sticks, *wall;  ///< sticks, wall: null = slides everywhere
  float* u;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0), thin = lit<Real>(kThinFace);
    const Real own = at.load(area), kept = at.load(u);
    Real weight = zero, sum = zero;
    for (const int step : {-1, 1, -strides.y, strides.y, -strides.z, strides.z}) {
      const Real counts = selectLess(thin, at.load(area, step), lit<Real>(1.0), zero);
      weight = weight + counts;
      sum = mulAdd(counts, at.load(u, step), sum);
    }
    const Real mean = sum / maximum(weight, lit<Real>(1.0));
    Real value = mean;
    if (sticks) {
      const Real s = at.load(sticks);
      value = mulAdd(s, lit<Real>(2.0) * (at.load(wall) - value), value);
    }
    // Not the walls of the domain (negative), whose speed is known.
    const Real beside = selectLess(thin, own, kept, selectLess(zero, weight, mean, kept));
    at.store(selectLess(own, zero, kept, selectLess(zero, own, beside, value)), u);
  }
};

/// 2 a - b: the reflection (Zehnder et al. 2018).
struct ReflectPass {
  static constexpr AirResult kResult = AirResult::None;
  const float* a[3];
  float* b[3];

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    for (int k = 0; k < 3; ++k)
      at.store(mulAdd(lit<typename At::Real>(2.0), at.load(a[k]), -at.load(b[k])), b[k]);
  }
};

struct CopyPass {
  static constexpr AirResult kResult = AirResult::None;
  const float* from[3];
  float* to[3];

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    for (int k = 0; k < 3; ++k) at.store(at.load(from[k]), to[k]);
  }
};

struct CopyOnePass {
  static constexpr AirResult kResult = AirResult::None;
  const float* from;
  float* to;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    at.store(at.load(from), to);
  }
};

/// Largest of |u|, |v|, |w|; thin faces count less. Not finite where one of them is not.
struct FastestPass {
  static constexpr AirResult kResult = AirResult::Most;
  const float* u[3];
  const float* area[3];

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0);
    Real most = zero, broken = zero;
    for (int k = 0; k < 3; ++k) {
      const Real counts = clampBetween(at.load(area[k]) * lit<Real>(1.0 / kThinFace), zero, lit<Real>(1.0));
      const Real value = at.load(u[k]) * counts;
      most = maximum(most, maximum(value, -value));
      broken = mulAdd(zero, value, broken);
    }
    return most + broken;
  }
};

/// q = s + share times the sum over neighbours of (s - s there): the implicit diffusion's left side.
/// Neighbours that do not move have s = 0; closed ones beside count where the air sticks, mirrored.
template <int axis>
struct DiffuseProductPass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float *area, *open, *sticks, *s;
  float* q;
  float share;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0), own = at.load(s);
    Real sum = zero;
    for (const int step : {-1, 1, -strides.y, strides.y, -strides.z, strides.z}) {
      const Real there = at.load(area, step);
      Real closed = zero;
      if (sticks) closed = lit<Real>(2.0) * own * at.load(sticks, step);
      sum = sum + selectLess(zero, there, own - at.load(s, step), selectLess(there, zero, own, closed));
    }
    const Real moves = faceMoves(at, area, open, axis == 0 ? 1 : axis == 1 ? strides.y : strides.z);
    const Real product = mulAdd(Real(share), sum, own) * moves;
    at.store(product, q);
    return product * own;
  }
};

/// r = from - (left side of u); the sums of r^2.
template <int axis>
struct DiffuseResidualPass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float *area, *open, *sticks, *wall, *from, *u;
  float* r;
  float share;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0), own = at.load(u);
    Real sum = zero;
    for (const int step : {-1, 1, -strides.y, strides.y, -strides.z, strides.z}) {
      const Real there = at.load(area, step);
      Real closed = zero;
      if (sticks) closed = lit<Real>(2.0) * (own - at.load(wall, step)) * at.load(sticks, step);
      const Real apart = own - at.load(u, step);
      sum = sum + selectLess(zero, there, apart, selectLess(there, zero, apart, closed));
    }
    const Real moves = faceMoves(at, area, open, axis == 0 ? 1 : axis == 1 ? strides.y : strides.z);
    const Real left = (at.load(from) - own - Real(share) * sum) * moves;
    at.store(left, r);
    return left * left;
  }
};

/// Sum of squares where faces move.
template <int axis>
struct NormPass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float *area, *open, *u;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    const auto value = at.load(u) * faceMoves(at, area, open,
                                              axis == 0   ? 1
                                              : axis == 1 ? strides.y
                                                          : strides.z);
    return value * value;
  }
};

}  // namespace spin
