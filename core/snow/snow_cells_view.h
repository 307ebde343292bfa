// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/cpu_features.h"
#include "core/physics/melt_laws.h"
#include "core/physics/snow_parameters.h"

namespace spin {

/// Arrays of a cell's state, in the order that SnowColumn is read and written in: ice, liquid, depth and
/// temperature of each snow layer, temperature of each soil layer, albedo, surface, rest.
inline constexpr std::size_t kSnowStateFields = 4 * kSnowLayers + kSoilLayers + 3;
inline constexpr std::size_t kFirstSoilField = 4 * kSnowLayers;
inline constexpr std::size_t kAlbedoField = kFirstSoilField + kSoilLayers;

/// What makes a cell differ from the weather station, by cell.
enum SnowCellSetting : std::size_t {
  kBeamFactor,       ///< direct light on the surface over that on level ground; 0 in shadow
  kSkyView,          ///< share of the sky's hemisphere that the cell sees
  kAirOffset,        ///< K on the air temperature
  kFallFactor,       ///< on snowfall and rainfall
  kGroundHeat,       ///< W/m2 into the soil
  kDeepTemperature,  ///< K above 273.15 K, with materials that have a deepConductance; where the ground's
                     ///< temperature is known, that of the published law too
  kCellArea,         ///< m2, weight in sums; 0 for cells that are none
  kSnowCellSettings
};

/// One step of weather at the station.
struct SnowStepWeather {
  float seconds = 3600.0f;          ///< an hour or less
  float directShortwave = 0.0f;     ///< W/m2 on level ground
  float diffuseShortwave = 0.0f;    ///< W/m2
  float longwave = 300.0f;          ///< W/m2
  float snowfall = 0.0f;            ///< kg/(m2 s)
  float rainfall = 0.0f;            ///< kg/(m2 s)
  float airTemperature = 0.0f;      ///< K above 273.15 K
  float relativeHumidity = 0.8f;    ///< over water, share
  float wind = 1.0f;                ///< m/s
  float pressure = 101325.0f;       ///< Pa
  float surroundingAlbedo = 0.5f;   ///< of the terrain that hides part of the sky
  bool splitByTemperature = false;  ///< every cell splits snowfall + rainfall by its own air
};

/// Sums over cells of one step, by cell area: kg and J, signs as in ColumnFluxes.
struct SnowStepTotals {
  enum Term : std::size_t {
    kSnowIn,
    kRainIn,
    kRunoff,
    kSublimated,
    kMelted,
    kRefrozen,
    kShortwaveIn,
    kLongwaveNet,
    kSensibleIn,
    kLatentIn,
    kCarriedIn,
    kGroundIn,
    kBaseFlux,
    kGuardedArea,    ///< m2 where the published law's pole was guarded
    kClampedGrowth,  ///< kg that the published law would have let the snow grow by
    kTerms
  };
  std::array<double, kTerms> sums{};

  double operator[](Term term) const { return sums[term]; }
  /// kg that came in less what left.
  double massIn() const { return sums[kSnowIn] + sums[kRainIn] - sums[kRunoff] - sums[kSublimated]; }
  /// J that came in less what left.
  double energyIn() const {
    return sums[kShortwaveIn] + sums[kLongwaveNet] + sums[kSensibleIn] + sums[kLatentIn] + sums[kCarriedIn] +
           sums[kGroundIn];
  }
  SnowStepTotals& operator+=(const SnowStepTotals& other) {
    for (std::size_t i = 0; i < kTerms; ++i) sums[i] += other.sums[i];
    return *this;
  }
};

/// What a loop over cells reads and writes; arrays are padded to whole packs.
struct SnowCellsView {
  std::array<float*, kSnowStateFields> state{};
  std::array<const float*, kSnowCellSettings> settings{};
  const std::uint8_t* material = nullptr;     ///< by cell
  const GroundMaterial* materials = nullptr;  ///< by number
  float* runoff = nullptr;                    ///< kg/m2 of the step, by cell
  SnowParameters parameters;
  SnowStepWeather weather;
  MeltLaw law = MeltLaw::EnergyBalance;
  DegreeDayLaw degreeDay;
  PublishedMeltLaw published;
  bool groundKnown = false;
};

/// Advances the cells [begin, end), both multiples of kSnowCellPadding, and sums what crossed their borders.
using SnowCellsLoop = SnowStepTotals (*)(const SnowCellsView& view, std::size_t begin, std::size_t end);
inline constexpr std::size_t kSnowCellPadding = 16;

/// The loop built for a set; the caller has asked cpuRuns().
SnowCellsLoop snowCellsLoopFor(Isa isa);

}  // namespace spin
