// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cover_weather.h"

#include "core/physics/clear_sky.h"
#include "core/sim/scene_time.h"
#include "core/sim/scene_weather.h"
#include "core/snow/station_weather.h"

namespace spin {
namespace {

FrameTime between(const FrameTime& a, const FrameTime& b, double share) {
  return {a.frame, a.film + (b.film - a.film) * share, a.weather + (b.weather - a.weather) * share};
}

/// The record that the weather's keyframes make, precipitation split as at their altitude.
WeatherRecord keyedRecord(const SceneSnapshot& scene, const WeatherNode& weather, const Sun& sun,
                          double film) {
  const AirNow now = airAt(scene, film);
  const double floor = scene.terrain ? scene.terrain->geo.origin.z : 0.0;
  WeatherRecord r;
  r.shortwave = skyShortwave(sun.direction.z, weather.cloudCover);
  r.longwave = skyLongwave(weather.airTemperature, weather.relativeHumidity, weather.cloudCover);
  r.snowfall = now.snowfall;
  r.rainfall = now.rainfall;
  r.airTemperature = now.temperature;
  r.relativeHumidity = now.relativeHumidity;
  r.wind = weather.windSpeed;
  r.pressure = standardPressure(floor + weatherLevel(scene));
  return r;
}

}  // namespace

TimeSpan TimeSpan::part(double a, double b) const {
  return {between(from, to, a), between(from, to, b)};
}

double weatherLevel(const SceneSnapshot& scene) {
  const auto weather = scene.settings<WeatherNode>(0.0);
  if (!weather.altitudeKnown) return 0.0;
  return weather.altitude - (scene.terrain ? scene.terrain->geo.origin.z : 0.0);
}

CoverWeather coverWeather(const SceneSnapshot& scene, const TimeSpan& span) {
  const auto weather = scene.settings<WeatherNode>(span.middleFilm());
  CoverWeather now;
  now.sun = meltingSun(scene, weather, span.middleWeather());
  WeatherRecord record;
  const std::optional<double> from = utcAt(scene, span.from.weather);
  if (scene.weather && from) {
    record = meanRecord(*scene.weather, *from, *from + span.seconds());
    const double factor = scene.settings<SnowfallNode>(span.middleFilm()).rateFactor;
    record.snowfall *= factor;
    record.rainfall *= factor;
  } else {
    record = keyedRecord(scene, weather, now.sun, span.middleFilm());
  }
  now.precipitation = record.snowfall + record.rainfall;
  now.step = stationWeather(record, span.seconds(), &now.sun);
  now.step.splitByTemperature = weather.phase == PrecipitationPhase::ByTemperature;
  return now;
}

}  // namespace spin
