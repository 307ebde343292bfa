// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/body_law.h"

/// The stages of bodies in the flow.
namespace spin {

/// Unsorted boundary particles while they are placed.
struct BodyPlaces {
  std::int32_t *x, *y, *z;
  ParticleExtra* extra;
};

/// Puts a boundary particle where its body is now; one that no flow is near is dead for this step.
struct PlaceBodyKernel {
  FlowView flow;
  const BodyPoint* points;
  const BodyPose* poses;
  BodyPlaces to;

  SPIN_HD static std::int32_t wrapped(std::int32_t units, std::int32_t periodCells) {
    const std::int32_t period = periodCells << kCellBits;
    if (period == 0) return units;
    const std::int32_t rest = units % period;
    return rest < 0 ? rest + period : rest;
  }
  SPIN_HD void operator()(std::size_t b) const {
    const BodyPoint& p = points[b];
    const BodyPose& pose = poses[p.body];
    const float* r = pose.turn;
    const float scale = flow.constants.unitsPerMetre;
    const float dx = (r[0] * p.x + r[1] * p.y + r[2] * p.z) * scale + pose.restX,
                dy = (r[3] * p.x + r[4] * p.y + r[5] * p.z) * scale + pose.restY,
                dz = (r[6] * p.x + r[7] * p.y + r[8] * p.z) * scale + pose.restZ;
    const FlowGrid& grid = flow.grid;
    const std::int32_t x = wrapped(pose.x + static_cast<std::int32_t>(rintf(dx)), grid.periodX),
                       y = wrapped(pose.y + static_cast<std::int32_t>(rintf(dy)), grid.periodY),
                       z = wrapped(pose.z + static_cast<std::int32_t>(rintf(dz)), grid.periodZ);
    bool near = false;
    if (pose.there != 0)
      forRowRanges(flow, y >> kCellBits, z >> kCellBits, x, x, [&](const RowRange&) { near = true; });
    to.x[b] = x;
    to.y[b] = y;
    to.z[b] = z;
    to.extra[b] = {0, 0, 0, 0, near ? std::uint8_t{0} : kDead};
  }
};

/// Rows that boundary particles near the flow lie in, and their number.
struct BodyBoundsOf {
  BodyPlaces p;
  SPIN_HD FlowBounds operator()(std::size_t b) const {
    if (p.extra[b].flags & kDead) return noBounds();
    const std::int32_t y = p.y[b] >> kCellBits, z = p.z[b] >> kCellBits;
    return {y, y, z, z, 1, UINT32_MAX};
  }
};

/// Copies boundary particle order[b] to its sorted place.
struct GatherBodyKernel {
  BodyPlaces from;
  const std::uint32_t *order, *key;
  const BodyPoint* points;
  const BodyPose* poses;
  const std::uint8_t* surfaces;  ///< by body
  std::int32_t *x, *y, *z;
  std::uint32_t* sortedKey;
  BodyRecord* record;
  SPIN_HD void operator()(std::size_t b) const {
    const std::uint32_t k = order[b];
    x[b] = from.x[k];
    y[b] = from.y[k];
    z[b] = from.z[k];
    sortedKey[b] = key[k];
    const BodyPoint& p = points[k];
    const BodyPose& pose = poses[p.body];
    const float* r = pose.turn;
    const float ax = r[0] * p.x + r[1] * p.y + r[2] * p.z, ay = r[3] * p.x + r[4] * p.y + r[5] * p.z,
                az = r[6] * p.x + r[7] * p.y + r[8] * p.z;
    record[b] = {pose.vx + pose.wy * az - pose.wz * ay,
                 pose.vy + pose.wz * ax - pose.wx * az,
                 pose.vz + pose.wx * ay - pose.wy * ax,
                 ax,
                 ay,
                 az,
                 p.volume,
                 k,
                 surfaces[p.body]};
  }
};

/// 1 for a flow particle that has a boundary particle in the cells round it.
struct NearBodyKernel {
  FlowView v;
  FlowView boundary;
  std::uint32_t* near;
  SPIN_HD void operator()(std::size_t i) const {
    bool found = false;
    forRowRanges(boundary, v.y[i] >> kCellBits, v.z[i] >> kCellBits, v.x[i], v.x[i],
                 [&](const RowRange&) { found = true; });
    near[i] = found ? 1u : 0u;
  }
};

/// Lists those; slot is the sum of `near` before i, and of all at the end.
struct ListNearKernel {
  const std::uint32_t* slot;
  std::uint32_t count, listed;
  std::uint32_t* list;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t next = i + 1 < count ? slot[i + 1] : listed;
    if (next != slot[i]) list[slot[i]] = static_cast<std::uint32_t>(i);
  }
};

