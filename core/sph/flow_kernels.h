// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/atomic_extent.h"
#include "core/physics/equation_of_state.h"
#include "core/sph/flow_passes.h"
#include "core/sph/row_search.h"
#include "core/sph/wall_friction.h"

/// The stages that go over single particles or rows, and the pair passes in their thread-per-particle form.
namespace spin {

/// Dead particles that are still in the arrays, by material.
struct FlowLossCount {
  std::uint32_t left[kMostMaterials], sunk[kMostMaterials], taken[kMostMaterials];
  std::int64_t leftGiven[kMostMaterials], sunkGiven[kMostMaterials], takenGiven[kMostMaterials];
};
struct JoinLosses {
  SPIN_HD FlowLossCount operator()(FlowLossCount a, const FlowLossCount& b) const {
    for (std::size_t m = 0; m < kMostMaterials; ++m) {
      a.left[m] += b.left[m];
      a.sunk[m] += b.sunk[m];
      a.taken[m] += b.taken[m];
      a.leftGiven[m] += b.leftGiven[m];
      a.sunkGiven[m] += b.sunkGiven[m];
      a.takenGiven[m] += b.takenGiven[m];
    }
    return a;
  }
};

/// Cells that particles lie in, how many particles live, and the number of one whose state is not finite.
struct FlowBounds {
  std::int32_t lowY, highY, lowZ, highZ;
  std::uint32_t alive;
  std::uint32_t broken;  ///< id, or UINT32_MAX
};
SPIN_HD_INLINE FlowBounds noBounds() {
  return {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN, 0, UINT32_MAX};
}
struct JoinBounds {
  SPIN_HD FlowBounds operator()(const FlowBounds& a, const FlowBounds& b) const {
    return {a.lowY < b.lowY ? a.lowY : b.lowY,
            a.highY > b.highY ? a.highY : b.highY,
            a.lowZ < b.lowZ ? a.lowZ : b.lowZ,
            a.highZ > b.highZ ? a.highZ : b.highZ,
            a.alive + b.alive,
            a.broken < b.broken ? a.broken : b.broken};
  }
};
struct BoundsOf {
  FlowView v;
  SPIN_HD FlowBounds operator()(std::size_t i) const {
    if (v.extra[i].flags & kDead) return noBounds();
    const std::int32_t y = v.y[i] >> kCellBits, z = v.z[i] >> kCellBits;
    const PairRecord& r = v.record[i];
    const float sum = r.vx + r.vy + r.vz + v.excess[i];
    return {y, y, z, z, 1, sum - sum == 0.0f ? UINT32_MAX : v.id[i]};
  }
};

struct ClearRowKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t r) const { v.rows[r] = {INT32_MAX, INT32_MIN, 0}; }
};

/// Widens each row to the bins of its particles. The order in which that happens does not matter.
struct RowExtentKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    if (v.extra[i].flags & kDead) return;
    FlowRow& row = v.rows[v.grid.rowOf(v.y[i], v.z[i])];
    const std::int32_t bin = v.x[i] >> kBinBits;
    lowerTo(row.firstBin, bin);
    raiseTo(row.lastBin, bin);
  }
};

/// Number of bins by rank.
struct RowBinsKernel {
  FlowView v;
  std::uint32_t* bins;
  SPIN_HD void operator()(std::size_t rank) const {
    const std::int32_t r = v.grid.rowAtRank(static_cast<std::int32_t>(rank));
    bins[rank] = r < 0 || v.rows[r].lastBin < v.rows[r].firstBin
                     ? 0u
                     : static_cast<std::uint32_t>(v.rows[r].lastBin - v.rows[r].firstBin) + 1u;
  }
};

struct RowStartKernel {
  FlowView v;
  const std::uint32_t* start;
  SPIN_HD void operator()(std::size_t r) const {
    v.rows[r].start = start[v.grid.rankOf(static_cast<std::int32_t>(r))];
  }
};

/// Sort key: the bin's number; the dead go behind all.
struct KeyKernel {
  FlowView v;
  std::uint32_t binCount;
  SPIN_HD void operator()(std::size_t i) const {
    const FlowRow& row = v.rows[v.extra[i].flags & kDead ? 0 : v.grid.rowOf(v.y[i], v.z[i])];
    v.key[i] = v.extra[i].flags & kDead
                   ? binCount
                   : row.start + static_cast<std::uint32_t>((v.x[i] >> kBinBits) - row.firstBin);
  }
};

