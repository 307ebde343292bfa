// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/physics/bulk_transfer.h"
#include "core/physics/heat_row.h"
#include "core/physics/humidity.h"
#include "core/physics/snow_column_state.h"

/// The energy balance of the skin between the air and a column.
namespace spin {

/// Skin temperature and fluxes into the skin, W/m2; they sum up to `down`, heat into the column, and `melt`.
template <class V>
struct SkinFluxes {
  V temperature;
  V shortwave, longwave, sensible, latent;
  V snowVapour;  ///< kg/(m2 s) from snow to the air
  V down, melt;
};

/// What of the surface's exchange does not depend on its temperature.
template <class V>
struct SkinSetting {
  V cover;       ///< share of the ground that snow hides
  V hasSnow;     ///< 1 or 0: the skin cannot be warmer than 0
  V shortwave;   ///< W/m2 absorbed
  V airHeat;     ///< rho c_p U, W/(m2 K), neutral coefficient not included
  V airVapour;   ///< rho U, kg/(m2 s)
  V richardson;  ///< per K of difference between air and surface
  V neutral, unstable;
  V evaporation;  ///< m/s, conductance of bare ground
  V wind;
};

template <class V>
SPIN_HD_INLINE SkinSetting<V> skinSetting(const SnowColumn<V>& c, const GroundColumn<V>& g,
                                          const ColumnWeather<V>& w, const SnowParameters& p) {
  const V zero = lit<V>(0.0), one = lit<V>(1.0);
  const V depth = c.depth();
  SkinSetting<V> s;
  s.hasSnow = selectLess(zero, c.ice(), one, zero);
  s.cover = positiveTanh(depth / V(p.coverDepth)) * s.hasSnow;
  const V bare = one - s.cover;
  s.shortwave = w.shortwave * (one - s.cover * c.albedo - bare * g.albedo);
  // The logarithm of a mixture's roughness would need a power; its mean height serves.
  const V roughness = s.cover * V(p.roughness) + bare * g.roughness;
  const V least = lit<V>(1.0);
  const V windHeight = maximum(V(p.windHeight) - (p.windAboveSnow ? zero : depth), least);
  const V airHeight = maximum(V(p.airHeight) - (p.airAboveSnow ? zero : depth), least);
  const NeutralTransfer<V> transfer = neutralTransfer(windHeight, airHeight, roughness);
  s.neutral = transfer.coefficient;
  s.unstable = transfer.unstable;
  s.wind = maximum(w.wind, V(p.leastWind));
  const V airKelvin = w.airTemperature + lit<V>(kZeroCelsius);
  const V density = w.pressure / (lit<V>(kDryAirGasConstant) * airKelvin);
  s.airVapour = density * s.wind;
  s.airHeat = s.airVapour * lit<V>(kDryAirHeat);
  s.richardson =
      lit<V>(kStandardGravity) * windHeight * windHeight / (airHeight * airKelvin * s.wind * s.wind);
  s.evaporation = g.evaporation;
  return s;
}

/// Finds the skin's temperature by Newton's method, the exchange with the air by the temperature before.
/// Fluxes are those of the last tangent, so that they sum up exactly.
template <class V>
SPIN_HD_INLINE SkinFluxes<V> balanceSkin(const SkinSetting<V>& s, const BelowFace<V>& below,
                                         const ColumnWeather<V>& w, const SnowParameters& p, V start) {
  constexpr int kRounds = 4;
  const V zero = lit<V>(0.0), one = lit<V>(1.0);
  const V sigma = lit<V>(kStefanBoltzmann) * V(p.emissivity);
  const V warmest = selectLess(zero, s.hasSnow, zero, lit<V>(150.0));
  SkinFluxes<V> f;
  V t = minimum(start, warmest), free = t;
  for (int round = 0; round < kRounds; ++round) {
    const V kelvin = t + lit<V>(kZeroCelsius);
    const V factor = stabilityFactor(s.richardson * (w.airTemperature - t), s.unstable);
    const V exchange = s.neutral * factor;
    const V heat = mulAdd(s.airHeat, exchange, V(p.windlessExchange));
    // Bare ground gives vapour through a conductance of its own in series with the air's; dew meets none.
    const Saturation<V> at = saturation(t, w.pressure);
    const V air = exchange * s.wind;
    const V wet =
        selectLess(at.humidity, w.humidity, one, s.evaporation / maximum(s.evaporation + air, lit<V>(1e-9)));
    const V vapour = s.airVapour * exchange;
    const V snowVapour = vapour * s.cover, bareVapour = vapour * (one - s.cover) * wet;
    const V vapourHeat =
        lit<V>(kSublimationHeat) * snowVapour + lit<V>(kSublimationHeat - kFusionHeat) * bareVapour;
    const V cubed = kelvin * kelvin * kelvin;
    const V longwave = V(p.emissivity) * w.longwave - sigma * cubed * kelvin;
    const V sum =
        s.shortwave + longwave + heat * (w.airTemperature - t) + vapourHeat * (w.humidity - at.humidity);
    const V slope = lit<V>(4.0) * sigma * cubed + heat + vapourHeat * at.slope;
    const V step = (sum - below.conductance * (t - below.temperature)) / (slope + below.conductance);
    free = t + step;
    f.temperature = minimum(free, warmest);
    const V moved = f.temperature - t;
    f.shortwave = s.shortwave;
    f.longwave = longwave - lit<V>(4.0) * sigma * cubed * moved;
    f.sensible = heat * (w.airTemperature - f.temperature);
    const V lack = mulAdd(at.slope, moved, at.humidity) - w.humidity;
    f.latent = -vapourHeat * lack;
    f.snowVapour = snowVapour * lack;
    t = f.temperature;
  }
  const V all = f.shortwave + f.longwave + f.sensible + f.latent;
  const V conducted = below.conductance * (f.temperature - below.temperature);
  f.melt = selectLess(warmest, free, maximum(all - conducted, zero), zero);
  f.down = all - f.melt;
  return f;
}

}  // namespace spin