/// Adds bodies to the bare density sum.
struct BodyDensityKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    float sum = 0.0f;
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      sum += b.record[j].volume * densityTerm(d);
    });
    v.excess[i] += sum;
  }
};

/// Adds bodies to the density's rate by continuity.
struct BodyRateKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    const PairRecord& r = v.record[i];
    float sum = 0.0f;
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      const BodyRecord& w = b.record[j];
      const float approach = (r.vx - w.vx) * d.x + (r.vy - w.vy) * d.y + (r.vz - w.vz) * d.z;
      sum -= w.volume * CubicSpline::slopeOverQ(distanceOf(d)) * approach;
    });
    v.rate[i] += v.constants.gradientFactor * sum;
  }
};

/// Acceleration of flow particle i by the pressure of bodies, m/s2.
SPIN_HD_INLINE PairVector<float> bodyPressureOn(const FlowView& v, const BodyView& b, std::uint32_t i) {
  const FlowConstants& c = v.constants;
  const PairRecord& r = v.record[i];
  const float e = 1.0f + v.excess[i], pressure = r.pressureTerm * e * e;
  PairVector<float> sum{0.0f, 0.0f, 0.0f};
  forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
    const float push = bodyPush(v, r.pressureTerm, pressure, r.restDensity, d);
    const float scale = b.record[j].volume * bodyForceScale(c, push, CubicSpline::slopeOverQ(distanceOf(d)));
    sum.x += scale * d.x;
    sum.y += scale * d.y;
    sum.z += scale * d.z;
  });
  const float perMass = 1.0f / r.restDensity;
  return {sum.x * perMass, sum.y * perMass, sum.z * perMass};
}

/// Adds the pressure of bodies to the acceleration.
struct BodyPressureKernel {
  FlowView v;
  BodyView b;
  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    const PairVector<float> push = bodyPressureOn(v, b, i);
    v.ax[i] += push.x;
    v.ay[i] += push.y;
    v.az[i] += push.z;
    b.gift[k] = {push.x, push.y, push.z};
  }
};

/// What the surfaces near a flow particle are on the whole, and the nearest boundary particle.
struct BodySurfaces {
  float weight = 0.0f, most = 0.0f, nearest = 2.0f;
  PairVector<float> velocity{0.0f, 0.0f, 0.0f}, offset{0.0f, 0.0f, 0.0f};
  std::uint32_t holder = UINT32_MAX;
  std::uint8_t surface = 0;  ///< of the strongest
};

/// No slip, as viscosity between the particle and boundary particles that it is mirrored at, or Coulomb's
/// friction, implicit in the particle's own velocity, so that no step is too long; and no particle comes too
/// near to a boundary particle, however little its pressure resists. `kick` as in IntegrateKernel.
struct BodyRubKernel {
  FlowView v;
  BodyView b;
  float kick;

  SPIN_HD BodySurfaces surfacesAt(std::uint32_t i) const {
    BodySurfaces s;
    forBoundaryNear(v, b.grid, i, [&](const PairVector<float>& d, std::uint32_t j) {
      const BodyRecord& w = b.record[j];
      const float q = distanceOf(d), weight = bodyWeight(w.volume, CubicSpline::slopeOverQ(q));
      s.weight += weight;
      s.velocity.x += weight * w.vx;
      s.velocity.y += weight * w.vy;
      s.velocity.z += weight * w.vz;
      if (weight > s.most) s.most = weight, s.surface = w.surface;
      if (q < s.nearest) s.nearest = q, s.holder = j, s.offset = d;
    });
    return s;
  }

