// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_weather.h"

#include <algorithm>

#include "core/base/check.h"

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
  SnowWeather now;
  now.snowfall = scene.settings<SnowfallNode>(filmTime);
  now.wind = windVector(weather.windSpeed, weather.windFromDegrees);
  now.airTemperature = weather.airTemperature;
  now.precipitation = scene.first<SnowfallNode>() ? weather.precipitationRate * now.snowfall.rateFactor : 0.0;
  now.spectrum = makeSizeSpectrum(fallLaw(now.snowfall.type), now.precipitation);
  return now;
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
