// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/physics/snow_column_state.h"

/// What happens within the snow of a column: fall, melt and refreezing, water on its way down, settling,
/// and the layers' sharing of it all.
namespace spin {

/// Thermal conductivity of snow by its density (Calonne et al. 2011), W/(m K).
template <class V>
SPIN_HD_INLINE V snowConductivity(V density) {
  return mulAdd(mulAdd(lit<V>(2.5e-6), density, lit<V>(-1.23e-4)), density, lit<V>(0.024));
}

/// Density of new snow by air temperature (Hedstrom and Pomeroy 1998), kg/m3; see newSnowDensity().
template <class V>
SPIN_HD_INLINE V newSnowDensityAt(V t, const SnowParameters& p) {
  if (p.newSnowDensity > 0.0f) return V(p.newSnowDensity);
  const V cold = minimum(t, lit<V>(0.0));
  return mulAdd(lit<V>(51.3), boundedExp(cold * lit<V>(1.0 / 2.59)), lit<V>(67.9));
}

/// Mass per depth, 0 for an empty layer.
template <class V>
SPIN_HD_INLINE V layerDensity(const SnowLayer<V>& layer) {
  const V zero = lit<V>(0.0);
  return selectLess(zero, layer.depth, (layer.ice + layer.liquid) / maximum(layer.depth, lit<V>(1e-12)),
                    zero);
}

/// Adds snow of a temperature and density to a layer; the layer's heat is that of both.
template <class V>
SPIN_HD_INLINE void addSnow(SnowLayer<V>& layer, V ice, V temperature, V density, V& rest) {
  const V before = layer.ice * layer.temperature;
  addMass(layer.ice, ice, rest);
  layer.temperature = (before + ice * temperature) / maximum(layer.ice, lit<V>(1e-12));
  layer.depth = layer.depth + ice / density;
}

/// Gives a layer `heat` (J/m2) and lets it melt or refreeze: what is left is ice at or below 0, or ice and
/// water at 0. Returns the heat that the layer cannot keep, because all of it has melted or none was there.
template <class V>
SPIN_HD_INLINE V settlePhases(SnowLayer<V>& layer, V heat, ColumnFluxes<V>& fluxes, V& rest) {
  const V zero = lit<V>(0.0), tiny = lit<V>(1e-12);
  const V mass = layer.ice + layer.liquid, iceBefore = layer.ice;
  const V enthalpy = layerEnthalpy(layer) + heat;
  const V liquid = clampBetween(enthalpy * lit<V>(1.0 / kFusionHeat), zero, mass);
  // All melted or all frozen: exactly what there is, so that rounding leaves nothing behind.
  const V melt = selectLess(liquid, mass, minimum(liquid - layer.liquid, layer.ice), layer.ice);
  const V change = selectLess(zero, liquid, maximum(melt, -layer.liquid), -layer.liquid);
  addMass(layer.liquid, change, rest);
  addMass(layer.ice, -change, rest);
  const V shrunk = layer.depth * minimum(layer.ice / maximum(iceBefore, tiny), lit<V>(1.0));
  layer.depth = maximum(shrunk, layer.ice * lit<V>(1.0 / kIceDensity));
  // A trace of ice cannot take what a sweep's rounding left: it hands that on.
  const V cold = clampBetween(enthalpy / maximum(lit<V>(kIceHeat) * layer.ice, tiny), lit<V>(-100.0), zero);
  layer.temperature = selectLess(zero, layer.ice, cold, zero);
  fluxes.melted = fluxes.melted + maximum(change, zero);
  fluxes.refrozen = fluxes.refrozen + maximum(-change, zero);
  return enthalpy - layerEnthalpy(layer);
}

/// Water beyond what the pores hold.
template <class V>
SPIN_HD_INLINE V excessWater(const SnowLayer<V>& layer, float heldWater) {
  const V zero = lit<V>(0.0);
  const V pores = maximum(layer.depth - layer.ice * lit<V>(1.0 / kIceDensity), zero);
  return maximum(layer.liquid - lit<V>(kWaterDensity) * V(heldWater) * pores, zero);
}

/// Moves a share of one layer to another.
template <class V>
SPIN_HD_INLINE void moveShare(SnowLayer<V>& from, SnowLayer<V>& to, V share, V& rest) {
  const V all = lit<V>(1.0), zero = lit<V>(0.0);
  const V ice = from.ice * share, liquid = from.liquid * share, depth = from.depth * share;
  const V heat = to.ice * to.temperature + ice * from.temperature;
  addMass(to.ice, ice, rest);
  addMass(to.liquid, liquid, rest);
  to.depth = to.depth + depth;
  to.temperature = selectLess(zero, to.ice, heat / maximum(to.ice, lit<V>(1e-12)), zero);
  addMass(from.ice, -ice, rest);
  addMass(from.liquid, -liquid, rest);
  from.depth = selectLess(share, all, from.depth - depth, zero);
  from.ice = selectLess(share, all, from.ice, zero);
  from.liquid = selectLess(share, all, from.liquid, zero);
  from.temperature = selectLess(share, all, from.temperature, zero);
}

/// Makes the upper layers as thick as the parameters say, as far as there is snow.
template <class V>
SPIN_HD_INLINE void shareLayers(SnowColumn<V>& column, const SnowParameters& p) {
  const V zero = lit<V>(0.0), one = lit<V>(1.0), tiny = lit<V>(1e-12);
  for (int i = 0; i + 1 < kSnowLayers; ++i) {
    SnowLayer<V>& upper = column.snow[i];
    SnowLayer<V>& lower = column.snow[i + 1];
    const V target = V(p.topLayers[i]);
    const V down = maximum(upper.depth - target, zero) / maximum(upper.depth, tiny);
    moveShare(upper, lower, down, column.rest);
    const V missing = maximum(target - upper.depth, zero);
    moveShare(lower, upper, minimum(missing / maximum(lower.depth, tiny), one), column.rest);
  }
}

/// Settles a layer towards the density of cold or wet snow; depth only, no mass. `keep` = exp(-step / time).
template <class V>
SPIN_HD_INLINE void settleLayer(SnowLayer<V>& layer, const SnowParameters& p, V keep) {
  const V zero = lit<V>(0.0);
  const V density = layerDensity(layer);
  const V most = selectLess(layer.temperature, lit<V>(-0.01), V(p.settledCold), V(p.settledWet));
  const V settled = maximum(density, most - (most - density) * keep);
  layer.depth = selectLess(zero, density, (layer.ice + layer.liquid) / maximum(settled, lit<V>(1.0)), zero);
}

/// Albedo of snow after a step of `seconds` with `snowfall` (kg/(m2 s)): it falls towards that of old snow,
/// and rises towards that of new snow with what falls.
template <class V>
SPIN_HD_INLINE V agedAlbedo(V albedo, V surface, V snowfall, const SnowParameters& p, V seconds) {
  const V time = selectLess(surface, lit<V>(-0.01), V(p.coldAlbedoSeconds), V(p.wetAlbedoSeconds));
  const V ageing = lit<V>(1.0) / time, refreshing = snowfall / V(p.refreshingSnow);
  const V rate = ageing + refreshing;
  const V limit = (ageing * V(p.oldAlbedo) + refreshing * V(p.freshAlbedo)) / rate;
  return limit + (albedo - limit) * boundedExp(-rate * seconds);
}

}  // namespace spin