  SPIN_HD void operator()(std::size_t k) const {
    const std::uint32_t i = b.list[k];
    const BodySurfaces s = surfacesAt(i);
    BodyRub rub{0.0f, 0.0f, 0.0f, s.weight, 0.0f, 0.0f, 0.0f, UINT32_MAX};
    const WallSurface& surface = v.walls.surface[s.surface];
    if (s.weight > 0.0f && surface.friction != WallFriction::FreeSlip) {
      const PairRecord& r = v.record[i];
      const float mean = 1.0f / s.weight;
      const PairVector<float> slip{r.vx - s.velocity.x * mean, r.vy - s.velocity.y * mean,
                                   r.vz - s.velocity.z * mean};
      if (surface.friction == WallFriction::NoSlip)
        stick(s, slip, r, rub);
      else
        rubAlong(i, slip, surface, rub);
    }
    v.ax[i] += rub.x;
    v.ay[i] += rub.y;
    v.az[i] += rub.z;
    if (s.holder != UINT32_MAX && s.nearest > 0.0f) hold(i, s, rub);
    b.rub[k] = rub;
    v.ax[i] += rub.holdX;
    v.ay[i] += rub.holdY;
    v.az[i] += rub.holdZ;
    BodyGift& gift = b.gift[k];
    gift = {gift.x + rub.x + rub.holdX, gift.y + rub.y + rub.holdY, gift.z + rub.z + rub.holdZ};
  }

 private:
  SPIN_HD_INLINE void stick(const BodySurfaces& s, const PairVector<float>& slip, const PairRecord& r,
                            BodyRub& rub) const {
    const float rate = kBodyMirror * 2.0f * r.viscosity * b.viscousFactor * s.weight / r.restDensity;
    const float scale = -rate / (1.0f + kick * rate);
    rub.x = scale * slip.x, rub.y = scale * slip.y, rub.z = scale * slip.z;
  }
  SPIN_HD_INLINE void rubAlong(std::uint32_t i, const PairVector<float>& slip, const WallSurface& surface,
                               BodyRub& rub) const {
    const PairVector<float> push = bodyPressureOn(v, b, i);
    const float size = squareRoot(push.x * push.x + push.y * push.y + push.z * push.z);
    if (!(size > 0.0f)) return;
    const PairVector<float> n{push.x / size, push.y / size, push.z / size};
    const float along = slip.x * n.x + slip.y * n.y + slip.z * n.z;
    const PairVector<float> slide{slip.x - along * n.x, slip.y - along * n.y, slip.z - along * n.z};
    const float speed = squareRoot(slide.x * slide.x + slide.y * slide.y + slide.z * slide.z);
    if (!(speed > 0.0f)) return;
    // At most what stops it within the step.
    const float scale = -minimum(surface.tangent * size, speed / kick) / speed;
    rub.x = scale * slide.x, rub.y = scale * slide.y, rub.z = scale * slide.z;
  }
  SPIN_HD_INLINE void hold(std::uint32_t i, const BodySurfaces& s, BodyRub& rub) const {
    const FlowConstants& c = v.constants;
    const BodyRecord& w = b.record[s.holder];
    const float way = kClosestToBoundary * c.spacing - s.nearest * c.support;
    const float out = way > 0.0f
                          ? minimum(0.2f * way / kick, 0.01f * c.material[v.extra[i].material].soundSpeed)
                          : way / kick;
    const float scale = -1.0f / s.nearest;
    const PairVector<float> n{scale * s.offset.x, scale * s.offset.y, scale * s.offset.z};
    const PairRecord& r = v.record[i];
    const float apart = (r.vx + kick * (v.ax[i] + c.gravityX) - w.vx) * n.x +
                        (r.vy + kick * (v.ay[i] + c.gravityY) - w.vy) * n.y +
                        (r.vz + kick * (v.az[i] + c.gravityZ) - w.vz) * n.z;
    const float more = maximum(out - apart, 0.0f) / kick;
    if (!(more > 0.0f)) return;
    rub.holdX = more * n.x, rub.holdY = more * n.y, rub.holdZ = more * n.z;
    rub.holder = s.holder;
  }
};

