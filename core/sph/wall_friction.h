// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_view.h"
#include "core/sph/wall_law.h"

/// How a wall holds what slides along it.
namespace spin {

/// Part of a velocity along the wall, against the wall's own.
SPIN_HD_INLINE PairVector<float> slideAlong(const WallContact& w, const PairVector<float>& velocity) {
  const PairVector<float> relative{velocity.x - w.vx, velocity.y - w.vy, velocity.z - w.vz};
  const float normal = relative.x * w.nx + relative.y * w.ny + relative.z * w.nz;
  return {relative.x - normal * w.nx, relative.y - normal * w.ny, relative.z - normal * w.nz};
}

/// Rate at which a no-slip wall takes up what slides at particle i, 1/s.
SPIN_HD_INLINE float stickRate(const FlowView& v, std::size_t i, const WallContact& w) {
  const FlowConstants& c = v.constants;
  const PairRecord& r = v.record[i];
  const float viscosity = v.wallViscosity ? v.wallViscosity[i] : r.viscosity;
  return wallDragRate(w.distance / c.support, maximum(w.distance, kLeastWallDistance * c.spacing),
                      viscosity / r.restDensity, c.support);
}

/// Rate at which the ground's turbulence takes up a slide, 1/s.
SPIN_HD_INLINE float turbulentRate(const FlowView& v, const WallContact& w, float speed) {
  return wallTurbulentRate(w.distance / v.constants.support, v.walls.surface[w.surface].turbulence * speed,
                           v.constants.support);
}

/// No particle goes into a solid within the step, however little the pressure of a single one resists; one
/// that is inside comes out slowly. Gives what the speed along the normal gains by it.
SPIN_HD_INLINE float holdOff(const FlowView& v, std::size_t i, const WallContact& w,
                             PairVector<float>& velocity) {
  const FlowConstants& c = v.constants;
  const float soundSpeed = c.material[v.extra[i].material].soundSpeed;
  const float way = kClosestToWall * c.spacing - w.distance;
  const float out = way > 0.0f ? minimum(0.2f * way / c.timeStep, 0.01f * soundSpeed) : way / c.timeStep;
  const float normal = (velocity.x - w.vx) * w.nx + (velocity.y - w.vy) * w.ny + (velocity.z - w.vz) * w.nz;
  const float more = maximum(out - normal, 0.0f);
  velocity.x += more * w.nx;
  velocity.y += more * w.ny;
  velocity.z += more * w.nz;
  return more;
}

/// Takes friction of `kick` seconds from a velocity: no-slip implicitly (stable at any step, and what sticks
/// is carried along), Coulomb's until the slide is used up. `gain` is the speed along the normal that the
/// wall gives, m/s: what Coulomb's friction goes by.
SPIN_HD_INLINE void rubAlong(const FlowView& v, std::size_t i, const WallContact& w, float gain, float kick,
                             PairVector<float>& velocity) {
  const WallSurface& surface = v.walls.surface[w.surface];
  if (surface.friction == WallFriction::FreeSlip) return;
  const PairVector<float> slide = slideAlong(w, velocity);
  float keep = 1.0f;
  if (surface.friction == WallFriction::NoSlip) {
    keep = 1.0f / (1.0f + kick * stickRate(v, i, w));
  } else {
    const float speed = squareRoot(slide.x * slide.x + slide.y * slide.y + slide.z * slide.z);
    const float loss = surface.tangent * gain;
    keep = speed > loss ? 1.0f - loss / speed : 0.0f;
    keep /= 1.0f + kick * turbulentRate(v, w, speed);
  }
  velocity.x -= (1.0f - keep) * slide.x;
  velocity.y -= (1.0f - keep) * slide.y;
  velocity.z -= (1.0f - keep) * slide.z;
}

/// Calls visit(contact, slope) for every wall near particle i: slope is that of solidShare(), 1/m, weighted
/// where several walls meet.
template <class Visit>
SPIN_HD_INLINE void forWallSlopes(const FlowView& v, std::size_t i, const Visit& visit) {
  const FlowConstants& c = v.constants;
  WallShares shares;
  v.nearWalls(i, [&](const WallContact& w)
                     SPIN_INLINE_LAMBDA { shares.add(solidShare(w.distance / c.support, c.layer).density); });
  v.nearWalls(i, [&](const WallContact& w) SPIN_INLINE_LAMBDA {
    const SolidShare share = solidShare(w.distance / c.support, c.layer);
    visit(w, shares.weight(share.density) * share.slope / c.support);
  });
}

/// Rate of the excess of particle i by walls, 1/s.
SPIN_HD_INLINE float wallRate(const FlowView& v, std::size_t i) {
  const PairRecord& r = v.record[i];
  float rate = 0.0f;
  forWallSlopes(v, i, [&](const WallContact& w, float slope) SPIN_INLINE_LAMBDA {
    rate -= slope * ((r.vx - w.vx) * w.nx + (r.vy - w.vy) * w.ny + (r.vz - w.vz) * w.nz);
  });
  return rate;
}

/// Acceleration of particle i by a wall, m/s2: (P_i + what wallHead() adds) slope / rho0. The pressure that
/// is solved for has the head in it.
SPIN_HD_INLINE float wallPushOf(const FlowView& v, std::size_t i, const WallContact& w, float slope) {
  const FlowConstants& c = v.constants;
  const PairRecord& r = v.record[i];
  const float along = c.gravityX * w.nx + c.gravityY * w.ny + c.gravityZ * w.nz;
  const float head =
      v.pressureSolve.pressure ? 0.0f : wallHead(r.pressureTerm, r.restDensity, along, w.distance, c.spacing);
  return slope / r.restDensity * (r.pressureTerm + head);
}

}  // namespace spin