/// Copies particles into sorted order; velocities go by way of the acceleration arrays, which are free now.
struct GatherKernel {
  FlowView v;
  const std::uint32_t* order;
  std::int32_t *x, *y, *z;
  ParticleExtra* extra;
  std::uint32_t *id, *key;
  float* excess;
  std::int32_t* given;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t from = order[i];
    excess[i] = v.excess[from];
    if (v.given) given[i] = v.given[from];
    x[i] = v.x[from];
    y[i] = v.y[from];
    z[i] = v.z[from];
    extra[i] = v.extra[from];
    id[i] = v.id[from];
    key[i] = v.key[from];
    v.ax[i] = v.record[from].vx;
    v.ay[i] = v.record[from].vy;
    v.az[i] = v.record[from].vz;
  }
};

struct TakeVelocityKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    v.record[i].vx = v.ax[i];
    v.record[i].vy = v.ay[i];
    v.record[i].vz = v.az[i];
  }
};

/// Particle i starts every bin after its predecessor's up to its own; i = count closes the rest.
struct BinStartKernel {
  FlowView v;
  std::uint32_t binCount;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t first = i == 0 ? 0 : v.key[i - 1] + 1;
    const std::uint32_t last = i == v.count ? binCount : v.key[i];
    for (std::uint32_t bin = first; bin <= last; ++bin) v.binStart[bin] = static_cast<std::uint32_t>(i);
  }
};

/// Position in the solver's metres.
SPIN_HD_INLINE PairVector<float> metresOf(const FlowView& v, std::size_t i) {
  const float metres = 1.0f / v.constants.unitsPerMetre;
  return {static_cast<float>(v.x[i]) * metres, static_cast<float>(v.y[i]) * metres,
          static_cast<float>(v.z[i]) * metres};
}

/// The stage after the sort begins with it.
SPIN_HD_INLINE void findGround(const FlowView& v, std::size_t i) {
  if (!v.ground) return;
  const PairVector<float> p = metresOf(v, i);
  v.ground[i] = v.walls.nearGround(p.x, p.y, p.z, v.constants.support);
}

/// Density from the pair sum and the walls' share, then pressure; the viscosity of what needs no shear rate.
struct PressureKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const FlowConstants& c = v.constants;
    findGround(v, i);
    WallShares shares;
    bool touches = false;
    v.nearWalls(i, [&](const WallContact& wall) {
      shares.add(solidShare(wall.distance / c.support, c.layer).density);
      touches = true;
    });
    ParticleExtra& extra = v.extra[i];
    extra.flags = touches ? extra.flags | kNearWall : extra.flags & ~kNearWall;
    const FlowMaterial& material = c.material[extra.material];
    const float excess = v.rate ? v.excess[i] : c.densityFactor * v.excess[i] + (shares.solid() - 1.0f);
    float pressure = material.tait ? taitPressure(excess, material.restDensity, material.soundSpeed)
                                   : linearPressure(excess, material.restDensity, material.soundSpeed);
    if (c.clampTension) pressure = clampTension(pressure, material.tension);
    v.excess[i] = excess;
    PairRecord& r = v.record[i];
    r.pressureTerm = pressure / ((1.0f + excess) * (1.0f + excess));
    r.restDensity = material.restDensity;
    if (!material.rheology.needsShearRate()) r.viscosity = material.rheology.viscosity;
  }
};

/// What limits the step: the least of each kind over all particles, s, and the number of a particle whose
/// acceleration is not finite.
struct StepLimits {
  float sound, force, viscous;
  std::uint32_t broken;
};
SPIN_HD_INLINE StepLimits noLimits() {
  return {INFINITY, INFINITY, INFINITY, UINT32_MAX};
}
struct JoinLimits {
  SPIN_HD StepLimits operator()(const StepLimits& a, const StepLimits& b) const {
    return {minimum(a.sound, b.sound), minimum(a.force, b.force), minimum(a.viscous, b.viscous),
            a.broken < b.broken ? a.broken : b.broken};
  }
};
struct LimitsOf {
  FlowView v;
  float courant, forceFactor, viscousFactor;
  SPIN_HD StepLimits operator()(std::size_t i) const {
    const FlowConstants& c = v.constants;
    const PairRecord& r = v.record[i];
    const float ax = v.ax[i] + c.gravityX, ay = v.ay[i] + c.gravityY, az = v.az[i] + c.gravityZ;
    const float a2 = ax * ax + ay * ay + az * az, speed = squareRoot(r.vx * r.vx + r.vy * r.vy + r.vz * r.vz);
    const float check = a2 + speed;
    const float nu = r.viscosity / r.restDensity;
    return {courant * c.spacing / (c.material[v.extra[i].material].soundSpeed + speed),
            a2 > 0.0f ? forceFactor * squareRoot(c.spacing / squareRoot(a2)) : INFINITY,
            nu > 0.0f ? viscousFactor * c.spacing * c.spacing / nu : INFINITY,
            check - check == 0.0f ? UINT32_MAX : v.id[i]};
  }
};

