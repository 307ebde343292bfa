// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/sph/flow_kernels.h"
#include "core/sph/implicit_passes.h"

/// Stages of the implicit pressure and viscosity that go over single particles.
namespace spin {

/// Before GatherKernel: the pressure term travels in the place of the excess, which is made anew.
struct KeepPressureKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const { v.excess[i] = v.record[i].pressureTerm; }
};

struct ClearAccelerationKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const { v.ax[i] = v.ay[i] = v.az[i] = 0.0f; }
};

/// After GatherKernel, whose excess carried the pressure term along.
struct TakeStateKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    PairRecord& r = v.record[i];
    r.vx = v.ax[i];
    r.vy = v.ay[i];
    r.vz = v.az[i];
    r.pressureTerm = v.excess[i];
    r.restDensity = v.constants.material[v.extra[i].material].restDensity;
  }
};

/// Adds the walls to what ConstraintPass has summed and makes the compliance; the viscosity of what needs no
/// shear rate.
struct ConstraintKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const FlowConstants& c = v.constants;
    findGround(v, i);
    PairRecord& r = v.record[i];
    float open = 1.0f;
    PairVector<float> walls{0.0f, 0.0f, 0.0f};
    bool touches = false;
    forWallSlopes(v, i, [&](const WallContact& w, float slope) {
      touches = true;
      open *= maximum(1.0f - solidShare(w.distance / c.support, c.layer).density, 0.0f);
      walls.x -= slope * w.nx;
      walls.y -= slope * w.ny;
      walls.z -= slope * w.nz;
    });
    ParticleExtra& extra = v.extra[i];
    extra.flags = touches ? extra.flags | kNearWall : extra.flags & ~kNearWall;
    v.excess[i] = c.densityFactor * v.excess[i] - open;
    const PairVector<float> g{v.ax[i] + walls.x, v.ay[i] + walls.y, v.az[i] + walls.z};
    const float own = g.x * g.x + g.y * g.y + g.z * g.z;
    const float stiffness = v.pressureSolve.compliance[i] + own / r.restDensity;
    // Less than a hundredth of a full neighbourhood's (about 12 / h^2): nothing to push against.
    const float least = 0.1f / (c.support * c.support * r.restDensity);
    v.pressureSolve.compliance[i] = stiffness > least ? 1.0f / stiffness : 0.0f;
    const Rheology& rheology = c.material[extra.material].rheology;
    if (!rheology.needsShearRate()) r.viscosity = rheology.viscosity;
  }
};

/// What a solve has left: sum and most of the errors, and the number of a particle whose error is not finite.
struct SolveError {
  double sum;
  float largest;
  std::uint32_t broken;
};
SPIN_HD_INLINE SolveError noError() {
  return {0.0, 0.0f, UINT32_MAX};
}
struct JoinErrors {
  SPIN_HD SolveError operator()(const SolveError& a, const SolveError& b) const {
    return {a.sum + b.sum, maximum(a.largest, b.largest), a.broken < b.broken ? a.broken : b.broken};
  }
};
struct ErrorOf {
  FlowView v;
  SPIN_HD SolveError operator()(std::size_t i) const {
    const float error = v.pressureSolve.error[i];
    return {static_cast<double>(error), error, error - error == 0.0f ? UINT32_MAX : v.id[i]};
  }
};

/// Limits of a step whose pressure is implicit (`sound` holds how far the fastest may go), and the
/// compression that is there.
struct FlowLimits {
  StepLimits step;
  double excess, balance;  ///< sums of what is above 0, and of all
  float largest;
};
SPIN_HD_INLINE FlowLimits noFlowLimits() {
  return {noLimits(), 0.0, 0.0, 0.0f};
}
struct JoinFlowLimits {
  SPIN_HD FlowLimits operator()(const FlowLimits& a, const FlowLimits& b) const {
    return {JoinLimits{}(a.step, b.step), a.excess + b.excess, a.balance + b.balance,
            maximum(a.largest, b.largest)};
  }
};
struct FlowLimitsOf {
  /// Towards a solid a particle goes less far in a step.
  static constexpr float kApproach = 5.0f;

