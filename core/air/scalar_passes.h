// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/velocity_passes.h"

/// Passes over what the air carries. Values count per open volume: a cell holds value * volume * cell^3, with
/// `volume` its open share, kept above a least so that cut cells do not rule the step.
namespace spin {

/// Carries a scalar along one axis by fluxes (after van Leer 1977): what leaves a cell enters its neighbour.
/// The cell's volume goes with it (Clappier 1998), so that in air without divergence a constant stays one
/// through the three sweeps. The sum is what left for cells that are not computed.
template <int axis>
struct SweepPass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float *q, *volume;       ///< before
  const float *u, *area, *open;  ///< u along the axis
  const float* whole;            ///< volume to end with; null = write the one that is left
  float *to, *volumeTo;
  float cells;     ///< time over cell size
  float settling;  ///< m/s downwards; along z only

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const int step = axis == 0 ? 1 : axis == 1 ? strides.y : strides.z;
    const Real low = way(at, 0), high = way(at, step);
    const Real in = low * faceValue(at, low, 0, step), out = high * faceValue(at, high, step, step);
    const Real own = at.load(volume), solved = at.load(open);
    const Real content = at.load(q) * own + in - out, left = own + low - high;
    const Real end = whole ? at.load(whole) : left;
    at.store(content / maximum(end, lit<Real>(1e-6)) * solved, to);
    if (!whole) at.store(left, volumeTo);
    const Real lowOpen = at.load(open, -step), highOpen = at.load(open, step);
    const Real one = lit<Real>(1.0);
    // Nothing comes from there, but what leaves may be less than nothing: warmth of cold air.
    return solved * (out * (one - highOpen) - in * (one - lowOpen));
  }

 private:
  /// Share of a cell's volume that goes through the lower face at that offset, upwards.
  template <class At>
  SPIN_HD_INLINE typename At::Real way(const At& at, int offset) const {
    using Real = typename At::Real;
    const Real speed = at.load(u, offset) - Real(settling);
    return maximum(at.load(area, offset), lit<Real>(0.0)) * speed * Real(cells);
  }
  /// Value at the lower face at that offset: upwind, with a limited slope.
  template <class At>
  SPIN_HD_INLINE typename At::Real faceValue(const At& at, typename At::Real flux, int offset,
                                             int step) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0);
    const Real a = at.load(q, offset - 2 * step), b = at.load(q, offset - step), c = at.load(q, offset),
               d = at.load(q, offset + step);
    const Real back = selectLess(zero, flux, a, d), up = selectLess(zero, flux, b, c),
               down = selectLess(zero, flux, c, b);
    const Real volumeUp = selectLess(zero, flux, at.load(volume, offset - step), at.load(volume, offset));
    const Real courant = minimum(maximum(flux, -flux) / maximum(volumeUp, lit<Real>(1e-6)), lit<Real>(1.0));
    // Third order where it is smooth (Leonard 1991): the face's value stays between both cells and takes no
    // more than brings the cell to what is behind it; 0 at extremes.
    const Real left = up - back, right = down - up, one = lit<Real>(1.0), two = lit<Real>(2.0);
    const Real third = lit<Real>(1.0 / 3.0) * mulAdd(two - courant, right, (one + courant) * left);
    const Real most = two * minimum(maximum(left, -left) / maximum(courant, lit<Real>(0.05)),
                                    maximum(right, -right) / maximum(one - courant, lit<Real>(0.05)));
    const Real held = minimum(maximum(third, -most), most);
    const Real slope = selectLess(zero, left * right, held, zero);
    return mulAdd(lit<Real>(0.5) * (lit<Real>(1.0) - courant), slope, up);
  }
};

