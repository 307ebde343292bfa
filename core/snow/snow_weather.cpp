// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_weather.h"

#include <algorithm>

#include "core/base/check.h"
#include "core/sim/scene_weather.h"

namespace spin {

const FlakeFallLaw& fallLaw(FlakeType type) {
  switch (type) {
    case FlakeType::RimedDendriteAggregate:
      return kRimedDendriteAggregate;
    case FlakeType::HexagonalGraupel:
      return kHexagonalGraupel;
    case FlakeType::UnrimedDendriteAggregate:
      break;
  }
  return kUnrimedDendriteAggregate;
}

SnowWeather snowWeatherAt(const SceneSnapshot& scene, double filmTime) {
  const auto weather = scene.settings<WeatherNode>(filmTime);
  const AirNow air = airAt(scene, filmTime);
  SnowWeather now;
  now.snowfall = scene.settings<SnowfallNode>(filmTime);
  now.wind = windVector(weather.windSpeed, weather.windFromDegrees);
  now.airTemperature = air.temperature;
  now.precipitation = air.snowfall;
  now.rainfall = air.rainfall;
  now.spectrum = makeSizeSpectrum(fallLaw(now.snowfall.type), now.precipitation);
  return now;
}

SizeSpectrum directingSpectrum(const SceneSnapshot& scene, const SnowWeather& weather) {
  const double rate =
      scene.weather ? meanWetPrecipitation(*scene.weather) : weather.precipitation + weather.rainfall;
  return makeSizeSpectrum(weather.spectrum.law, rate);
}

FallCone fallCone(Vec3d wind, double fallSpeed, double spreadRadians) {
  SPIN_CHECK(fallSpeed > 0.0, "the fall speed must be positive");
  constexpr double kStep = 0.002;
  const auto rounded = [&](double v) { return kStep * std::round(v / fallSpeed / kStep); };
  const Vec3d mean = normalized(Vec3d{rounded(wind.x), rounded(wind.y), -1.0});
  FallCone cone;
  cone.frame = frameAround(mean);
  cone.halfAngle = std::clamp(spreadRadians, 0.0, 0.75 * std::asin(-mean.z));
  const double half = std::sin(0.5 * cone.halfAngle);
  cone.oneMinusCos = 2.0 * half * half;
  return cone;
}

}  // namespace spin