/// The nearest whole number, ties to even, of |x| < 2^22: rintf() without SSE 4.1 is a call.
SPIN_HD_INLINE float nearestWhole(float x) {
  constexpr float kShift = 12582912.0f;  // 1.5 * 2^23: a float has no fraction there
  return (x + kShift) - kShift;
}

/// Velocity from the accelerations and the walls, then position from the new velocity (semi-implicit Euler;
/// with velocities half a step behind it is the leap-frog). `kick` is the time that velocities advance by,
/// timeStep that of positions.
struct IntegrateKernel {
  FlowView v;
  float kick;

  /// Pressure, solidity and friction of all walls near particle i; changes its velocity.
  SPIN_HD void actWalls(std::size_t i, PairVector<float>& velocity) const {
    forWallSlopes(v, i, [&](const WallContact& w, float slope) {
      const float push = wallPushOf(v, i, w, slope);
      velocity.x += kick * push * w.nx;
      velocity.y += kick * push * w.ny;
      velocity.z += kick * push * w.nz;
      const float held = holdOff(v, i, w, velocity);
      rubAlong(v, i, w, maximum(kick * push, 0.0f) + held, kick, velocity);
    });
  }

  /// Adds a displacement in m to a position and what it has below a unit; periodic axes wrap.
  SPIN_HD static void advance(std::int32_t& position, std::int16_t& rest, float displacement,
                              float unitsPerMetre, std::int32_t periodCells) {
    constexpr float kRest = 65536.0f;
    // Half a cell a step at most: a particle faster than that is beyond any stable step already.
    const float limit = 0.5f * static_cast<float>(kCellUnits);
    const float units = minimum(maximum(displacement * unitsPerMetre, -limit), limit) +
                        static_cast<float>(rest) * (1.0f / kRest);
    const float whole = nearestWhole(units);
    rest = static_cast<std::int16_t>(
        minimum(maximum(nearestWhole((units - whole) * kRest), -32767.0f), 32767.0f));
    position += static_cast<std::int32_t>(whole);
    const std::int32_t period = periodCells << kCellBits;
    if (period > 0) position += position < 0 ? period : position >= period ? -period : 0;
  }

  /// What pairs and bodies make of the velocity.
  SPIN_HD_INLINE PairVector<float> innerVelocity(std::size_t i) const {
    const PairRecord& r = v.record[i];
    PairVector<float> velocity{r.vx + kick * v.ax[i], r.vy + kick * v.ay[i], r.vz + kick * v.az[i]};
    if (v.sx) {
      velocity.x += v.sx[i];
      velocity.y += v.sy[i];
      velocity.z += v.sz[i];
    }
    return velocity;
  }
  /// The wind's drag, implicit in the velocity: no step is so long that it overshoots the wind.
  SPIN_HD_INLINE void addWind(const PairRecord& r, PairVector<float>& velocity) const {
    const FlowConstants& c = v.constants;
    if (!(c.windDrag > 0.0f)) return;
    const PairVector<float> u{c.windX - r.vx, c.windY - r.vy, c.windZ - r.vz};
    const float pull = kick * c.windDrag * squareRoot(u.x * u.x + u.y * u.y + u.z * u.z);
    const float share = pull / (1.0f + pull);
    velocity.x += share * u.x;
    velocity.y += share * u.y;
    velocity.z += share * u.z;
  }
  /// The velocity after the step: gravity, wind and walls on top of that.
  SPIN_HD_INLINE PairVector<float> newVelocity(std::size_t i) const {
    const FlowConstants& c = v.constants;
    PairVector<float> velocity = innerVelocity(i);
    velocity.x += kick * c.gravityX;
    velocity.y += kick * c.gravityY;
    velocity.z += kick * c.gravityZ;
    addWind(v.record[i], velocity);
    if (v.extra[i].flags & kNearWall) actWalls(i, velocity);
    return velocity;
  }

  SPIN_HD void operator()(std::size_t i) const {
    const FlowConstants& c = v.constants;
    PairRecord& r = v.record[i];
    const float fromWalls = v.rate && (v.extra[i].flags & kNearWall) ? wallRate(v, i) : 0.0f;
    const PairVector<float> velocity = newVelocity(i);
    r.vx = velocity.x;
    r.vy = velocity.y;
    r.vz = velocity.z;
    if (v.rate) v.excess[i] += c.timeStep * (v.rate[i] + fromWalls);
    ParticleExtra& extra = v.extra[i];
    advance(v.x[i], extra.restX, c.timeStep * velocity.x, c.unitsPerMetre, v.grid.periodX);
    advance(v.y[i], extra.restY, c.timeStep * velocity.y, c.unitsPerMetre, v.grid.periodY);
    advance(v.z[i], extra.restZ, c.timeStep * velocity.z, c.unitsPerMetre, v.grid.periodZ);
    leave(i);
  }

