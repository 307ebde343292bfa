// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/season_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/snow/station_weather.h"

namespace spin {
namespace {

SnowCells cellOf(const SeasonFiles& season, const SeasonLaw& law) {
  SnowCells cells(1, {season.site.ground}, season.site.parameters);
  cells.law = law.law;
  cells.degreeDay.factor = static_cast<float>(law.degreeDayFactor / 86400.0);
  std::array<float, kSoilLayers> soil{};
  std::copy(season.site.soil.begin(), season.site.soil.end(), soil.begin());
  cells.setSoil(0, soil);
  return cells;
}

/// Adds a step to the mean of its day; `steps`: how many the last day has.
void addToDay(std::vector<SeasonDay>& days, std::int64_t day, const SnowColumn<float>& c, double& steps) {
  if (days.empty() || days.back().day != day) {
    days.push_back({day, 0.0, 0.0, 0.0});
    steps = 0.0;
  }
  steps += 1.0;
  SeasonDay& mean = days.back();
  const auto move = [&](double& to, double value) { to += (value - to) / steps; };
  move(mean.depth, static_cast<double>(c.depth()));
  move(mean.swe, columnMass(c));
  move(mean.surface, celsiusToKelvin(static_cast<double>(c.surface)));
}

constexpr double kGone = 0.02;  // m: depth below which the ground counts as free

}  // namespace

SeasonRun runSeason(const SeasonFiles& season, const SeasonLaw& law, const BenchOptions& options) {
  SeasonRun run;
  CpuBackend backend(1);
  const Result<Isa> isa = chooseIsa(options.isa);
  SnowCells cells = cellOf(season, law);
  const double massBefore = cells.mass(), energyBefore = cells.energy();
  double energy = energyBefore, steps = 0.0;
  const WeatherSeries& weather = season.weather;
  const int parts = static_cast<int>((weather.step + 3599) / 3600);
  const double seconds = static_cast<double>(weather.step) / parts;
  for (std::size_t i = 0; i < weather.records.size(); ++i) {
    const std::int64_t time = weather.start + static_cast<std::int64_t>(i) * weather.step;
    for (int part = 0; part < parts; ++part) {
      const SnowStepWeather w = stationWeather(weather.records[i], seconds);
      const SnowStepTotals step = cells.advance(w, backend, isa ? *isa : bestIsa());
      const double now = cells.energy();
      if (law.law == MeltLaw::EnergyBalance)
        run.worstResidual = std::max(run.worstResidual, std::abs(now - energy - step.energyIn()) / seconds);
      energy = now;
      run.totals += step;
      run.guardedHours += step[SnowStepTotals::kGuardedArea] * seconds / 3600.0;
      run.hours += seconds / 3600.0;
      const auto at = time + static_cast<std::int64_t>(part * seconds);
      addToDay(run.days, (at - (at % 86400 + 86400) % 86400) / 86400, cells.column(0), steps);
    }
  }
  const double fell = run.totals[SnowStepTotals::kSnowIn] + run.totals[SnowStepTotals::kRainIn];
  run.massResidual = std::abs(cells.mass() - massBefore - run.totals.massIn()) / std::max(fell, 1.0);
  run.energyResidual = std::abs(energy - energyBefore - run.totals.energyIn()) / (run.hours * 3600.0);
  return run;
}

SeasonScore scoreSeason(const SeasonRun& run, const std::vector<SnowObservation>& observations) {
  SeasonScore score;
  double sweSquares = 0.0, depthSquares = 0.0, deepest = -1.0;
  std::int64_t deepestDay = 0, observedOut = 0, modelledOut = 0;
  const auto dayOf = [&](std::int64_t day) {
    return std::lower_bound(run.days.begin(), run.days.end(), day,
                            [](const SeasonDay& d, std::int64_t at) { return d.day < at; });
  };
  for (const SnowObservation& o : observations) {
    const auto found = dayOf(o.day);
    if (found == run.days.end() || found->day != o.day) continue;
    if (!std::isnan(o.swe)) {
      ++score.sweDays;
      sweSquares += (found->swe - o.swe) * (found->swe - o.swe);
      score.sweBias += found->swe - o.swe;
    }
    if (!std::isnan(o.depth)) {
      ++score.depthDays;
      depthSquares += (found->depth - o.depth) * (found->depth - o.depth);
      score.depthBias += found->depth - o.depth;
      if (o.depth > deepest) deepest = o.depth, deepestDay = o.day;
    }
    if (o.depth > 0.1 && o.surfaceTemperature < kZeroCelsius - 0.5) {
      ++score.surfaceDays;
      score.surfaceBias += found->surface - o.surfaceTemperature;
    }
  }
  score.sweError = std::sqrt(sweSquares / score.sweDays);
  score.depthError = std::sqrt(depthSquares / score.depthDays);
  score.sweBias /= score.sweDays;
  score.depthBias /= score.depthDays;
  score.surfaceBias /= score.surfaceDays;
  for (const SeasonDay& day : run.days) score.peakSwe = std::max(score.peakSwe, day.swe);
  for (const SnowObservation& o : observations)
    if (!score.meltsOut && o.day > deepestDay && o.depth <= kGone) score.meltsOut = true, observedOut = o.day;
  const auto gone = std::find_if(run.days.begin(), run.days.end(),
                                 [&](const SeasonDay& d) { return d.day > deepestDay && d.depth <= kGone; });
  score.meltOutError = std::numeric_limits<double>::quiet_NaN();
  if (gone != run.days.end()) {
    modelledOut = gone->day;
    score.meltOutError = static_cast<double>(modelledOut - observedOut);
  }
  return score;
}

}  // namespace spin