  FlowView v;
  float courantFlow, viscousFactor;
  /// Speed towards a wall in reach, m/s.
  SPIN_HD float approachOf(std::size_t i) const {
    float fastest = 0.0f;
    if ((v.extra[i].flags & kNearWall) == 0) return fastest;
    const PairRecord& r = v.record[i];
    v.nearWalls(i, [&](const WallContact& w) {
      const float away = (r.vx - w.vx) * w.nx + (r.vy - w.vy) * w.ny + (r.vz - w.vz) * w.nz;
      fastest = maximum(fastest, -away);
    });
    return fastest;
  }
  SPIN_HD FlowLimits operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    const float speed = squareRoot(r.vx * r.vx + r.vy * r.vy + r.vz * r.vz), nu = r.viscosity / r.restDensity;
    const float spacing = v.constants.spacing, check = speed + r.pressureTerm + v.excess[i];
    const float excess = maximum(v.excess[i], 0.0f);
    // A solid's share of the density grows faster than its slope foretells.
    const float way = maximum(speed, kApproach * approachOf(i));
    return {{way > 0.0f ? courantFlow * spacing / way : INFINITY, INFINITY,
             nu > 0.0f ? viscousFactor * spacing * spacing / nu : INFINITY,
             check - check == 0.0f ? UINT32_MAX : v.id[i]},
            static_cast<double>(excess),
            static_cast<double>(v.excess[i]),
            excess};
  }
};

/// Velocity by all that IntegrateKernel applies, less what a solve still has to add: with `solvesPressure`
/// Coulomb friction follows when the pressure is known, with `solvesViscosity` friction is a part of the
/// viscous matrix.
struct PredictKernel {
  IntegrateKernel step;
  bool solvesPressure, solvesViscosity;

  SPIN_HD_INLINE void actWalls(std::size_t i, PairVector<float>& velocity) const {
    const FlowView& v = step.v;
    const float kick = step.kick;
    forWallSlopes(v, i, [&](const WallContact& w, float slope) {
      const float push = wallPushOf(v, i, w, slope);
      velocity.x += kick * push * w.nx;
      velocity.y += kick * push * w.ny;
      velocity.z += kick * push * w.nz;
      const bool sticks = v.walls.surface[w.surface].friction == WallFriction::NoSlip;
      if (!solvesViscosity && (sticks || !solvesPressure))
        rubAlong(v, i, w, maximum(kick * push, 0.0f), kick, velocity);
    });
  }

  SPIN_HD void operator()(std::size_t i) const {
    const FlowView& v = step.v;
    const FlowConstants& c = v.constants;
    const float kick = step.kick;
    PairRecord& r = v.record[i];
    const bool near = (v.extra[i].flags & kNearWall) != 0;
    const float fromWalls = v.rate && near ? wallRate(v, i) : 0.0f;
    PairVector<float> velocity{r.vx + kick * (v.ax[i] + c.gravityX), r.vy + kick * (v.ay[i] + c.gravityY),
                               r.vz + kick * (v.az[i] + c.gravityZ)};
    step.addWind(r, velocity);
    if (v.sx) {
      velocity.x += v.sx[i];
      velocity.y += v.sy[i];
      velocity.z += v.sz[i];
    }
    if (near) actWalls(i, velocity);
    r.vx = velocity.x;
    r.vy = velocity.y;
    r.vz = velocity.z;
    if (v.rate) v.excess[i] += c.timeStep * (v.rate[i] + fromWalls);
    if (!solvesPressure) return;
    v.pressureSolve.pressure[i] = r.pressureTerm;
    v.pressureSolve.latest[i] = r.pressureTerm;
  }
};

/// After the solves: walls hold particles off, and with `rubs` there is Coulomb's friction under the pressure
/// that was solved for.
struct WallEndKernel {
  FlowView v;
  bool rubs;
  SPIN_HD void operator()(std::size_t i) const {
    PairRecord& r = v.record[i];
    if (v.pressureSolve.pressure) r.pressureTerm = v.pressureSolve.pressure[i];
    if ((v.extra[i].flags & kNearWall) == 0) return;
    PairVector<float> velocity{r.vx, r.vy, r.vz};
    forWallSlopes(v, i, [&](const WallContact& w, float slope) {
      const float held = holdOff(v, i, w, velocity);
      if (!rubs || v.walls.surface[w.surface].friction != WallFriction::Coulomb) return;
      const float gain = v.constants.timeStep * maximum(wallPushOf(v, i, w, slope), 0.0f);
      rubAlong(v, i, w, gain + held, v.constants.timeStep, velocity);
    });
    r.vx = velocity.x;
    r.vy = velocity.y;
    r.vz = velocity.z;
  }
};

/// The way that the particle goes.
struct AdvanceKernel {
  IntegrateKernel step;
  SPIN_HD void operator()(std::size_t i) const {
    const FlowView& v = step.v;
    const FlowConstants& c = v.constants;
    const PairRecord& r = v.record[i];
    ParticleExtra& extra = v.extra[i];
    step.advance(v.x[i], extra.restX, c.timeStep * r.vx, c.unitsPerMetre, v.grid.periodX);
    step.advance(v.y[i], extra.restY, c.timeStep * r.vy, c.unitsPerMetre, v.grid.periodY);
    step.advance(v.z[i], extra.restZ, c.timeStep * r.vz, c.unitsPerMetre, v.grid.periodZ);
    step.leave(i);
  }
};

}  // namespace spin
