// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_passes.h"
#include "core/sph/wall_friction.h"

/// The sums of the implicit pressure (after DFSPH, Bender and Koschier 2015, 2017) in the form of
/// flow_passes.h. With G_i = sum V0 grad W and B_i the slopes of walls, velocities change the excess at the
/// rate
///   sum V0 (v_i - v_j) . grad W + (v_i - v_wall) . B_i
/// and a pressure term P accelerates by its adjoint,
///   a_i = -1/rho_i (sum V0 (P_i + P_j) grad W + P_i B_i),
/// so the solve takes energy but never gives any. Thereby P_i changes its own rate by
/// -(|G_i + B_i|^2 / rho_i + sum V0^2 |grad W|^2 / rho_j): the inverse is the particle's compliance.
namespace spin {

/// Density, sum of gradients and of their squares over the density, all without walls. The gradients' sum
/// goes by way of the acceleration arrays, which are free until the force pass.
template <class Lanes>
struct ConstraintPass {
  using T = typename Lanes::Real;
  T sum = T(0.0f), squares = T(0.0f);
  PairVector<T> gradient{T(0.0f), T(0.0f), T(0.0f)};

  SPIN_HD_INLINE ConstraintPass(const FlowView&, const Lanes&) {}
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const T q = distanceOf(offset), slope = CubicSpline::slopeOverQ(q), part = slope * q;
    sum = sum + CubicSpline::shape(q);
    squares = mulAdd(part * part, T(1.0f / v.record[j].restDensity), squares);
    gradient.x = mulAdd(slope, offset.x, gradient.x);
    gradient.y = mulAdd(slope, offset.y, gradient.y);
    gradient.z = mulAdd(slope, offset.z, gradient.z);
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    const T scale = T(-v.constants.gradientFactor);
    own.store(sum, v.excess);
    own.store(scale * gradient.x, v.ax);
    own.store(scale * gradient.y, v.ay);
    own.store(scale * gradient.z, v.az);
    own.store(scale * scale * squares, v.pressureSolve.compliance);
  }
};

/// One iterate: relaxed Jacobi, the pressure held above its least, then momentum (Nesterov 1983). `rate` is
/// that of the excess by all of the current velocities. A share of a surplus is taken off, a deficit may be
/// filled up; of its last bit only that share, or fluid at rest would fall through it and rebound. Wrong is
/// what compresses, and what is driven apart by a pressure.
template <class Lanes, class T>
SPIN_HD_INLINE void iteratePressure(const FlowView& v, const Lanes& own, T rate) {
  const PressureSolveView& s = v.pressureSolve;
  const T excess = own.load(v.excess) - T(s.level), pressure = own.load(s.pressure),
          latest = own.load(s.latest);
  const T compliance = own.load(s.compliance);
  const T share = T(s.surplusShare);
  const T room = minimum(share * excess, mulAdd(T(1.0f) - share, T(s.deficitRoom), excess));
  const T ahead = mulAdd(T(s.timeStep), rate, room);
  const T strength = T(s.relaxation / (s.timeStep * s.timeStep));
  const T next = maximum(mulAdd(strength * compliance, ahead, pressure), T(s.leastPressure));
  const T moved = mulAdd(T(s.momentum), next - latest, next);
  own.store(moved - pressure, s.push);
  own.store(moved, s.pressure);
  own.store(next, s.latest);
  const T apart = maximum(-ahead, T(0.0f));
  const T wrong = maximum(ahead, T(s.deficitShare) * apart);
  const T counted = selectLess(T(0.0f), pressure, maximum(wrong, apart), wrong);
  own.store(selectLess(T(0.0f), compliance, counted, T(0.0f)), s.error);
}

/// Whether any of the lanes has a solid in reach.
template <class Lanes>
SPIN_HD_INLINE bool anyNearWall(const FlowView& v, const Lanes& own) {
  std::uint8_t flags = 0;
  for (std::uint32_t l = 0; l < own.count; ++l) flags = flags | v.extra[own.first + l].flags;
  return (flags & kNearWall) != 0;
}

/// Rate of the excess, then the next iterate.
template <class Lanes>
struct DivergencePass : OwnVelocity<Lanes> {
  using T = typename Lanes::Real;
  T approach = T(0.0f);

  SPIN_HD_INLINE DivergencePass(const FlowView& v, const Lanes& own) : OwnVelocity<Lanes>(v, own) {}
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const PairVector<T> relative = this->against(v.record[j]);
    const T slope = CubicSpline::slopeOverQ(distanceOf(offset));
    approach = mulAdd(
        slope, mulAdd(relative.z, offset.z, mulAdd(relative.y, offset.y, relative.x * offset.x)), approach);
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    T rate = T(-v.constants.gradientFactor) * approach;
    if (v.bodyRate) rate = rate + own.load(v.bodyRate);
    if (anyNearWall(v, own)) {
      float byWalls[kPairPadding] = {};
      for (std::uint32_t l = 0; l < own.count; ++l)
        if (v.extra[own.first + l].flags & kNearWall) byWalls[l] = wallRate(v, own.first + l);
      rate = rate + own.pack(byWalls);
    }
    iteratePressure(v, own, rate);
  }
};

/// Velocity that walls give to particle i for a change of its pressure term.
SPIN_HD_INLINE void pushOffWalls(const FlowView& v, std::size_t i, float change, float seconds,
                                 PairVector<float>& velocity) {
  const float scale = seconds * change / v.record[i].restDensity;
  forWallSlopes(v, i, [&](const WallContact& w, float slope) SPIN_INLINE_LAMBDA {
    velocity.x += scale * slope * w.nx;
    velocity.y += scale * slope * w.ny;
    velocity.z += scale * slope * w.nz;
  });
}

/// Lets the push act on velocities, which nobody else reads meanwhile.
template <class Lanes>
struct PressurePushPass {
  using T = typename Lanes::Real;
  T push;
  PairVector<T> force{T(0.0f), T(0.0f), T(0.0f)};

  SPIN_HD_INLINE PressurePushPass(const FlowView& v, const Lanes& own)
      : push(own.load(v.pressureSolve.push)) {}
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const T both = (push + T(v.pressureSolve.push[j])) * CubicSpline::slopeOverQ(distanceOf(offset));
    force.x = mulAdd(both, offset.x, force.x);
    force.y = mulAdd(both, offset.y, force.y);
    force.z = mulAdd(both, offset.z, force.z);
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    const T scale = T(v.constants.gradientFactor) / own.load(v.record, &PairRecord::restDensity);
    const PairVector<T> a{scale * force.x, scale * force.y, scale * force.z};
    own.store(own.load(v.ax) + a.x, v.ax);
    own.store(own.load(v.ay) + a.y, v.ay);
    own.store(own.load(v.az) + a.z, v.az);
    float x[kPairPadding], y[kPairPadding], z[kPairPadding];
    own.unpack(a.x, x);
    own.unpack(a.y, y);
    own.unpack(a.z, z);
    const PressureSolveView& s = v.pressureSolve;
    for (std::uint32_t l = 0; l < own.count; ++l) {
      const std::uint32_t i = own.first + l;
      PairRecord& r = v.record[i];
      PairVector<float> velocity{r.vx + s.timeStep * x[l], r.vy + s.timeStep * y[l],
                                 r.vz + s.timeStep * z[l]};
      if (v.extra[i].flags & kNearWall) pushOffWalls(v, i, s.push[i], s.timeStep, velocity);
      r.vx = velocity.x;
      r.vy = velocity.y;
      r.vz = velocity.z;
    }
  }
};

}  // namespace spin
