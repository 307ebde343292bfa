// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "core/physics/snow_layers.h"

/// Snow that leaves a column for another, or comes from one, along the ground.
namespace spin {

/// Change of a column's amounts, per m2.
struct MovedSnow {
  double depth;   ///< m
  double ice;     ///< kg
  double liquid;  ///< kg
  double heat;    ///< J, zero for ice at 273.15 K
};

/// Share of an amount that stays after a change of it; 1 where there was nothing.
inline double stays(double amount, double change) {
  return amount > 0.0 ? std::max(1.0 + change / amount, 0.0) : 1.0;
}

/// A net loss: every layer keeps the same share of its ice, its water and its depth, and temperatures move so
/// that the heat left is what it should be.
inline void takeFromColumn(SnowColumn<float>& column, const MovedSnow& change) {
  double ice = static_cast<double>(column.rest), liquid = 0.0, depth = 0.0, sensible = 0.0;
  for (const SnowLayer<float>& layer : column.snow) {
    ice += static_cast<double>(layer.ice);
    liquid += static_cast<double>(layer.liquid);
    depth += static_cast<double>(layer.depth);
    sensible += kIceHeat * static_cast<double>(layer.ice) * static_cast<double>(layer.temperature);
  }
  const double iceStays = stays(ice, change.ice), liquidStays = stays(liquid, change.liquid);
  const double depthStays = stays(depth, change.depth);
  const double wanted = sensible + change.heat - kFusionHeat * change.liquid;
  const double warmth =
      sensible * iceStays < 0.0 ? std::clamp(wanted / (sensible * iceStays), 0.0, 4.0) : 1.0;
  double left = 0.0;
  for (SnowLayer<float>& layer : column.snow) {
    layer.ice = static_cast<float>(static_cast<double>(layer.ice) * iceStays);
    layer.liquid = static_cast<float>(static_cast<double>(layer.liquid) * liquidStays);
    layer.depth = static_cast<float>(static_cast<double>(layer.depth) * depthStays);
    layer.temperature = static_cast<float>(static_cast<double>(layer.temperature) * warmth);
    if (!(layer.ice > 0.0f)) layer = {0.0f, 0.0f, 0.0f, 0.0f};
    left += static_cast<double>(layer.ice) + static_cast<double>(layer.liquid);
  }
  const double gainedWater = liquid > 0.0 ? 0.0 : std::max(change.liquid, 0.0);
  column.rest = static_cast<float>(std::max(ice + change.ice, 0.0) + std::max(liquid + change.liquid, 0.0) -
                                   left - gainedWater);
  if (!(gainedWater > 0.0)) return;
  SnowLayer<float>& top = column.snow[0];
  addMass(top.liquid, static_cast<float>(gainedWater), column.rest);
  ColumnFluxes<float> within{};
  settlePhases(top, 0.0f, within, column.rest);
}

/// A net gain: it lies on the top layer, and water and cold in it share their heat.
inline void layOnColumn(SnowColumn<float>& column, const MovedSnow& change) {
  SnowLayer<float>& top = column.snow[0];
  const double before = kIceHeat * static_cast<double>(top.ice) * static_cast<double>(top.temperature) +
                        kFusionHeat * static_cast<double>(top.liquid);
  addMass(top.ice, static_cast<float>(change.ice), column.rest);
  addMass(top.liquid, static_cast<float>(std::max(change.liquid, -static_cast<double>(top.liquid))),
          column.rest);
  top.depth =
      std::max(top.depth + static_cast<float>(change.depth), top.ice * static_cast<float>(1.0 / kIceDensity));
  top.temperature = 0.0f;
  ColumnFluxes<float> within{};
  const double now = kFusionHeat * static_cast<double>(top.liquid);
  settlePhases(top, static_cast<float>(before + change.heat - now), within, column.rest);
}

}  // namespace spin