struct ClearLoadKernel {
  BodyLoad* load;
  SPIN_HD void operator()(std::size_t b) const { load[b] = {0, 0, 0, 0, 0, 0}; }
};

/// Force and torque on one boundary particle by all flow particles near it.
struct BodyReactionKernel {
  FlowView v;
  BodyView b;
  BodyLoad* load;  ///< by BodyPoint
  double volume;   ///< V0, m3
  bool solved;     ///< after an implicit solve: the pressure that velocities have, not the next iterate's

  SPIN_HD static void add(BodyLoad& sum, double fx, double fy, double fz, double ax, double ay, double az) {
    sum.fx += fx, sum.fy += fy, sum.fz += fz;
    sum.tx += ay * fz - az * fy, sum.ty += az * fx - ax * fz, sum.tz += ax * fy - ay * fx;
  }
  SPIN_HD void operator()(std::size_t n) const {
    const FlowConstants& c = v.constants;
    const BodyRecord& w = b.record[n];
    BodyLoad sum{0, 0, 0, 0, 0, 0};
    // Seen from the boundary particle, flow particles are the others: d = x_i - x_b.
    forBoundaryNear(b.grid, v, n, [&](const PairVector<float>& d, std::uint32_t i) {
      const PairRecord& r = v.record[i];
      const float e = 1.0f + v.excess[i], slope = CubicSpline::slopeOverQ(distanceOf(d));
      const float term = solved ? v.pressureSolve.pressure[i] - v.pressureSolve.push[i] : r.pressureTerm;
      const float push = bodyPush(v, term, term * e * e, r.restDensity, {-d.x, -d.y, -d.z});
      const double scale = volume * static_cast<double>(w.volume * bodyForceScale(c, push, slope));
      add(sum, scale * static_cast<double>(d.x), scale * static_cast<double>(d.y),
          scale * static_cast<double>(d.z), static_cast<double>(w.armX), static_cast<double>(w.armY),
          static_cast<double>(w.armZ));
      const BodyRub& rub = b.rub[b.slot[i]];
      const double mass = -volume * static_cast<double>(r.restDensity);
      if (rub.holder == n)
        add(sum, mass * static_cast<double>(rub.holdX), mass * static_cast<double>(rub.holdY),
            mass * static_cast<double>(rub.holdZ), static_cast<double>(w.armX), static_cast<double>(w.armY),
            static_cast<double>(w.armZ));
      const float weight = bodyWeight(w.volume, slope);
      if (!(rub.weight > 0.0f)) return;
      // With the lever of the flow particle, so that angular momentum is kept too.
      const double share = mass * (static_cast<double>(weight) / static_cast<double>(rub.weight));
      add(sum, share * static_cast<double>(rub.x), share * static_cast<double>(rub.y),
          share * static_cast<double>(rub.z), static_cast<double>(w.armX + d.x * c.support),
          static_cast<double>(w.armY + d.y * c.support), static_cast<double>(w.armZ + d.z * c.support));
    });
    load[w.point] = sum;
  }
};

/// Sums the loads of a chunk in their order.
struct SumLoadKernel {
  const BodyLoad* load;
  const BodyChunk* chunk;
  BodyLoad* sum;
  SPIN_HD void operator()(std::size_t c) const {
    BodyLoad s{0, 0, 0, 0, 0, 0};
    for (std::uint32_t b = chunk[c].begin; b < chunk[c].end; ++b) {
      const BodyLoad& l = load[b];
      s.fx += l.fx, s.fy += l.fy, s.fz += l.fz, s.tx += l.tx, s.ty += l.ty, s.tz += l.tz;
    }
    sum[c] = s;
  }
};

}  // namespace spin
