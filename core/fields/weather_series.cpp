// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/weather_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/units.h"
#include "core/fields/number_table.h"

namespace spin {

const std::array<const char*, kWeatherValues> kWeatherValueNames = {
    "shortwave",       "longwave",          "snowfall", "rainfall",
    "air temperature", "relative humidity", "wind",     "pressure"};

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kDateColumns = 4;  // year, month, day, hour
constexpr std::int64_t kDay = 86400;

using Values = std::array<double, kWeatherValues>;

/// What is possible, in the file's units.
struct Limits {
  double least, most;
  const char* unit;
};
// The factor 1.2 over the solar constant is what bright clouds round a clear sun can reach.
constexpr std::array<Limits, kWeatherValues> kLimits = {{{-20.0, 1650.0, "W/m2"},
                                                         {20.0, 700.0, "W/m2"},
                                                         {0.0, 0.5, "kg/(m2 s)"},
                                                         {0.0, 0.5, "kg/(m2 s)"},
                                                         {170.0, 340.0, "K"},
                                                         {0.0, 120.0, "%"},
                                                         {0.0, 120.0, "m/s"},
                                                         {25e3, 115e3, "Pa"}}};

Error bad(const std::string& where, std::string why) {
  return badInput(
      "The weather could not be used", where, std::move(why),
      "Rows are year, month, day, hour, shortwave, longwave, snowfall, rainfall, air temperature in K, "
      "humidity in %, wind, pressure in Pa");
}

bool isWhole(double x, double least, double most) {
  return x >= least && x <= most && x == std::floor(x);
}

int daysOf(int year, int month) {
  constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return kDays[month - 1] + (month == 2 && leap ? 1 : 0);
}

/// Days of the first three columns of a row.
Result<std::int64_t> dayOf(const NumberTable& table, std::size_t row, const std::string& where) {
  const double y = table.at(row, 0), m = table.at(row, 1), d = table.at(row, 2);
  const bool date = isWhole(y, 1800.0, 3000.0) && isWhole(m, 1.0, 12.0) && isWhole(d, 1.0, 31.0);
  if (!date || d > daysOf(static_cast<int>(y), static_cast<int>(m)))
    return bad(where, fmt::format("line {} begins with no date", table.lines[row]));
  return daysFromCivil(static_cast<int>(y), static_cast<int>(m), static_cast<int>(d));
}

Result<std::vector<std::int64_t>> rowTimes(const NumberTable& table, const std::string& where) {
  std::vector<std::int64_t> times;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Result<std::int64_t> day = dayOf(table, row, where);
    if (!day) return day.error();
    const double hour = table.at(row, 3);
    // Some files call midnight the 24th hour of the day before.
    if (!(hour >= 0.0 && hour <= 24.0))
      return bad(where, fmt::format("line {} has no hour from 0 to 24", table.lines[row]));
    times.push_back(*day * kDay + std::llround(hour * 3600.0));
    if (row > 0 && times[row] <= times[row - 1])
      return bad(where, fmt::format("line {} is not later than the row before", table.lines[row]));
  }
  return times;
}

/// The step that the times are whole multiples of.
Result<std::int64_t> stepOf(const std::vector<std::int64_t>& times, const NumberTable& table,
                            const std::string& where) {
  constexpr std::int64_t kMostSteps = 10'000'000;
  if (times.size() < 2) return bad(where, "one row tells no step of time");
  std::int64_t step = times[1] - times[0];
  for (std::size_t i = 2; i < times.size(); ++i) step = std::min(step, times[i] - times[i - 1]);
  if (step < 60 || step > kDay)
    return bad(where, fmt::format("rows are {} s apart, not a minute to a day", step));
  for (std::size_t i = 1; i < times.size(); ++i)
    if ((times[i] - times[i - 1]) % step != 0)
      return bad(where, fmt::format("line {} is not a whole number of steps of {} s after the row before",
                                    table.lines[i], step));
  if ((times.back() - times.front()) / step >= kMostSteps)
    return bad(where, "it spans more than 10,000,000 steps");
  return step;
}

