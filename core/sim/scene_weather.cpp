// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/scene_weather.h"

#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/physics/humidity.h"
#include "core/sim/scene_time.h"

namespace spin {

AirNow airAt(const SceneSnapshot& scene, double filmTime) {
  const auto weather = scene.settings<WeatherNode>(filmTime);
  AirNow now{weather.airTemperature, weather.relativeHumidity, weather.precipitationRate, 0.0};
  const double weatherTime = filmTime * scene.settings<SimulationNode>(0.0).timeScale;
  const std::optional<double> utc = scene.weather ? utcAt(scene, weatherTime) : std::nullopt;
  if (utc) {
    const WeatherRecord record = meanRecord(*scene.weather, *utc, *utc);
    now = {record.airTemperature, record.relativeHumidity, record.snowfall, record.rainfall};
  }
  if (weather.phase == PrecipitationPhase::ByTemperature) {
    const double all = now.snowfall + now.rainfall;
    now.snowfall = all * snowShare(kelvinToCelsius(now.temperature), now.relativeHumidity);
    now.rainfall = all - now.snowfall;
  }
  const double factor = scene.first<SnowfallNode>() ? scene.settings<SnowfallNode>(filmTime).rateFactor : 0.0;
  now.snowfall *= factor;
  now.rainfall *= factor;
  return now;
}

}  // namespace spin
