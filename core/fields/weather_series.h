// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// Days from 1970-01-01 (proleptic Gregorian calendar).
std::int64_t daysFromCivil(int year, int month, int day);

/// What a weather station says over one step; SI.
struct WeatherRecord {
  double shortwave = 0.0;         ///< W/m2 on level ground
  double longwave = 0.0;          ///< W/m2
  double snowfall = 0.0;          ///< kg/(m2 s)
  double rainfall = 0.0;          ///< kg/(m2 s)
  double airTemperature = 0.0;    ///< K
  double relativeHumidity = 0.0;  ///< share, over water
  double wind = 0.0;              ///< m/s
  double pressure = 0.0;          ///< Pa
};
inline constexpr std::size_t kWeatherValues = 8;
/// Their names, in the order of the record.
extern const std::array<const char*, kWeatherValues> kWeatherValueNames;

/// Weather in even steps without gaps, and what had to be filled to make it so.
struct WeatherSeries {
  std::int64_t start = 0;                            ///< s from 1970-01-01 00:00, UTC as the file has it
  std::int64_t step = 3600;                          ///< s
  std::vector<WeatherRecord> records;                ///< each holds for the step that begins at its time
  std::array<std::size_t, kWeatherValues> filled{};  ///< values that the file did not have
  std::size_t missingRows = 0;
  std::int64_t longestGap = 0;  ///< s, the longest run of missing values of any kind

  /// One sentence on what was filled, empty if nothing was.
  std::string gapReport() const;
};

/// Mean of a record over [from, to), s from 1970. Before its begin and after its end the nearest value holds
/// and nothing falls.
WeatherRecord meanRecord(const WeatherSeries& weather, double from, double to);
/// Precipitation of the steps in which something fell, kg/(m2 s); 0 if nothing ever did.
double meanWetPrecipitation(const WeatherSeries& weather);

/// Reads rows of year, month, day, hour (UTC, the step's begin), incoming shortwave and longwave W/m2,
/// snowfall and rainfall kg/(m2 s), air temperature K, relative humidity %, wind m/s, pressure Pa; white
/// space or commas between them. Every number must be possible on Earth; times must ascend in steps of one
/// length or multiples of it. Gaps are filled: precipitation by none, shortwave by the nearest day's value at
/// that hour, all else by interpolation. `where` names the text in errors.
Result<WeatherSeries> readWeather(std::string_view text, const std::string& where);

/// What a snow station observed on one day; NaN where it did not.
struct SnowObservation {
  std::int64_t day = 0;                        ///< from 1970-01-01
  double albedo, runoff, depth, swe;           ///< -, kg/m2 a day, m, kg/m2
  double surfaceTemperature, soilTemperature;  ///< K
};

/// Reads rows of year, month, day, albedo, runoff at the base kg/(m2 day), depth m, water equivalent kg/m2,
/// surface temperature and soil temperature degC.
Result<std::vector<SnowObservation>> readObservations(std::string_view text, const std::string& where);

}  // namespace spin