  /// Beyond the domain is nothing: the particle is dead.
  SPIN_HD void leave(std::size_t i) const {
    const bool in = v.x[i] >= 0 && v.y[i] >= 0 && v.z[i] >= 0 && v.x[i] < v.domainX && v.y[i] < v.domainY &&
                    v.z[i] < v.domainZ;
    if (!in) v.extra[i].flags |= kDead;
    if (in && v.sinks.count > 0) {
      const PairVector<float> p = metresOf(v, i);
      if (v.sinks.take(p.x, p.y, p.z)) v.extra[i].flags |= kDead | kSunk;
    }
  }
};

/// Sum of impulses, N s.
struct ImpulseSum {
  double x, y, z;
};
struct AddImpulse {
  SPIN_HD ImpulseSum operator()(const ImpulseSum& a, const ImpulseSum& b) const {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
};
struct MomentumOf {
  FlowView v;
  double volume;  ///< V0, m3
  SPIN_HD ImpulseSum operator()(std::size_t i) const {
    const PairRecord& r = v.record[i];
    const double mass = volume * static_cast<double>(r.restDensity);
    return {mass * static_cast<double>(r.vx), mass * static_cast<double>(r.vy),
            mass * static_cast<double>(r.vz)};
  }
};
/// What gravity, wind and walls are about to give a particle.
struct OuterImpulseOf {
  IntegrateKernel step;
  double volume;  ///< V0, m3
  SPIN_HD ImpulseSum operator()(std::size_t i) const {
    const PairVector<float> before = step.innerVelocity(i), after = step.newVelocity(i);
    const double mass = volume * static_cast<double>(step.v.record[i].restDensity);
    return {mass * (static_cast<double>(after.x) - static_cast<double>(before.x)),
            mass * (static_cast<double>(after.y) - static_cast<double>(before.y)),
            mass * (static_cast<double>(after.z) - static_cast<double>(before.z))};
  }
};

/// x_j - x_i in units of the support radius.
SPIN_HD_INLINE PairVector<float> pairOffset(const FlowView& v, std::size_t i, std::size_t j,
                                            const RowRange& range) {
  constexpr float kToSupport = 1.0f / static_cast<float>(kCellUnits);
  return {static_cast<float>(v.x[j] + range.shiftX - v.x[i]) * kToSupport,
          static_cast<float>(v.y[j] + range.shiftY - v.y[i]) * kToSupport,
          static_cast<float>(v.z[j] + range.shiftZ - v.z[i]) * kToSupport};
}

/// A pass with a thread per particle.
template <template <class> class Pass>
struct PairKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    const ScalarLanes own{static_cast<std::uint32_t>(i)};
    Pass<ScalarLanes> pass(v, own);
    forRowRanges(v, v.y[i] >> kCellBits, v.z[i] >> kCellBits, v.x[i], v.x[i], [&](const RowRange& range) {
      for (std::uint32_t j = range.begin; j < range.end; ++j) {
        const PairVector<float> offset = pairOffset(v, i, j, range);
        if (offset.x * offset.x + offset.y * offset.y + offset.z * offset.z < 1.0f) pass.add(v, offset, j);
      }
    });
    pass.write(v, own);
  }
};
/// Particles within the support, itself left out.
struct NeighbourKernel {
  FlowView v;
  SPIN_HD void operator()(std::size_t i) const {
    std::uint32_t found = 0;
    forRowRanges(v, v.y[i] >> kCellBits, v.z[i] >> kCellBits, v.x[i], v.x[i], [&](const RowRange& range) {
      for (std::uint32_t j = range.begin; j < range.end; ++j) {
        const PairVector<float> offset = pairOffset(v, i, j, range);
        found += offset.x * offset.x + offset.y * offset.y + offset.z * offset.z < 1.0f ? 1u : 0u;
      }
    });
    v.neighbours[i] = found - 1u;
  }
};

/// Dead particles by material and cause.
struct LossesOf {
  FlowView v;
  SPIN_HD FlowLossCount operator()(std::size_t i) const {
    FlowLossCount count{};
    const ParticleExtra& extra = v.extra[i];
    if (!(extra.flags & kDead)) return count;
    const std::int64_t given = v.given ? v.given[i] : 0;
    const bool taken = extra.flags & kTaken, sunk = extra.flags & kSunk;
    (taken ? count.taken : sunk ? count.sunk : count.left)[extra.material] = 1;
    (taken ? count.takenGiven : sunk ? count.sunkGiven : count.leftGiven)[extra.material] = given;
    return count;
  }
};

template <class Lanes>
using PlainForcePass = ForcePass<Lanes, false, false>;
template <class Lanes>
using SmoothForcePass = ForcePass<Lanes, true, false>;
template <class Lanes>
using ContinuityForcePass = ForcePass<Lanes, false, true>;
template <class Lanes>
using SmoothContinuityForcePass = ForcePass<Lanes, true, true>;

}  // namespace spin
