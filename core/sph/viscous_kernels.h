// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_kernels.h"
#include "core/sph/viscous_passes.h"

/// Implicit viscosity: rho v - dt (viscous force of v) = rho v*, by conjugate gradients with the diagonal as
/// preconditioner (Hestenes and Stiefel 1952). Walls take part with the rate at which they take up what
/// slides; the viscosity is that at the step's start.
namespace spin {

/// Coulomb friction within the matrix: the slide that it is divided by is held to this share of what friction
/// would stop in a step.
inline constexpr float kLeastSlipShare = 0.05f;

/// Calls visit(contact, rate) for every wall that holds particle i; rate 1/s.
template <class Visit>
SPIN_HD_INLINE void forWallHolds(const FlowView& v, std::size_t i, const Visit& visit) {
  const float step = v.viscousSolve.timeStep;
  forWallSlopes(v, i, [&](const WallContact& w, float slope) {
    const WallSurface& surface = v.walls.surface[w.surface];
    if (surface.friction == WallFriction::NoSlip) visit(w, stickRate(v, i, w));
    if (surface.friction != WallFriction::Coulomb) return;
    const float most = surface.tangent * maximum(wallPushOf(v, i, w, slope), 0.0f);
    // Without a push there is no friction, and nothing to divide by.
    const float slip = v.viscousSolve.slip[i];
    visit(w, most / (slip + kLeastSlipShare * most * step + 1e-12f) + turbulentRate(v, w, slip));
  });
}

/// Part of a direction along a wall.
SPIN_HD_INLINE PairVector<float> alongWall(const WallContact& w, float x, float y, float z) {
  const float normal = x * w.nx + y * w.ny + z * w.nz;
  return {x - normal * w.nx, y - normal * w.ny, z - normal * w.nz};
}

/// The matrix's diagonal, walls included, per component.
SPIN_HD_INLINE PairVector<float> viscousDiagonal(const FlowView& v, std::size_t i) {
  const float pairs = v.viscousSolve.diagonal[i];
  PairVector<float> d{pairs, pairs, pairs};
  if ((v.extra[i].flags & kNearWall) == 0) return d;
  const float scale = v.viscousSolve.timeStep * v.record[i].restDensity;
  forWallHolds(v, i, [&](const WallContact& w, float rate) {
    d.x += scale * rate * (1.0f - w.nx * w.nx);
    d.y += scale * rate * (1.0f - w.ny * w.ny);
    d.z += scale * rate * (1.0f - w.nz * w.nz);
  });
  return d;
}

/// Direction of the first product: the velocity itself.
struct ViscousBeginKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    v.viscousSolve.direction[i] = {r.vx, r.vy, r.vz, r.viscosity};
    float slip = 0.0f;
    if (v.extra[i].flags & kNearWall)
      forWallSlopes(v, i, [&](const WallContact& w, float) {
        const PairVector<float> slide = slideAlong(w, {r.vx, r.vy, r.vz});
        slip = maximum(slip, squareRoot(slide.x * slide.x + slide.y * slide.y + slide.z * slide.z));
      });
    v.viscousSolve.slip[i] = slip;
  }
};

/// Residual of the velocity itself as the first guess, and the first direction.
struct ViscousResidualKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    const PairRecord& r = v.record[i];
    PairVector<float> b{r.restDensity * r.vx - s.qx[i], r.restDensity * r.vy - s.qy[i],
                        r.restDensity * r.vz - s.qz[i]};
    if (v.extra[i].flags & kNearWall)
      forWallHolds(v, i, [&](const WallContact& w, float rate) {
        const PairVector<float> slide = slideAlong(w, {r.vx, r.vy, r.vz});
        const float scale = s.timeStep * r.restDensity * rate;
        b.x -= scale * slide.x;
        b.y -= scale * slide.y;
        b.z -= scale * slide.z;
      });
    s.rx[i] = b.x;
    s.ry[i] = b.y;
    s.rz[i] = b.z;
    const PairVector<float> d = viscousDiagonal(v, i);
    ViscousRecord& p = s.direction[i];
    p.x = b.x / d.x;
    p.y = b.y / d.y;
    p.z = b.z / d.z;
  }
};

/// Adds the walls to the product of matrix and direction.
struct ViscousWallKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    if ((v.extra[i].flags & kNearWall) == 0) return;
    const ViscousSolveView& s = v.viscousSolve;
    const ViscousRecord& p = s.direction[i];
    forWallHolds(v, i, [&](const WallContact& w, float rate) {
      const PairVector<float> slide = alongWall(w, p.x, p.y, p.z);
      const float scale = s.timeStep * v.record[i].restDensity * rate;
      s.qx[i] += scale * slide.x;
      s.qy[i] += scale * slide.y;
      s.qz[i] += scale * slide.z;
    });
  }
};

