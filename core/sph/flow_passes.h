// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_view.h"
#include "core/sph/wall_law.h"

/// The sums over neighbours, each written once. `Lanes` names the particles that are summed for (one, or a
/// pack of consecutive ones) and loads and stores their values:
///   Real                      number or pack
///   load(array), load(records, member), store(value, array), first, count
///   unpack(value, lanes), pack(lanes)     to and from one float a lane
/// A pass is made for the lanes, add()s every candidate in reach, and is written.
namespace spin {

/// One particle: CUDA, and the reference that packs are tested against.
struct ScalarLanes {
  using Real = float;
  std::uint32_t first = 0;
  static constexpr std::uint32_t count = 1;

  SPIN_HD_INLINE float load(const float* array) const { return array[first]; }
  template <class Record>
  SPIN_HD_INLINE float load(const Record* array, float Record::*member) const {
    return array[first].*member;
  }
  SPIN_HD_INLINE void store(float value, float* array) const { array[first] = value; }
  SPIN_HD_INLINE void unpack(float value, float* lanes) const { lanes[0] = value; }
  SPIN_HD_INLINE float pack(const float* lanes) const { return lanes[0]; }
};

/// Bare density sum into `excess`.
template <class Lanes>
struct DensityPass {
  using T = typename Lanes::Real;
  T sum = T(0.0f);

  SPIN_HD_INLINE DensityPass(const FlowView&, const Lanes&) {}
  SPIN_HD_INLINE void add(const FlowView&, const PairVector<T>& offset, std::uint32_t) {
    sum = sum + densityTerm(offset);
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const { own.store(sum, v.excess); }
};

/// The particle's velocity and that of others against it.
template <class Lanes>
struct OwnVelocity {
  using T = typename Lanes::Real;
  PairVector<T> velocity;

