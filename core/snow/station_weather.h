// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/units.h"
#include "core/fields/weather_series.h"
#include "core/physics/sunlight.h"
#include "core/snow/snow_cells_view.h"

namespace spin {

/// A station's record as cells take it. Without a sun all shortwave is diffuse, which is right on level
/// ground under an open sky; with one (the middle of the step) it is split for slopes and shadow.
inline SnowStepWeather stationWeather(const WeatherRecord& record, double seconds, const Sun* sun = nullptr) {
  SnowStepWeather w;
  w.seconds = static_cast<float>(seconds);
  const Shortwave light = sun ? splitShortwave(record.shortwave, sun->direction.z, sun->extraterrestrial)
                              : Shortwave{0.0, record.shortwave};
  w.directShortwave = static_cast<float>(light.direct);
  w.diffuseShortwave = static_cast<float>(light.diffuse);
  w.longwave = static_cast<float>(record.longwave);
  w.snowfall = static_cast<float>(record.snowfall);
  w.rainfall = static_cast<float>(record.rainfall);
  w.airTemperature = static_cast<float>(kelvinToCelsius(record.airTemperature));
  w.relativeHumidity = static_cast<float>(record.relativeHumidity);
  w.wind = static_cast<float>(record.wind);
  w.pressure = static_cast<float>(record.pressure);
  return w;
}

}  // namespace spin
