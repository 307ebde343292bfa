// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/air/velocity_passes.h"
#include "core/physics/humid_air.h"

/// Passes over the weight of the air with its load, and over water that changes its phase.
namespace spin {

/// The air round the cloud, and what the laws need of it.
struct AirAmbient {
  float temperature;  ///< K
  float pressure;     ///< Pa
  float vapour;       ///< kg/m3
  float density;      ///< kg/m3
};

/// No air is colder, K; the laws of humid air end there.
inline constexpr double kLeastTemperature = 50.0;

/// Density of humid air at a density of its vapour, kg/m3; K, Pa.
template <class Real>
SPIN_HD_INLINE Real moistDensity(Real temperature, Real vapour, Real pressure) {
  return humidAirDensity(pressure, vapour * lit<Real>(kVapourGasConstant) * temperature,
                         temperature - lit<Real>(273.15));
}

/// Density of vapour saturated over water, kg/m3, and how it grows with the temperature.
template <class Real>
SPIN_HD_INLINE Real saturatedVapour(Real temperature, Real& growth) {
  const Real t = clampBetween(temperature - lit<Real>(273.15), lit<Real>(-100.0), lit<Real>(100.0));
  const Real over = lit<Real>(1.0) / (lit<Real>(243.12) + t);
  const Real density = vapourDensity(saturationPressureWater(t), t);
  growth = density * (lit<Real>(17.62 * 243.12) * over * over - lit<Real>(1.0) / temperature);
  return density;
}

/// Density of the mixture over that round the cloud, less 1; the largest magnitude. Not a number where the
/// air is too cold to be or weighs nothing.
struct LoadPass {
  static constexpr AirResult kResult = AirResult::Most;
  const float* q[4];  ///< mist, snow, warmth, vapour
  AirAmbient ambient;
  int fogDensity;  ///< 1: rho = p / (R_av T), R_av = R_a (1 + 0.378 phi), phi the mist per kg of air (as
                   ///< published)
  float* load;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real one = lit<Real>(1.0), temperature = Real(ambient.temperature) + at.load(q[2]);
    Real ratio;
    if (fogDensity) {
      const Real share = (at.load(q[0]) + at.load(q[1])) / Real(ambient.density);
      ratio = Real(ambient.temperature) / (temperature * mulAdd(lit<Real>(0.378), share, one));
    } else {
      const Real air =
          moistDensity(temperature, Real(ambient.vapour) + at.load(q[3]), Real(ambient.pressure));
      ratio = (air + at.load(q[0]) + at.load(q[1])) / Real(ambient.density);
    }
    const Real load1 = ratio - one;
    at.store(load1, load);
    const Real broken = lit<Real>(NAN), weighs = selectLess(lit<Real>(0.0), ratio, load1, broken);
    const Real held = selectLess(temperature, lit<Real>(kLeastTemperature), broken, weighs);
    return maximum(held, -held);
  }
};

/// Buoyancy along z at lower faces: g (rho_ambient - rho) / rho; or, as published, the difference of stacked
/// cells over the lower one's density.
struct BuoyancyPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float *load, *area, *open;
  float* w;
  float gain;  ///< gravity along z times time, m/s
  int stacked;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const Real one = lit<Real>(1.0), above = at.load(load), below = at.load(load, -strides.z);
    Real push;
    if (stacked) {
      push = (above - below) / (one + below);
    } else {
      const Real mean = lit<Real>(0.5) * (above + below);
      push = mean / (one + mean);
    }
    const Real moves = faceMoves(at, area, open, strides.z);
    at.store(mulAdd(Real(gain) * moves, push, at.load(w)), w);
  }
};

/// Mist and vapour seek saturation, with the heat that it takes (at constant pressure, Newton's method); the
/// sum is what condensed, not a number where a cell's state is none afterwards.
struct CondensePass {
  static constexpr AirResult kResult = AirResult::Sum;
  const float *volume, *open;
  float *mist, *warmth, *vapour;
  AirAmbient ambient;

  template <class At>
  SPIN_HD_INLINE typename At::Real operator()(const At& at) const {
    using Real = typename At::Real;
    const Real heat = lit<Real>(kEvaporationHeat / kDryAirHeat) / Real(ambient.density);  // K m3/kg
    const Real m = at.load(mist), dry = Real(ambient.vapour) + at.load(vapour);
    const Real warm = Real(ambient.temperature) + at.load(warmth);
    Real gained = lit<Real>(0.0);
    for (int pass = 0; pass < 3; ++pass) {
      Real growth;
      const Real saturated = saturatedVapour(mulAdd(heat, gained, warm), growth);
      gained = gained + (dry - gained - saturated) / mulAdd(heat, growth, lit<Real>(1.0));
      gained = maximum(gained, -m);
    }
    gained = gained * at.load(open);
    const Real wet = m + gained, left = at.load(vapour) - gained,
               warmer = mulAdd(heat, gained, at.load(warmth));
    at.store(wet, mist);
    at.store(left, vapour);
    at.store(warmer, warmth);
    const Real whole = mulAdd(lit<Real>(0.0), wet + left, gained * at.load(volume));
    return selectLess(lit<Real>(kLeastTemperature), Real(ambient.temperature) + warmer, whole,
                      lit<Real>(NAN));
  }
};

}  // namespace spin