/// Values of a row in the file's units; NaN where missing.
Result<Values> rowValues(const NumberTable& table, std::size_t row, const std::string& where) {
  Values values;
  for (std::size_t v = 0; v < kWeatherValues; ++v) {
    values[v] = table.at(row, kDateColumns + v);
    const Limits& limits = kLimits[v];
    if (values[v] < limits.least || values[v] > limits.most)
      return bad(where,
                 fmt::format("line {}: {} of {} {} is not within {} to {}", table.lines[row],
                             kWeatherValueNames[v], values[v], limits.unit, limits.least, limits.most));
  }
  return values;
}

/// Linear between the neighbours that are known, held at the ends.
void interpolate(std::vector<Values>& rows, std::size_t v) {
  std::size_t known = rows.size();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::isnan(rows[i][v])) continue;
    const std::size_t from = known == rows.size() ? 0 : known + 1;
    const double before = known == rows.size() ? rows[i][v] : rows[known][v];
    const double span = known == rows.size() ? 1.0 : static_cast<double>(i - known);
    for (std::size_t k = from; k < i; ++k) {
      const double share = known == rows.size() ? 1.0 : static_cast<double>(k - known) / span;
      rows[k][v] = before + (rows[i][v] - before) * share;
    }
    known = i;
  }
  for (std::size_t k = known + 1; k < rows.size(); ++k) rows[k][v] = rows[known][v];
}

/// The value at the same time of the nearest day within a month that has one, the earlier first; what no day
/// has is left.
void fillFromDays(std::vector<Values>& rows, std::size_t v, std::size_t perDay) {
  constexpr std::size_t kMostDays = 31;
  const std::vector<Values> given = rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t away = perDay; std::isnan(rows[i][v]) && away <= kMostDays * perDay; away += perDay) {
      if (away <= i && !std::isnan(given[i - away][v])) rows[i][v] = given[i - away][v];
      if (std::isnan(rows[i][v]) && i + away < rows.size()) rows[i][v] = given[i + away][v];
    }
  }
}

WeatherRecord recordOf(const Values& v) {
  return {std::max(v[0], 0.0), v[1], v[2], v[3], v[4], v[5] / 100.0, v[6], v[7]};
}

Status fillGaps(std::vector<Values>& rows, WeatherSeries& series, const std::string& where) {
  for (std::size_t v = 0; v < kWeatherValues; ++v) {
    std::int64_t run = 0;
    for (const Values& row : rows) {
      run = std::isnan(row[v]) ? run + 1 : 0;
      series.filled[v] += run > 0 ? 1u : 0u;
      series.longestGap = std::max(series.longestGap, run * series.step);
    }
    if (series.filled[v] == rows.size())
      return bad(where, fmt::format("no row has the {}", kWeatherValueNames[v]));
    if (series.filled[v] == 0) continue;
    if (v == 2 || v == 3) {
      for (Values& row : rows)
        if (std::isnan(row[v])) row[v] = 0.0;
      continue;
    }
    if (v == 0 && kDay % series.step == 0)
      fillFromDays(rows, v, static_cast<std::size_t>(kDay / series.step));
    interpolate(rows, v);
  }
  return {};
}

}  // namespace

std::int64_t daysFromCivil(int year, int month, int day) {
  // Years from March, in eras of 400 years (Hinnant's algorithm).
  const std::int64_t y = month <= 2 ? year - 1 : year;
  const std::int64_t era = (y >= 0 ? y : y - 399) / 400;
  const std::int64_t yearOfEra = y - era * 400;
  const std::int64_t dayOfYear = (153 * (month > 2 ? month - 3 : month + 9) + 2) / 5 + day - 1;
  return era * 146097 + yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear - 719468;
}

std::string WeatherSeries::gapReport() const {
  std::string names;
  for (std::size_t v = 0; v < kWeatherValues; ++v)
    if (filled[v] > 0)
      names += fmt::format("{}{} {}", names.empty() ? "" : ", ", filled[v], kWeatherValueNames[v]);
  if (names.empty()) return {};
  return fmt::format("of {} steps {} rows are missing; filled: {}; the longest gap is {:.1f} h",
                     records.size(), missingRows, names, static_cast<double>(longestGap) / 3600.0);
}

