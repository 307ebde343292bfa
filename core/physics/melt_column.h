// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/melt_laws.h"
#include "core/physics/snow_column.h"

namespace spin {

/// One step of a column whose melt a law tells, kg/(m2 s): what melts runs off at once, rain runs past, and
/// the ground has no part. The same fall, settling and layers as with the energy balance, so that depths
/// compare; mass only, all heat flows are 0.
template <class V>
SPIN_HD_INLINE ColumnFluxes<V> advanceMeltColumn(SnowColumn<V>& c, const ColumnWeather<V>& w, V meltRate,
                                                 const SnowParameters& p, V seconds) {
  const V zero = lit<V>(0.0), tiny = lit<V>(1e-12);
  ColumnFluxes<V> f;
  f.refrozen = f.sublimated = f.shortwaveIn = f.longwaveNet = f.sensibleIn = f.latentIn = zero;
  f.carriedIn = f.groundIn = f.baseFlux = zero;
  c.albedo = selectLess(zero, c.ice(), c.albedo, V(p.freshAlbedo));
  f.snowIn = w.snowfall * seconds;
  f.rainIn = w.rainfall * seconds;
  addSnow(c.snow[0], f.snowIn, minimum(w.airTemperature, zero), newSnowDensityAt(w.airTemperature, p),
          c.rest);
  V left = meltRate * seconds;
  f.melted = zero;
  for (int i = 0; i < kSnowLayers; ++i) {
    SnowLayer<V>& layer = c.snow[i];
    const V melt = minimum(left, layer.ice);
    layer.depth = layer.depth * (lit<V>(1.0) - melt / maximum(layer.ice, tiny));
    addMass(layer.ice, -melt, c.rest);
    addMass(f.melted, melt, c.rest);
    left = left - melt;
    layer.temperature = selectLess(zero, layer.ice, minimum(w.airTemperature, zero), zero);
  }
  f.runoff = f.rainIn;
  addMass(f.runoff, f.melted, c.rest);
  c.surface = selectLess(zero, c.ice(), minimum(w.airTemperature, zero), w.airTemperature);
  c.albedo = agedAlbedo(c.albedo, minimum(w.airTemperature, zero), w.snowfall, p, seconds);
  const V keep = boundedExp(-seconds / V(p.settlingSeconds));
  for (int i = 0; i < kSnowLayers; ++i) settleLayer(c.snow[i], p, keep);
  shareLayers(c, p);
  return f;
}

}  // namespace spin
