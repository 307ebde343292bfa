// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sph/flow_passes.h"

/// Sums of the implicit and of the stress form of viscosity, in the form of flow_passes.h.
namespace spin {

/// sum (mu_i + mu_j) slope (d_i - d_j) and sum (mu_i + mu_j) slope over neighbours, d the direction: what
/// takes part in the matrix rho_i d_i - factor sum(...) of the pairwise form (Morris et al. 1997), which is
/// symmetric because all particles have one volume.
template <class Lanes>
struct ViscousProductPass {
  using T = typename Lanes::Real;
  PairVector<T> direction, sum{T(0.0f), T(0.0f), T(0.0f)};
  T viscosity, weights = T(0.0f);

  SPIN_HD_INLINE ViscousProductPass(const FlowView& v, const Lanes& own)
      : direction{own.load(v.viscousSolve.direction, &ViscousRecord::x),
                  own.load(v.viscousSolve.direction, &ViscousRecord::y),
                  own.load(v.viscousSolve.direction, &ViscousRecord::z)},
        viscosity(own.load(v.viscousSolve.direction, &ViscousRecord::viscosity)) {}
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const ViscousRecord& r = v.viscousSolve.direction[j];
    const T weight = (viscosity + T(r.viscosity)) * CubicSpline::slopeOverQ(distanceOf(offset));
    weights = weights + weight;
    sum.x = mulAdd(weight, direction.x - T(r.x), sum.x);
    sum.y = mulAdd(weight, direction.y - T(r.y), sum.y);
    sum.z = mulAdd(weight, direction.z - T(r.z), sum.z);
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& own) const {
    const T density = own.load(v.record, &PairRecord::restDensity), factor = T(-v.viscousSolve.factor);
    // A particle's own summand has no difference of directions, so it is no part of the diagonal either.
    const T self = T(2.0f) * viscosity * CubicSpline::slopeOverQ(T(0.0f));
    own.store(mulAdd(factor, sum.x, density * direction.x), v.viscousSolve.qx);
    own.store(mulAdd(factor, sum.y, density * direction.y), v.viscousSolve.qy);
    own.store(mulAdd(factor, sum.z, density * direction.z), v.viscousSolve.qz);
    own.store(mulAdd(factor, weights - self, density), v.viscousSolve.diagonal);
  }
};

/// Share of the viscosity that acts pairwise in the stress form too: velocities that change sign from one
/// particle to the next have no gradient, so no stress would ever calm them.
inline constexpr float kPairShare = 0.2f;

/// Divergence of the stress: a_i += V0 / rho_i sum (T_i + T_j) . grad W with T = tau rho0^2 / rho^2, the
/// symmetric form (Monaghan 1992), which conserves momentum.
template <class Lanes>
struct StressPass {
  using T = typename Lanes::Real;
  T own[6];
  PairVector<T> sum{T(0.0f), T(0.0f), T(0.0f)};

  SPIN_HD_INLINE StressPass(const FlowView& v, const Lanes& lanes)
      : own{lanes.load(v.stress, &StressRecord::xx), lanes.load(v.stress, &StressRecord::yy),
            lanes.load(v.stress, &StressRecord::zz), lanes.load(v.stress, &StressRecord::xy),
            lanes.load(v.stress, &StressRecord::xz), lanes.load(v.stress, &StressRecord::yz)} {}
  SPIN_HD_INLINE void add(const FlowView& v, const PairVector<T>& offset, std::uint32_t j) {
    const StressRecord& r = v.stress[j];
    const T slope = CubicSpline::slopeOverQ(distanceOf(offset));
    const PairVector<T> w{slope * offset.x, slope * offset.y, slope * offset.z};
    const T xy = own[3] + T(r.xy), xz = own[4] + T(r.xz), yz = own[5] + T(r.yz);
    sum.x = sum.x - mulAdd(own[0] + T(r.xx), w.x, mulAdd(xy, w.y, xz * w.z));
    sum.y = sum.y - mulAdd(own[1] + T(r.yy), w.y, mulAdd(xy, w.x, yz * w.z));
    sum.z = sum.z - mulAdd(own[2] + T(r.zz), w.z, mulAdd(xz, w.x, yz * w.y));
  }
  SPIN_HD_INLINE void write(const FlowView& v, const Lanes& lanes) const {
    const T scale =
        T((1.0f - kPairShare) * v.constants.gradientFactor) / lanes.load(v.record, &PairRecord::restDensity);
    lanes.store(mulAdd(scale, sum.x, lanes.load(v.ax)), v.ax);
    lanes.store(mulAdd(scale, sum.y, lanes.load(v.ay)), v.ay);
    lanes.store(mulAdd(scale, sum.z, lanes.load(v.az)), v.az);
  }
};

}  // namespace spin