  SPIN_HD_INLINE OwnVelocity(const FlowView& v, const Lanes& own)
      : velocity{own.load(v.record, &PairRecord::vx), own.load(v.record, &PairRecord::vy),
                 own.load(v.record, &PairRecord::vz)} {}
  SPIN_HD_INLINE PairVector<T> against(const PairRecord& r) const {
    return {velocity.x - T(r.vx), velocity.y - T(r.vy), velocity.z - T(r.vz)};
  }
};

/// Symmetric 3 x 3 matrix inverted by cofactors times a matrix g: g M^-1, in place. Where the neighbourhood
/// is too poor for that (a few particles, or all in a plane) g stays as it is.
SPIN_HD_INLINE void correctGradient(const float* m, float* g) {
  const float cxx = m[1] * m[2] - m[5] * m[5], cxy = m[4] * m[5] - m[3] * m[2],
              cxz = m[3] * m[5] - m[4] * m[1];
  const float cyy = m[0] * m[2] - m[4] * m[4], cyz = m[3] * m[4] - m[0] * m[5],
              czz = m[0] * m[1] - m[3] * m[3];
  const float det = m[0] * cxx + m[3] * cxy + m[4] * cxz;
  if (!(det > 0.05f)) return;
  const float inverse = 1.0f / det;
  for (int a = 0; a < 3; ++a) {
    const float x = g[3 * a], y = g[3 * a + 1], z = g[3 * a + 2];
    g[3 * a] = (x * cxx + y * cxy + z * cxz) * inverse;
    g[3 * a + 1] = (x * cxy + y * cyy + z * cyz) * inverse;
    g[3 * a + 2] = (x * cxz + y * cyz + z * czz) * inverse;
  }
}

/// Adds what no-slip walls contribute to particle i's gradient sums, which are scaled already. Of what slides
/// along it a wall knows no gradient: there the sums are left one-sided as at a free surface, which the
/// correction makes up for.
SPIN_HD_INLINE void addWallGradients(const FlowView& v, std::size_t i, GradientSums<float>& sums) {
  const FlowConstants& c = v.constants;
  v.nearWalls(i, [&](const WallContact& wall) SPIN_INLINE_LAMBDA {
    if (v.walls.surface[wall.surface].friction != WallFriction::NoSlip) return;
    const PairRecord& r = v.record[i];
    const float distance = maximum(wall.distance, kLeastWallDistance * c.spacing);
    addWallGradient(wall, wall.distance / c.support, distance,
                    {r.vx - wall.vx, r.vy - wall.vy, r.vz - wall.vz}, sums);
  });
}

/// Brings the gradient from where its sums have it to the particle, and gives the shear rate at the nearest
/// no-slip wall; -1 without one.
SPIN_HD_INLINE float correctAtWalls(const FlowView& v, std::size_t i, float* g) {
  const FlowConstants& c = v.constants;
  const PairRecord& r = v.record[i];
  float change[9] = {}, nearest = c.support, shearAtWall = -1.0f;
  v.nearWalls(i, [&](const WallContact& w) SPIN_INLINE_LAMBDA {
    if (v.walls.surface[w.surface].friction != WallFriction::NoSlip) return;
    const float distance = maximum(w.distance, kLeastWallDistance * c.spacing);
    const PairVector<float> slope{g[0] * w.nx + g[1] * w.ny + g[2] * w.nz,
                                  g[3] * w.nx + g[4] * w.ny + g[5] * w.nz,
                                  g[6] * w.nx + g[7] * w.ny + g[8] * w.nz};
    const WallSlopes at =
        slopesAtWall(w, distance, c.support, {r.vx - w.vx, r.vy - w.vy, r.vz - w.vz}, slope);
    const float n[3] = {w.nx, w.ny, w.nz};
    for (int b = 0; b < 3; ++b) {
      change[b] += at.change.x * n[b];
      change[3 + b] += at.change.y * n[b];
      change[6 + b] += at.change.z * n[b];
    }
    if (w.distance < nearest) nearest = w.distance, shearAtWall = at.shearAtWall;
  });
  for (int k = 0; k < 9; ++k) g[k] += change[k];
  return shearAtWall;
}

/// Shear rate and, from it, the viscosity of particle i, and of the wall near it.
SPIN_HD_APART void finishShear(const FlowView& v, std::size_t i, GradientSums<float>& sums) {
  const FlowConstants& c = v.constants;
  // V0 norm/h^3 = densityFactor scales the matrix, V0 norm/h^4 the gradient.
  for (float& value : sums.g) value *= c.gradientFactor;
  for (float& value : sums.m) value *= c.densityFactor;
  addWallGradients(v, i, sums);
  correctGradient(sums.m, sums.g);
  const float atWall = (v.extra[i].flags & kNearWall) != 0 ? correctAtWalls(v, i, sums.g) : -1.0f;
  const float rate = shearRateOf(sums.g);
  const float e = 1.0f + v.excess[i];
  v.shearRate[i] = rate;
  const Rheology& rheology = c.material[v.extra[i].material].rheology;
  const float pressure = v.record[i].pressureTerm * e * e;
  const float viscosity = apparentViscosity(rheology, rate, pressure);
  v.record[i].viscosity = viscosity;
  v.wallViscosity[i] =
      atWall < 0.0f ? viscosity : 0.5f * (viscosity + apparentViscosity(rheology, atWall, pressure));
  if (!v.stress) return;
  // tau = 2 mu D, over the square of the relative density.
  const float* g = sums.g;
  const float twice = 2.0f * viscosity / (e * e), once = 0.5f * twice;
  v.stress[i] = {twice * g[0],         twice * g[4],         twice * g[8],
                 once * (g[1] + g[3]), once * (g[2] + g[6]), once * (g[5] + g[7])};
}

/// Velocity gradient, shear rate and viscosity. Others read velocities meanwhile, which it leaves alone.
template <class Lanes>
struct ShearPass : OwnVelocity<Lanes> {
  using T = typename Lanes::Real;
  GradientSums<T> sums;

  SPIN_HD_INLINE ShearPass(const FlowView& v, const Lanes& own) : OwnVelocity<Lanes>(v, own) { sums.clear(); }
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    sums.add(offset, this->against(v.record[j]));
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    float lanes[15][kPairPadding];
    for (int k = 0; k < 9; ++k) own.unpack(sums.g[k], lanes[k]);
    for (int k = 0; k < 6; ++k) own.unpack(sums.m[k], lanes[9 + k]);
    for (std::uint32_t l = 0; l < own.count; ++l) {
      GradientSums<float> one;
      for (int k = 0; k < 9; ++k) one.g[k] = lanes[k][l];
      for (int k = 0; k < 6; ++k) one.m[k] = lanes[9 + k][l];
      finishShear(v, own.first + l, one);
    }
  }
};

/// What changes a particle's density by continuity, without factors: sum V_j (v_i - v_j) . grad W, and the
/// diffusion of Molteni and Colagrossi 2009 in the form of Fourtakas et al. 2019: what is left of a pair's
/// `difference` in pressure over c^2 after that of fluid at rest of the pair's mean density. `atRest` is the
/// gravity over c^2, per support. Pressure, for the excess jumps where materials of two densities meet.
/// The divergence is that of the velocities before the step, which would let sound grow by (omega dt)^2 / 2 a
/// step: what the step's pressure changes it by, dt c^2 times the Laplacian of the same difference, is added
/// to the diffusion, and density and velocity follow each other as in the symplectic Euler scheme.
template <class T>
struct DensityRate {
  T sum = T(0.0f), spread = T(0.0f);

