// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/heat_row.h"
#include "core/physics/snow_layers.h"
#include "core/physics/snow_surface.h"

/// One step of a snow-covered column and its soil by energy balance. Heat goes through skin, snow and soil
/// implicitly in one sweep up and one down; whatever a flux leaves in one place it enters in another, so
/// energy and mass close to rounding.
namespace spin {

inline constexpr int kColumnLayers = kSnowLayers + kSoilLayers;

/// Snow and soil in one row. Water that can freeze holds a layer near 0 as a heat capacity would.
template <class V>
SPIN_HD_INLINE void fillHeatRow(HeatRow<V, kColumnLayers>& h, const SnowColumn<V>& c,
                                const GroundColumn<V>& g, V seconds) {
  const V zero = lit<V>(0.0), half = lit<V>(0.5);
  const V perSecond = lit<V>(1.0) / seconds;
  for (int i = 0; i < kSnowLayers; ++i) {
    const SnowLayer<V>& layer = c.snow[i];
    // The water's latent heat over 1 K.
    const V heat = lit<V>(kIceHeat) * layer.ice + lit<V>(kFusionHeat) * layer.liquid;
    h.storage[i] = heat * perSecond;
    h.resistance[i] = half * layer.depth / snowConductivity(layerDensity(layer));
    h.temperature[i] = layer.temperature;
  }
  const V latent = g.frozenWater * lit<V>(kFusionHeat / kFreezingRange);
  for (int i = 0; i < kSoilLayers; ++i) {
    const V t = c.soil[i];
    const V freezing = selectLess(t, zero, selectLess(lit<V>(-kFreezingRange), t, latent, zero), zero);
    h.storage[kSnowLayers + i] = (g.heatCapacity + freezing) * g.thickness[i] * perSecond;
    h.resistance[kSnowLayers + i] = half * g.thickness[i] / g.conductivity;
    h.temperature[kSnowLayers + i] = t;
  }
  h.below[kColumnLayers] = {g.deepConductance, g.deepTemperature};
}

/// Takes vapour from the snow's ice, from the top; returns what there was not enough ice for, kg/m2.
template <class V>
SPIN_HD_INLINE V takeVapour(SnowColumn<V>& c, V vapour, ColumnFluxes<V>& f) {
  const V zero = lit<V>(0.0), tiny = lit<V>(1e-12);
  V left = vapour;
  for (int i = 0; i < kSnowLayers; ++i) {
    SnowLayer<V>& layer = c.snow[i];
    // Frost goes to the first layer that there is.
    const V taken = selectLess(zero, layer.ice, minimum(left, layer.ice), zero);
    layer.depth = layer.depth * (lit<V>(1.0) - taken / maximum(layer.ice, tiny));
    f.carriedIn = f.carriedIn - lit<V>(kIceHeat) * taken * layer.temperature;
    addMass(layer.ice, -taken, c.rest);
    left = left - taken;
  }
  f.sublimated = vapour - left;
  return left;
}

/// Melts, refreezes and drains from the top; heat that is left over when all has melted is returned, water
/// that leaves is run-off.
template <class V>
SPIN_HD_INLINE V meltAndDrain(SnowColumn<V>& c, const HeatRow<V, kColumnLayers>& h, V skinMelt, V seconds,
                              const SnowParameters& p, ColumnFluxes<V>& f) {
  V heat = skinMelt * seconds, water = lit<V>(0.0);
  for (int i = 0; i < kSnowLayers; ++i) {
    SnowLayer<V>& layer = c.snow[i];
    addMass(layer.liquid, water, c.rest);
    heat = settlePhases(layer, heat + h.gain(i) * seconds, f, c.rest);
    water = excessWater(layer, p.heldWater);
    addMass(layer.liquid, -water, c.rest);
  }
  addMass(f.runoff, water, c.rest);
  f.carriedIn = f.carriedIn - lit<V>(kFusionHeat) * water;
  return heat;
}

/// What falls in the step: snow on the top layer, rain into the snow if there is any, else past it.
template <class V>
SPIN_HD_INLINE V takePrecipitation(SnowColumn<V>& c, const ColumnWeather<V>& w, V seconds,
                                   const SnowParameters& p, ColumnFluxes<V>& f) {
  const V zero = lit<V>(0.0);
  const V rest = selectLess(lit<V>(1.0), c.snow[0].ice, c.rest, zero);
  c.rest = c.rest - rest;
  addMass(c.snow[0].ice, rest, c.rest);
  f.snowIn = w.snowfall * seconds;
  f.rainIn = w.rainfall * seconds;
  const V cold = minimum(w.airTemperature, zero);
  addSnow(c.snow[0], f.snowIn, cold, newSnowDensityAt(w.airTemperature, p), c.rest);
  const V caught = selectLess(zero, c.ice(), f.rainIn, zero);
  addMass(c.snow[0].liquid, caught, c.rest);
  f.runoff = f.rainIn - caught;
  const V rainHeat = lit<V>(kWaterHeat) * caught * maximum(w.airTemperature, zero);
  f.carriedIn = lit<V>(kIceHeat) * f.snowIn * cold + lit<V>(kFusionHeat) * caught + rainHeat;
  return rainHeat;
}

/// Advances a column by `seconds`, an hour or less.
template <class V>
SPIN_HD_INLINE ColumnFluxes<V> advanceSnowColumn(SnowColumn<V>& c, const GroundColumn<V>& g,
                                                 const ColumnWeather<V>& w, const SnowParameters& p,
                                                 V seconds) {
  const V zero = lit<V>(0.0);
  ColumnFluxes<V> f;
  f.melted = f.refrozen = zero;
  // The first snow on bare ground is all new.
  c.albedo = selectLess(zero, c.ice(), c.albedo, V(p.freshAlbedo));
  const V rainHeat = takePrecipitation(c, w, seconds, p, f);
  c.albedo = agedAlbedo(c.albedo, c.surface, w.snowfall, p, seconds);

  HeatRow<V, kColumnLayers> h;
  fillHeatRow(h, c, g, seconds);
  sweepUp(h);
  const SkinFluxes<V> skin = balanceSkin(skinSetting(c, g, w, p), h.below[0], w, p, c.surface);
  c.surface = skin.temperature;
  sweepDown(h, skin.down, skin.temperature);
  f.baseFlux = -h.flux[kSnowLayers] * seconds;
  f.shortwaveIn = skin.shortwave * seconds;
  f.longwaveNet = skin.longwave * seconds;
  f.sensibleIn = skin.sensible * seconds;
  f.groundIn = (w.groundHeat - h.flux[kColumnLayers]) * seconds;

  const V lacking = takeVapour(c, skin.snowVapour * seconds, f);
  const V unspent = lit<V>(kSublimationHeat) * lacking;
  f.latentIn = skin.latent * seconds + unspent;
  const V left = meltAndDrain(c, h, skin.melt + rainHeat / seconds, seconds, p, f);

  for (int i = 0; i < kSoilLayers; ++i) {
    const V extra = i == 0 ? w.groundHeat * seconds + left + unspent : zero;
    const V gained = (h.gain(kSnowLayers + i) * seconds + extra) / g.thickness[i];
    const V enthalpy = soilEnthalpy(c.soil[i], g.heatCapacity, g.frozenWater);
    c.soil[i] = soilTemperature(enthalpy + gained, g.heatCapacity, g.frozenWater);
  }
  const V keep = boundedExp(-seconds / V(p.settlingSeconds));
  for (int i = 0; i < kSnowLayers; ++i) settleLayer(c.snow[i], p, keep);
  shareLayers(c, p);
  // Cold snow and wet snow that came together: small flows of heat, but no state with water below 0.
  for (int i = 0; i < kSnowLayers; ++i) settlePhases(c.snow[i], zero, f, c.rest);
  return f;
}

}  // namespace spin
