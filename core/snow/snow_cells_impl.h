// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop over snow cells, once per instruction set: SPIN_ISA names its namespace.
#include "core/math/simd_pack.h"
#include "core/physics/melt_column.h"
#include "core/snow/snow_cells_view.h"

namespace spin::SPIN_ISA {
namespace {

static_assert(kSnowCellPadding % kLanes == 0);

SPIN_HD_INLINE SnowColumn<Pack> loadColumn(const SnowCellsView& view, std::size_t i) {
  SnowColumn<Pack> c;
  std::size_t field = 0;
  const auto next = [&]() SPIN_INLINE_LAMBDA { return Pack::load(view.state[field++] + i); };
  for (SnowLayer<Pack>& layer : c.snow) {
    layer.ice = next();
    layer.liquid = next();
    layer.depth = next();
    layer.temperature = next();
  }
  for (Pack& soil : c.soil) soil = next();
  c.albedo = next();
  c.surface = next();
  c.rest = next();
  return c;
}

SPIN_HD_INLINE void storeColumn(const SnowColumn<Pack>& c, const SnowCellsView& view, std::size_t i) {
  std::size_t field = 0;
  const auto next = [&](Pack value) SPIN_INLINE_LAMBDA { value.store(view.state[field++] + i); };
  for (const SnowLayer<Pack>& layer : c.snow) {
    next(layer.ice);
    next(layer.liquid);
    next(layer.depth);
    next(layer.temperature);
  }
  for (const Pack& soil : c.soil) next(soil);
  next(c.albedo);
  next(c.surface);
  next(c.rest);
}

/// A number of each lane's material; `same` where all lanes have one.
SPIN_HD_INLINE Pack gather(const SnowCellsView& view, const std::uint8_t* material, bool same,
                           const float& (*of)(const GroundMaterial&)) {
  if (same) return Pack(of(view.materials[material[0]]));
  float values[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) values[lane] = of(view.materials[material[lane]]);
  return Pack::load(values);
}

SPIN_HD_INLINE GroundColumn<Pack> loadGround(const SnowCellsView& view, std::size_t i) {
  const std::uint8_t* material = view.material + i;
  bool same = true;
  for (int lane = 1; lane < kLanes; ++lane) same = same && material[lane] == material[0];
  using M = GroundMaterial;
  GroundColumn<Pack> g;
  g.conductivity = gather(view, material, same, [](const M& m) -> const float& { return m.conductivity; });
  g.heatCapacity = gather(view, material, same, [](const M& m) -> const float& { return m.heatCapacity; });
  g.frozenWater = gather(view, material, same, [](const M& m) -> const float& { return m.frozenWater; });
  g.albedo = gather(view, material, same, [](const M& m) -> const float& { return m.albedo; });
  g.roughness = gather(view, material, same, [](const M& m) -> const float& { return m.roughness; });
  g.evaporation = gather(view, material, same, [](const M& m) -> const float& { return m.evaporation; });
  g.deepConductance =
      gather(view, material, same, [](const M& m) -> const float& { return m.deepConductance; });
  g.thickness[0] = gather(view, material, same, [](const M& m) -> const float& { return m.thickness[0]; });
  g.thickness[1] = gather(view, material, same, [](const M& m) -> const float& { return m.thickness[1]; });
  g.thickness[2] = gather(view, material, same, [](const M& m) -> const float& { return m.thickness[2]; });
  g.thickness[3] = gather(view, material, same, [](const M& m) -> const float& { return m.thickness[3]; });
  g.deepTemperature = Pack::load(view.settings[kDeepTemperature] + i);
  return g;
}

/// The station's weather as the cell has it.
SPIN_HD_INLINE ColumnWeather<Pack> loadWeather(const SnowCellsView& view, std::size_t i) {
  const SnowStepWeather& s = view.weather;
  const Pack one(1.0f), sky = Pack::load(view.settings[kSkyView] + i), hidden = one - sky;
  ColumnWeather<Pack> w;
  w.airTemperature = Pack(s.airTemperature) + Pack::load(view.settings[kAirOffset] + i);
  w.wind = Pack(s.wind);
  w.pressure = Pack(s.pressure);
  const Pack relative(s.relativeHumidity);
  w.humidity = airHumidity(w.airTemperature, relative, w.pressure);
  const Pack direct(s.directShortwave), diffuse(s.diffuseShortwave);
  w.shortwave = direct * Pack::load(view.settings[kBeamFactor] + i) + diffuse * sky +
                (direct + diffuse) * Pack(s.surroundingAlbedo) * hidden;
  // The sky radiates as the air at the cell does; what hides it has the air's temperature.
  const Pack kelvin = w.airTemperature + Pack(static_cast<float>(kZeroCelsius));
  const Pack warmer = kelvin / Pack(s.airTemperature + static_cast<float>(kZeroCelsius));
  const Pack warmer2 = warmer * warmer, kelvin2 = kelvin * kelvin;
  w.longwave =
      Pack(s.longwave) * warmer2 * warmer2 * sky + lit<Pack>(kStefanBoltzmann) * kelvin2 * kelvin2 * hidden;
  Pack snow(s.snowfall), rain(s.rainfall);
  if (s.splitByTemperature) {
    const Pack all = snow + rain;
    snow = all * snowShare(w.airTemperature, relative);
    rain = all - snow;
  }
  const Pack factor = Pack::load(view.settings[kFallFactor] + i);
  w.snowfall = snow * factor;
  w.rainfall = rain * factor;
  w.groundHeat = Pack::load(view.settings[kGroundHeat] + i);
  return w;
}

/// Sums of one chunk by lane, with what roundings leave out.
struct LaneSums {
  Pack sums[SnowStepTotals::kTerms];
  Pack rests[SnowStepTotals::kTerms];

