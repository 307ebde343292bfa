// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/bench/bench_case.h"
#include "core/fields/weather_series.h"
#include "core/physics/snow_parameters.h"

namespace spin {

/// A snow station: where it stands, how high its sensors are, what ground it has.
struct SnowSite {
  double latitude = 0.0, longitude = 0.0;  ///< rad
  double elevation = 0.0;                  ///< m
  SnowParameters parameters;               ///< the laws' defaults with the sensors' heights
  std::string groundName = "soil";
  GroundMaterial ground;
  /// K above 273.15 K, by the ground's layers; empty where the site does not tell.
  std::vector<float> soil;
};

/// Reads {"latitude_deg", "longitude_deg", "elevation_m", "temperature_height_m",
/// "temperature_height_above_snow", "wind_height_m", "wind_height_above_snow", "soil_temperature_K": [..],
/// "soil_layers_m": [..], "ground": a ground type's id, "soil_conductivity_W_mK", "soil_heat_capacity_J_m3K",
/// "soil_water_kg_m3", "ground_albedo", "ground_roughness_m"}. All may be left out; others are ignored. Soil
/// layers are 0.1, 0.2, 0.4, 0.8 m from the top where nothing is said.
Result<SnowSite> readSnowSite(const std::string& text, const std::string& where);

struct SeasonFiles {
  WeatherSeries weather;
  std::vector<SnowObservation> observations;
  SnowSite site;
  std::string name;
};

/// The season that --met, --obs and --site name, else all of DIR/snowcover: met_NAME.txt with obs_NAME.txt
/// and site_NAME.json. None where nothing is named or there.
Result<std::vector<SeasonFiles>> loadSeasons(const BenchOptions& options);

}  // namespace spin