/// How many times too long a step is for a cell: no sweep may take more than kMostOut of its volume out, and
/// what the axes pull apart may not change it by more than kMostChange before the others have made up for
/// that.
struct OutflowPass {
  static constexpr AirResult kResult = AirResult::Most;
  static constexpr double kMostOut = 0.85, kMostChange = 0.4;
  AirStrides strides;
  const float* u[3];
  const float* area[3];
  const float *open, *volume;
  float cells, settling;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    Real out = lit<Real>(0.0), change = out;
    axis(at, 0, 1, 0.0f, out, change);
    axis(at, 1, strides.y, 0.0f, out, change);
    axis(at, 2, strides.z, settling, out, change);
    const Real share = Real(cells) / maximum(at.load(volume), lit<Real>(1e-6)) * at.load(open);
    return share * maximum(out * lit<Real>(1.0 / kMostOut), change * lit<Real>(1.0 / kMostChange));
  }

 private:
  template <class At>
  SPIN_HD_INLINE void axis(const At& at, int k, int step, float falls, typename At::Real& out,
                           typename At::Real& change) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0);
    const Real low = (at.load(u[k]) - Real(falls)) * maximum(at.load(area[k]), zero);
    const Real high = (at.load(u[k], step) - Real(falls)) * maximum(at.load(area[k], step), zero);
    out = maximum(out, maximum(high, zero) + maximum(-low, zero));
    change = change + maximum(high - low, zero);
  }
};

/// What settles on the solid below: its area in plan is what the cell's upper face is wider than its lower
/// one. The sum is what came down.
struct DepositPass {
  static constexpr AirResult kResult = AirResult::Sum;
  AirStrides strides;
  const float *areaZ, *volume, *open;
  float *q, *down;
  float way;  ///< settling speed times time over cell size

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0), own = at.load(volume);
    const Real plan = maximum(maximum(at.load(areaZ, strides.z), zero) - maximum(at.load(areaZ), zero), zero);
    const Real share =
        minimum(Real(way) * plan / maximum(own, lit<Real>(1e-6)), lit<Real>(1.0)) * at.load(open);
    const Real gone = at.load(q) * share;
    at.store(at.load(q) - gone, q);
    const Real amount = gone * own;
    at.store(at.load(down) + amount, down);
    return amount;
  }
};

/// Content of all cells.
struct ContentPass {
  static constexpr AirResult kResult = AirResult::Sum;
  const float *q, *volume;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    return at.load(q) * at.load(volume);
  }
};

/// Largest magnitude.
struct LargestPass {
  static constexpr AirResult kResult = AirResult::Most;
  const float* q;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    const auto own = at.load(q);
    return maximum(own, -own);
  }
};

/// Largest of values over their leasts and of the speed against the wind over its own: below 1 a cell is as
/// good as empty; kHolds where it holds something, less where the air moves only. Not finite where one of
/// them is not.
struct ActivityPass {
  static constexpr double kHolds = 1e6;
  static constexpr AirResult kResult = AirResult::Most;
  AirStrides strides;
  const float* q[4];
  const float* u[3];
  const float* area[3];
  const float* open;
  const float* wind[3];  ///< m/s; null: calm
  float least[4];
  float leastSpeed;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real zero = lit<Real>(0.0);
    Real most = zero, broken = zero;
    for (int k = 0; k < 4; ++k) {
      const Real own = at.load(q[k]);
      most = maximum(most, magnitude(own) * Real(1.0f / least[k]));
      broken = mulAdd(zero, own, broken);
    }
    most = selectLess(lit<Real>(1.0), most, lit<Real>(kHolds), most);
    for (int k = 0; k < 3; ++k) {
      Real apart = at.load(u[k]);
      if (wind[k]) apart = apart - at.load(wind[k]);
      const Real speed = magnitude(apart) * positive(at.load(area[k])) * Real(1.0f / leastSpeed);
      most = maximum(most, minimum(speed, lit<Real>(0.5 * kHolds)));
      broken = mulAdd(zero, apart, broken);
    }
    return mulAdd(most, at.load(open), broken);
  }

 private:
  template <class Real>
  SPIN_HD_INLINE static Real magnitude(Real a) {
    return maximum(a, -a);
  }
};

}  // namespace spin