  LaneSums() {
    for (std::size_t t = 0; t < SnowStepTotals::kTerms; ++t) sums[t] = rests[t] = Pack(0.0f);
  }
  SPIN_HD_INLINE void add(std::size_t term, Pack value) { addMass(sums[term], value, rests[term]); }
  SPIN_HD_INLINE void add(const ColumnFluxes<Pack>& f, Pack area) {
    const Pack values[] = {f.snowIn,    f.rainIn,      f.runoff,      f.sublimated, f.melted,
                           f.refrozen,  f.shortwaveIn, f.longwaveNet, f.sensibleIn, f.latentIn,
                           f.carriedIn, f.groundIn,    f.baseFlux};
    std::size_t term = 0;
    for (const Pack& value : values) add(term++, value * area);
  }
  SnowStepTotals total() const {
    SnowStepTotals totals;
    for (std::size_t t = 0; t < SnowStepTotals::kTerms; ++t) {
      float lanes[2][kLanes];
      sums[t].store(lanes[0]);
      rests[t].store(lanes[1]);
      for (int lane = 0; lane < kLanes; ++lane)
        totals.sums[t] += static_cast<double>(lanes[0][lane]) + static_cast<double>(lanes[1][lane]);
    }
    return totals;
  }
};

/// Laws that tell a rate.
SPIN_HD_INLINE Pack meltRate(const SnowCellsView& view, const ColumnWeather<Pack>& w,
                             const GroundColumn<Pack>& g, Pack ice, Pack area, LaneSums& sums) {
  if (view.law == MeltLaw::DegreeDay) return degreeDayMelt(view.degreeDay, w.airTemperature);
  // The law knows no soil: where nobody tells, the ground's surface has the air's temperature.
  const PublishedMelt<Pack> melt =
      publishedMelt(view.published, g.conductivity, view.groundKnown ? g.deepTemperature : w.airTemperature);
  const Pack covered = selectLess(Pack(0.0f), ice, area, Pack(0.0f));
  sums.add(SnowStepTotals::kGuardedArea, melt.guarded * covered);
  sums.add(SnowStepTotals::kClampedGrowth, melt.negative * Pack(view.weather.seconds) * covered);
  return melt.rate;
}

SnowStepTotals advanceCells(const SnowCellsView& cells, std::size_t begin, std::size_t end) {
  const SnowCellsView view = cells;  // a copy that no store can reach
  const Pack seconds(view.weather.seconds);
  LaneSums sums;
  for (std::size_t i = begin; i < end; i += kLanes) {
    SnowColumn<Pack> column = loadColumn(view, i);
    const GroundColumn<Pack> ground = loadGround(view, i);
    const ColumnWeather<Pack> weather = loadWeather(view, i);
    const Pack area = Pack::load(view.settings[kCellArea] + i);
    ColumnFluxes<Pack> fluxes;
    if (view.law == MeltLaw::EnergyBalance) {
      fluxes = advanceSnowColumn(column, ground, weather, view.parameters, seconds);
    } else {
      const Pack rate = meltRate(view, weather, ground, column.ice(), area, sums);
      fluxes = advanceMeltColumn(column, weather, rate, view.parameters, seconds);
    }
    storeColumn(column, view, i);
    fluxes.runoff.store(view.runoff + i);
    sums.add(fluxes, area);
  }
  return sums.total();
}

}  // namespace

SnowCellsLoop snowCellsLoop() {
  return advanceCells;
}

}  // namespace spin::SPIN_ISA
