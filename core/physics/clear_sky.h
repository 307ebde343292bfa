// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/physics/humidity.h"
#include "core/physics/snow_parameters.h"
#include "core/physics/sunlight.h"

/// What the sky sends down, from what is usually known of the weather.
namespace spin {

/// Shortwave on level ground by the sun's height and the clouds' share: Kasten and Czeplak 1980,
/// (910 sin h - 30)(1 - 0.75 N^3.4) W/m2 after ten years at Hamburg; 0 where the clear part would be
/// negative. On mountains a clear sky gives some 10 % more.
inline double skyShortwave(double sunSine, double cloudCover) {
  const double clear = std::max(910.0 * sunSine - 30.0, 0.0);
  return clear * (1.0 - 0.75 * std::pow(std::clamp(cloudCover, 0.0, 1.0), 3.4));
}

/// Longwave from the sky, W/m2: emissivity 1.24 (e/T)^(1/7) of a clear one (Brutsaert 1975; e in hPa), 1
/// where clouds are (Crawford and Duchon 1999).
inline double skyLongwave(double airTemperature, double relativeHumidity, double cloudCover) {
  const double celsius = kelvinToCelsius(airTemperature);
  // The specific humidity at 1 hPa is that of a vapour pressure counted in hPa.
  const double vapour = airHumidity(celsius, relativeHumidity, 100.0) / kVapourMassRatio;
  const double clear = std::min(1.24 * std::pow(std::max(vapour, 1e-4) / airTemperature, 1.0 / 7.0), 1.0);
  const double cloud = std::clamp(cloudCover, 0.0, 1.0);
  return (cloud + (1.0 - cloud) * clear) * kStefanBoltzmann * std::pow(airTemperature, 4);
}

/// Pressure of the International Standard Atmosphere, Pa, at m above sea level.
inline double standardPressure(double altitude) {
  return 101325.0 * std::pow(std::max(1.0 - 2.25577e-5 * altitude, 0.1), 5.25588);
}

}  // namespace spin
