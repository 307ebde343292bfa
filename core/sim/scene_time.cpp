// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/scene_time.h"

#include <fmt/chrono.h>

#include <array>
#include <charconv>
#include <cmath>

#include "core/base/units.h"
#include "core/fields/weather_series.h"
#include "core/nodes/settings_nodes.h"

namespace spin {
namespace {

/// Digits of fixed width at the text's begin, which it loses; -1 where there are none.
int takeNumber(std::string_view& text, std::size_t digits) {
  int value = -1;
  if (text.size() < digits) return -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + digits, value);
  if (error != std::errc() || end != text.data() + digits || value < 0) return -1;
  text.remove_prefix(digits);
  return value;
}

bool takeOne(std::string_view& text, std::string_view of) {
  if (text.empty() || of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

struct ClockTime {
  int hour = 0, minute = 0, second = 0;
};

/// What follows a date; nothing if it is no time of day.
std::optional<ClockTime> clockTime(std::string_view rest) {
  ClockTime t;
  if (rest.empty()) return t;
  if (!takeOne(rest, " T")) return {};
  t.hour = takeNumber(rest, 2);
  if (!takeOne(rest, ":")) return {};
  t.minute = takeNumber(rest, 2);
  if (takeOne(rest, ":")) t.second = takeNumber(rest, 2);
  takeOne(rest, "Z");
  const bool good = rest.empty() && t.hour >= 0 && t.hour <= 23 && t.minute >= 0 && t.minute <= 59 &&
                    t.second >= 0 && t.second <= 59;
  return good ? std::optional(t) : std::nullopt;
}

Sun sunOfAngles(const WeatherNode& weather) {
  // The mean of the year: the angles tell no season.
  return {sunDirection(weather.sunAzimuthDegrees, weather.sunElevationDegrees), kSolarConstant};
}

}  // namespace

Result<std::int64_t> parseDateTime(std::string_view text) {
  const Error bad = badInput("The date could not be read", std::string(text), "it is no date and time",
                             "Write it as 2005-10-01 00:00 (UTC)");
  std::string_view rest = text;
  const int year = takeNumber(rest, 4);
  const bool first = takeOne(rest, "-");
  const int month = takeNumber(rest, 2);
  const bool second = takeOne(rest, "-");
  const int day = takeNumber(rest, 2);
  const std::optional<ClockTime> clock = clockTime(rest);
  if (!first || !second || !clock || year < 1800 || year > 2999 || month < 1 || month > 12) return bad;
  const std::int64_t days = daysFromCivil(year, month, 1);
  const int length = static_cast<int>(
      (month == 12 ? daysFromCivil(year + 1, 1, 1) : daysFromCivil(year, month + 1, 1)) - days);
  if (day < 1 || day > length) return bad;
  return (days + day - 1) * 86400 + clock->hour * 3600 + clock->minute * 60 + clock->second;
}

std::string dateTimeText(std::int64_t utc) {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::gmtime(static_cast<std::time_t>(utc)));
}

std::optional<double> utcAt(const SceneSnapshot& scene, double weatherSeconds) {
  const auto weather = scene.settings<WeatherNode>(0.0);
  if (!weather.start.empty()) {
    const Result<std::int64_t> start = parseDateTime(weather.start);
    return start ? std::optional(static_cast<double>(*start) + weatherSeconds) : std::nullopt;
  }
  if (!scene.weather) return {};
  return static_cast<double>(scene.weather->start) + weatherSeconds;
}

Sun meltingSun(const SceneSnapshot& scene, const WeatherNode& weather, double weatherSeconds) {
  if (weather.sun == MeltingSun::Pictured) return sunOfAngles(weather);
  const std::optional<double> utc =
      weather.sun == MeltingSun::ByDate ? utcAt(scene, weatherSeconds) : std::nullopt;
  if (!utc) return {};
  return sunAt(*utc, degreesToRadians(weather.latitudeDegrees), degreesToRadians(weather.longitudeDegrees));
}

Vec3d picturedSun(const SceneSnapshot& scene, double filmTime) {
  const auto weather = scene.settings<WeatherNode>(filmTime);
  const double weatherSeconds = filmTime * scene.settings<SimulationNode>(0.0).timeScale;
  const std::optional<double> utc = weather.lightByDate ? utcAt(scene, weatherSeconds) : std::nullopt;
  if (!utc) return sunDirection(weather.sunAzimuthDegrees, weather.sunElevationDegrees);
  return sunAt(*utc, degreesToRadians(weather.latitudeDegrees), degreesToRadians(weather.longitudeDegrees))
      .direction;
}

}  // namespace spin