  SPIN_HD_INLINE void add(const PairVector<T>& offset, T slope, const PairVector<T>& relative, T difference,
                          T meanDensity, const PairVector<T>& atRest) {
    const T approach = mulAdd(relative.z, offset.z, mulAdd(relative.y, offset.y, relative.x * offset.x));
    const T still = mulAdd(atRest.z, offset.z, mulAdd(atRest.y, offset.y, atRest.x * offset.x));
    sum = sum - slope * approach;
    spread = spread - slope * (difference - meanDensity * still);
  }
};

/// By continuity a particle that flies alone would keep the density that it had when it left the others, and
/// bounce like a spring wherever it meets a solid. Where others fill less than kAlone of its surroundings it
/// is let go at the rate at which sound crosses the support; from kCompany on (two or three neighbours) not
/// at all.
inline constexpr float kAlone = 0.1f, kCompany = 0.25f;

/// Pressure and pairwise viscosity, and with Smooth the velocity change of XSPH (Monaghan 1989):
/// c sum m_j / rho_mean (v_j - v_i) W; with Continuity the rate of the density.
template <class Lanes, bool Smooth, bool Continuity>
struct ForcePass : OwnVelocity<Lanes> {
  using T = typename Lanes::Real;
  PairVector<T> force{T(0.0f), T(0.0f), T(0.0f)}, change{T(0.0f), T(0.0f), T(0.0f)};
  T pressure, viscosity, density, drag;
  T surplus = T(0.0f);  ///< excess times the density at rest, kg/m3
  DensityRate<T> rate;
  T around = T(0.0f);  ///< sum of W, its own among them

  SPIN_HD_INLINE ForcePass(const FlowView& v, const Lanes& own)
      : OwnVelocity<Lanes>(v, own),
        pressure(own.load(v.record, &PairRecord::pressureTerm)),
        viscosity(own.load(v.record, &PairRecord::viscosity)),
        density(own.load(v.record, &PairRecord::restDensity)),
        drag(T(v.constants.pairDrag * v.constants.viscousFactor / v.constants.gradientFactor)) {
    if constexpr (Continuity) surplus = own.load(v.excess) * density;
  }
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const PairRecord& r = v.record[j];
    const PairVector<T> relative = this->against(r);
    const T q = distanceOf(offset), slope = CubicSpline::slopeOverQ(q);
    if constexpr (Continuity) {
      const FlowConstants& c = v.constants;
      rate.add(offset, slope, relative, T(v.excess[j] * r.restDensity) - surplus,
               T(0.5f) * (density + T(r.restDensity)), {T(c.restX), T(c.restY), T(c.restZ)});
      around = around + CubicSpline::shape(q);
    }
    addPairForce(offset, slope, pressure + T(r.pressureTerm), drag * (viscosity + T(r.viscosity)), relative,
                 force);
    if constexpr (Smooth) {
      const T weight = CubicSpline::shape(q) * T(r.restDensity) / (density + T(r.restDensity));
      change.x = change.x - weight * relative.x;
      change.y = change.y - weight * relative.y;
      change.z = change.z - weight * relative.z;
    }
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    const T scale = T(v.constants.gradientFactor) / density;
    own.store(scale * force.x, v.ax);
    own.store(scale * force.y, v.ay);
    own.store(scale * force.z, v.az);
    if constexpr (Continuity) {
      const FlowConstants& c = v.constants;
      const T others = T(c.densityFactor) * (around - T(1.0f));
      const T alone =
          minimum(maximum(T(1.0f / (kCompany - kAlone)) * (T(kCompany) - others), T(0.0f)), T(1.0f));
      const T spread = T(c.diffusionFactor + c.soundFactor * c.timeStep) * rate.spread;
      own.store(T(c.gradientFactor) * rate.sum + (spread - T(c.aloneRate) * alone * surplus) / density,
                v.rate);
    }
    if constexpr (Smooth) {
      const T smooth = T(2.0f * v.constants.smoothFactor);
      own.store(smooth * change.x, v.sx);
      own.store(smooth * change.y, v.sy);
      own.store(smooth * change.z, v.sz);
    }
  }
};

}  // namespace spin
