// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "core/base/log.h"
#include "core/bench/bench_meter.h"
#include "core/bench/curve_plot.h"
#include "core/bench/season_run.h"

namespace spin {
namespace {

struct LawChoice {
  const char* name;
  SeasonLaw law;
};
// 4 mm a day and degree is the middle of what is in use (Hock 2003 lists 2.5 to 5.5 for snow).
constexpr LawChoice kLaws[] = {{"energy balance", {MeltLaw::EnergyBalance, 0.0}},
                               {"degree-day, 4 mm/(d K)", {MeltLaw::DegreeDay, 4.0}},
                               {"degree-day, 2 mm/(d K)", {MeltLaw::DegreeDay, 2.0}},
                               {"published", {MeltLaw::Published, 0.0}}};

/// Bars hold for the season that peers were run on.
void addScore(BenchRow& row, const SeasonScore& score, bool bars) {
  const auto add = [&](const char* name, double value, const char* unit, double bar) {
    if (bars)
      row.addError(name, value, unit, bar);
    else
      row.addFigure(name, value, unit);
  };
  if (score.sweDays > 0) {
    add("swe_rmse", score.sweError, "kg/m2", 38.4);
    row.addFigure("swe_bias", score.sweBias, "kg/m2");
  }
  if (score.depthDays > 0) {
    add("depth_rmse", score.depthError, "m", 0.100);
    row.addFigure("depth_bias", score.depthBias, "m");
  }
  if (score.meltsOut) {
    row.addFigure("melt_out_days_late", score.meltOutError, "d");
    add("melt_out_error", std::abs(score.meltOutError), "d", 9.0);
  }
  row.addFigure("peak_swe", score.peakSwe, "kg/m2");
}

void addBalance(BenchRow& row, const SeasonRun& run) {
  using Totals = SnowStepTotals;
  row.addFigure("snowfall", run.totals[Totals::kSnowIn], "kg/m2");
  row.addFigure("rainfall", run.totals[Totals::kRainIn], "kg/m2");
  row.addFigure("run_off", run.totals[Totals::kRunoff], "kg/m2");
  row.addFigure("melted", run.totals[Totals::kMelted], "kg/m2");
  row.addError("mass_residual", run.massResidual, "1", 1e-6);
}

void addHeat(BenchRow& row, const SeasonRun& run, const SeasonScore& score) {
  using Totals = SnowStepTotals;
  row.addFigure("refrozen", run.totals[Totals::kRefrozen], "kg/m2");
  row.addFigure("sublimated", run.totals[Totals::kSublimated], "kg/m2");
  const double seconds = run.hours * 3600.0;
  row.addFigure("heat_shortwave", run.totals[Totals::kShortwaveIn] / seconds, "W/m2");
  row.addFigure("heat_longwave", run.totals[Totals::kLongwaveNet] / seconds, "W/m2");
  row.addFigure("heat_sensible", run.totals[Totals::kSensibleIn] / seconds, "W/m2");
  row.addFigure("heat_latent", run.totals[Totals::kLatentIn] / seconds, "W/m2");
  if (score.surfaceDays > 0) row.addFigure("surface_temperature_bias", score.surfaceBias, "K");
  row.addError("energy_residual", run.energyResidual, "W/m2", 0.1);
  row.addError("energy_residual_worst_step", run.worstResidual, "W/m2", 0.1);
}

std::vector<std::pair<double, double>> curveOf(const SeasonRun& run, double SeasonDay::*value) {
  std::vector<std::pair<double, double>> points;
  for (const SeasonDay& day : run.days)
    points.emplace_back(static_cast<double>(day.day - run.days.front().day), day.*value);
  return points;
}

/// The last season's curves: FILE gets the depth's curves, FILE with _swe before its ending those of the
/// water equivalent.
Status writeCurves(const std::string& file, const SeasonFiles& season, const std::vector<SeasonRun>& runs) {
  const std::int64_t first = runs.front().days.front().day;
  std::vector<PlotCurve> depth{{"observed", {}, true}}, swe{{"observed", {}, true}};
  for (const SnowObservation& o : season.observations) {
    if (o.day < first) continue;
    depth[0].points.emplace_back(static_cast<double>(o.day - first), o.depth);
    swe[0].points.emplace_back(static_cast<double>(o.day - first), o.swe);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    depth.push_back({kLaws[i].name, curveOf(runs[i], &SeasonDay::depth)});
    swe.push_back({kLaws[i].name, curveOf(runs[i], &SeasonDay::swe)});
  }
  const std::size_t dot = std::min(file.rfind('.'), file.size());
  std::ofstream one(file), two(file.substr(0, dot) + "_swe" + file.substr(dot));
  one << curvePlotSvg(depth, "days", "depth, m");
  two << curvePlotSvg(swe, "days", "water equivalent, kg/m2");
  if (one && two) return {};
  return Error{
      ErrorKind::OutOfResources, "The curves could not be written", file, "the file cannot be created", {}};
}

BenchRow rowOf(const SeasonFiles& season, const LawChoice& choice, const SeasonRun& done,
               const SeasonScore& score) {
  const bool balance = choice.law.law == MeltLaw::EnergyBalance;
  BenchRow row;
  row.caseId = "season";
  row.settings = {{"weather", season.name}, {"law", choice.name}};
  row.threads = 1;
  addScore(row, score, balance && season.name == "met_CdP_0506");
  addBalance(row, done);
  if (balance) addHeat(row, done, score);
  if (choice.law.law == MeltLaw::Published) {
    row.addFigure("guarded_hours", done.guardedHours, "h");
    row.addFigure("growth_set_to_zero", done.totals[SnowStepTotals::kClampedGrowth], "kg/m2");
  }
  return row;
}

Status addSeason(const SeasonFiles& season, const BenchOptions& options, std::vector<BenchRow>& rows) {
  if (const std::string gaps = season.weather.gapReport(); !gaps.empty())
    logWarning(fmt::format("{}: {}", season.name, gaps));
  std::vector<SeasonRun> runs;
  for (const LawChoice& choice : kLaws) {
    const BenchMeter meter;
    runs.push_back(runSeason(season, choice.law, options));
    const SeasonScore score = scoreSeason(runs.back(), season.observations);
    if (score.sweDays + score.depthDays == 0)
      return badInput("The season could not be scored", season.name,
                      "no day that was observed lies in the weather's time");
    rows.push_back(rowOf(season, choice, runs.back(), score));
    meter.finish(rows.back());
  }
  if (const auto curves = options.files.find("curves"); curves != options.files.end())
    return writeCurves(curves->second, season, runs);
  return {};
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const Result<std::vector<SeasonFiles>> seasons = loadSeasons(options);
  if (!seasons) return seasons.error();
  std::vector<BenchRow> rows;
  for (const SeasonFiles& season : *seasons)
    if (const Status done = addSeason(season, options, rows); !done) return done.error();
  if (!rows.empty()) return rows;
  BenchRow none;
  none.caseId = "season";
  none.skipped =
      "no weather, observations and site: --met, --obs and --site, or --data with a folder snowcover";
  return std::vector<BenchRow>{none};
}

}  // namespace

BenchCase seasonCase() {
  return {"season",
          "a winter's depth and water equivalent from hourly weather, by all melt laws",
          "daily observations; bars: FSM 1.0 on Col de Porte 2005-06",
          run,
          {"curves"}};
}

}  // namespace spin
