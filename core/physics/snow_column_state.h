// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/bounded_math.h"
#include "core/physics/snow_parameters.h"

/// Snow and soil of one cell; V is a number or a pack of cells. Temperatures are in K above 273.15 K, which
/// keeps the digits that melting needs.
namespace spin {

template <class V>
struct SnowLayer {
  V ice;          ///< kg/m2
  V liquid;       ///< kg/m2
  V depth;        ///< m
  V temperature;  ///< never above 0
};

template <class V>
struct SnowColumn {
  SnowLayer<V> snow[kSnowLayers];  ///< from the top; upper ones fill first, empty ones are all zero
  V soil[kSoilLayers];             ///< temperature, from the top
  V albedo;                        ///< of the snow
  V surface;                       ///< temperature of the skin
  V rest;                          ///< kg/m2 of the mass that roundings have left out

  SPIN_HD_INLINE V ice() const { return snow[0].ice + snow[1].ice + snow[2].ice; }
  SPIN_HD_INLINE V depth() const { return snow[0].depth + snow[1].depth + snow[2].depth; }
};

/// Ground of one cell.
template <class V>
struct GroundColumn {
  V conductivity, heatCapacity, frozenWater, albedo, roughness, evaporation, deepConductance;
  V deepTemperature;  ///< K above 273.15 K
  V thickness[kSoilLayers];
};

/// What the sky does to a cell over one step.
template <class V>
struct ColumnWeather {
  V shortwave;       ///< W/m2 that arrives on the surface, before albedo
  V longwave;        ///< W/m2 that arrives
  V snowfall;        ///< kg/(m2 s)
  V rainfall;        ///< kg/(m2 s)
  V airTemperature;  ///< K above 273.15 K
  V humidity;        ///< kg/kg
  V wind;            ///< m/s
  V pressure;        ///< Pa
  V groundHeat;      ///< W/m2 put into the uppermost soil: a heated roof, a hot spring
};

/// What crossed the column's boundaries in one step: amounts per m2, kg and J, positive as named.
template <class V>
struct ColumnFluxes {
  V snowIn, rainIn;    ///< kg
  V runoff;            ///< kg, out of the snow's base, rain on bare ground included
  V sublimated;        ///< kg, out; frost is negative
  V melted, refrozen;  ///< kg, within
  V shortwaveIn;       ///< J absorbed
  V longwaveNet;       ///< J in
  V sensibleIn;        ///< J
  V latentIn;          ///< J
  V carriedIn;         ///< J, heat of what falls, less that of what runs off and sublimates
  V groundIn;          ///< J from below the last soil layer, and from sources
  V baseFlux;          ///< J from soil to snow, within
};

/// x += m, the rounding error of the sum into rest.
template <class V>
SPIN_HD_INLINE void addMass(V& x, V m, V& rest) {
  const V sum = x + m;
  const V part = sum - x;
  rest = rest + ((x - (sum - part)) + (m - part));
  x = sum;
}

/// Enthalpy of a soil layer, J/m3: zero at 0 with all water liquid.
template <class V>
SPIN_HD_INLINE V soilEnthalpy(V t, V heatCapacity, V frozenWater) {
  const V zero = lit<V>(0.0);
  const V frozen = clampBetween(-t, zero, lit<V>(kFreezingRange));
  return heatCapacity * t - frozenWater * lit<V>(kFusionHeat / kFreezingRange) * frozen;
}

/// Its inverse.
template <class V>
SPIN_HD_INLINE V soilTemperature(V enthalpy, V heatCapacity, V frozenWater) {
  const V zero = lit<V>(0.0), range = lit<V>(kFreezingRange);
  const V latent = frozenWater * lit<V>(kFusionHeat);
  const V warm = enthalpy / heatCapacity;
  const V freezing = enthalpy / (heatCapacity + latent / range);
  const V cold = (enthalpy + latent) / heatCapacity;
  return selectLess(zero, enthalpy, warm, selectLess(freezing, -range, cold, freezing));
}

/// Enthalpy of the snow, J/m2: zero for ice at 0.
template <class V>
SPIN_HD_INLINE V layerEnthalpy(const SnowLayer<V>& layer) {
  return lit<V>(kIceHeat) * layer.ice * layer.temperature + lit<V>(kFusionHeat) * layer.liquid;
}

}  // namespace spin