/// direction . product, and a particle where that is not finite.
struct ViscousProduct {
  double dot;
  std::uint32_t broken;
};
struct JoinViscousProduct {
  SPIN_HD ViscousProduct operator()(const ViscousProduct& a, const ViscousProduct& b) const {
    return {a.dot + b.dot, a.broken < b.broken ? a.broken : b.broken};
  }
};
struct ViscousProductOf {
  FlowView v;
  SPIN_HD ViscousProduct operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    const ViscousRecord& p = s.direction[i];
    const double dot = static_cast<double>(p.x) * static_cast<double>(s.qx[i]) +
                       static_cast<double>(p.y) * static_cast<double>(s.qy[i]) +
                       static_cast<double>(p.z) * static_cast<double>(s.qz[i]);
    return {dot, dot - dot == 0.0 ? UINT32_MAX : v.id[i]};
  }
};

/// residual . residual over the diagonal, over the density (what is left, as a velocity squared times rho),
/// and the velocities' own norm.
struct ViscousNorms {
  double preconditioned, left, whole;
};
struct JoinViscousNorms {
  SPIN_HD ViscousNorms operator()(const ViscousNorms& a, const ViscousNorms& b) const {
    return {a.preconditioned + b.preconditioned, a.left + b.left, a.whole + b.whole};
  }
};
struct ViscousNormsOf {
  FlowView v;
  float leastSpeed;  ///< m/s, so that fluid at rest has a norm too
  SPIN_HD ViscousNorms operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    const PairRecord& r = v.record[i];
    const PairVector<float> d = viscousDiagonal(v, i);
    const float x = s.rx[i], y = s.ry[i], z = s.rz[i];
    const float left = (x * x + y * y + z * z) / r.restDensity;
    const float whole = r.restDensity * (r.vx * r.vx + r.vy * r.vy + r.vz * r.vz + leastSpeed * leastSpeed);
    return {static_cast<double>(x * x / d.x + y * y / d.y + z * z / d.z), static_cast<double>(left),
            static_cast<double>(whole)};
  }
};

/// Goes `length` along the direction.
struct ViscousAdvanceKernel {
  FlowView v;
  float length;
  SPIN_HD void operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    const ViscousRecord& p = s.direction[i];
    PairRecord& r = v.record[i];
    r.vx += length * p.x;
    r.vy += length * p.y;
    r.vz += length * p.z;
    s.rx[i] -= length * s.qx[i];
    s.ry[i] -= length * s.qy[i];
    s.rz[i] -= length * s.qz[i];
  }
};

/// The next direction, conjugate to those before.
struct ViscousTurnKernel {
  FlowView v;
  float share;
  SPIN_HD void operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    const PairVector<float> d = viscousDiagonal(v, i);
    ViscousRecord& p = s.direction[i];
    p.x = s.rx[i] / d.x + share * p.x;
    p.y = s.ry[i] / d.y + share * p.y;
    p.z = s.rz[i] / d.z + share * p.z;
  }
};

/// Momentum over V0, and whether a wall takes part in it.
struct ViscousMomentum {
  double x, y, z, mass;
  std::uint32_t walls;
};
struct JoinViscousMomentum {
  SPIN_HD ViscousMomentum operator()(const ViscousMomentum& a, const ViscousMomentum& b) const {
    return {a.x + b.x, a.y + b.y, a.z + b.z, a.mass + b.mass, a.walls | b.walls};
  }
};
struct ViscousMomentumOf {
  FlowView v;
  SPIN_HD ViscousMomentum operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    const auto mass = static_cast<double>(r.restDensity);
    return {mass * static_cast<double>(r.vx), mass * static_cast<double>(r.vy),
            mass * static_cast<double>(r.vz), mass, v.extra[i].flags & std::uint32_t{kNearWall}};
  }
};
struct ViscousShiftKernel {
  FlowView v;
  float x, y, z;
  SPIN_HD void operator()(std::size_t i) const {
    v.record[i].vx += x;
    v.record[i].vy += y;
    v.record[i].vz += z;
  }
};

/// v = x + r / rho is v* plus the viscous force of x: pairwise, so momentum is conserved whatever is left.
struct ViscousEndKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const ViscousSolveView& s = v.viscousSolve;
    PairRecord& r = v.record[i];
    r.vx += s.rx[i] / r.restDensity;
    r.vy += s.ry[i] / r.restDensity;
    r.vz += s.rz[i] / r.restDensity;
  }
};

}  // namespace spin