WeatherRecord meanRecord(const WeatherSeries& weather, double from, double to) {
  const auto count = static_cast<double>(weather.records.size()), step = static_cast<double>(weather.step);
  const double begin = (from - static_cast<double>(weather.start)) / step;
  const double end = (to - static_cast<double>(weather.start)) / step;
  WeatherRecord mean;
  const auto add = [&](const WeatherRecord& r, double share, bool falls) {
    mean.shortwave += share * r.shortwave;
    mean.longwave += share * r.longwave;
    mean.snowfall += falls ? share * r.snowfall : 0.0;
    mean.rainfall += falls ? share * r.rainfall : 0.0;
    mean.airTemperature += share * r.airTemperature;
    mean.relativeHumidity += share * r.relativeHumidity;
    mean.wind += share * r.wind;
    mean.pressure += share * r.pressure;
  };
  const double length = end - begin;
  if (!(length > 0.0)) {
    const bool inside = begin >= 0.0 && begin < count;
    add(weather.records[static_cast<std::size_t>(std::clamp(begin, 0.0, count - 1.0))], 1.0, inside);
    return mean;
  }
  const double before = std::min(end, 0.0) - begin, after = end - std::max(begin, count);
  if (before > 0.0) add(weather.records.front(), before / length, false);
  if (after > 0.0) add(weather.records.back(), after / length, false);
  const double last = std::min(end, count);
  for (double at = std::max(begin, 0.0); at < last;) {
    const double next = std::min(std::floor(at) + 1.0, last);
    add(weather.records[static_cast<std::size_t>(at)], (next - at) / length, true);
    at = next;
  }
  return mean;
}

double meanWetPrecipitation(const WeatherSeries& weather) {
  double sum = 0.0, steps = 0.0;
  for (const WeatherRecord& r : weather.records) {
    sum += r.snowfall + r.rainfall;
    steps += r.snowfall + r.rainfall > 0.0 ? 1.0 : 0.0;
  }
  return steps > 0.0 ? sum / steps : 0.0;
}

Result<WeatherSeries> readWeather(std::string_view text, const std::string& where) {
  const Result<NumberTable> table = readNumberTable(text, kDateColumns + kWeatherValues, where);
  if (!table) return table.error();
  const Result<std::vector<std::int64_t>> times = rowTimes(*table, where);
  if (!times) return times.error();
  const Result<std::int64_t> step = stepOf(*times, *table, where);
  if (!step) return step.error();
  WeatherSeries series;
  series.start = times->front();
  series.step = *step;
  Values none;
  none.fill(kMissing);
  std::vector<Values> rows(static_cast<std::size_t>((times->back() - series.start) / series.step) + 1, none);
  series.missingRows = rows.size() - table->rows();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const Result<Values> values = rowValues(*table, row, where);
    if (!values) return values.error();
    rows[static_cast<std::size_t>(((*times)[row] - series.start) / series.step)] = *values;
  }
  if (const Status filled = fillGaps(rows, series, where); !filled) return filled.error();
  for (const Values& row : rows) series.records.push_back(recordOf(row));
  return series;
}

Result<std::vector<SnowObservation>> readObservations(std::string_view text, const std::string& where) {
  constexpr std::array<Limits, 6> kPossible = {{{0.0, 1.2, "albedo"},
                                                {-50.0, 2000.0, "kg/m2 of runoff"},
                                                {-0.2, 30.0, "m of snow"},
                                                {-20.0, 15000.0, "kg/m2 of snow"},
                                                {-98.0, 80.0, "degC at the surface"},
                                                {-98.0, 80.0, "degC in the soil"}}};
  const Result<NumberTable> table = readNumberTable(text, 3 + kPossible.size(), where);
  if (!table) return table.error();
  std::vector<SnowObservation> days;
  for (std::size_t row = 0; row < table->rows(); ++row) {
    const Result<std::int64_t> day = dayOf(*table, row, where);
    if (!day) return day.error();
    if (!days.empty() && *day <= days.back().day)
      return bad(where, fmt::format("line {} is not later than the row before", table->lines[row]));
    std::array<double, 6> v{};
    for (std::size_t c = 0; c < v.size(); ++c) {
      v[c] = table->at(row, 3 + c);
      if (v[c] < kPossible[c].least || v[c] > kPossible[c].most)
        return bad(where,
                   fmt::format("line {}: {} {} cannot be", table->lines[row], v[c], kPossible[c].unit));
    }
    days.push_back({*day, v[0], v[1], v[2], v[3], v[4] + kZeroCelsius, v[5] + kZeroCelsius});
  }
  return days;
}

}  // namespace spin
