// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bench/season_files.h"
#include "core/snow/snow_cells.h"

namespace spin {

/// Mean over the steps of one day.
struct SeasonDay {
  std::int64_t day = 0;  ///< from 1970-01-01
  double depth = 0.0;    ///< m
  double swe = 0.0;      ///< kg/m2
  double surface = 0.0;  ///< K
};

/// A season at one place under one law.
struct SeasonRun {
  std::vector<SeasonDay> days;
  SnowStepTotals totals;  ///< per m2
  double hours = 0.0;
  double massResidual = 0.0;    ///< of what fell, as a share
  double energyResidual = 0.0;  ///< W/m2, mean over the season
  double worstResidual = 0.0;   ///< W/m2, of the worst step
  double guardedHours = 0.0;    ///< with snow, the published law at its pole
};

struct SeasonLaw {
  MeltLaw law = MeltLaw::EnergyBalance;
  double degreeDayFactor = 4.0;  ///< mm a day and K
};

SeasonRun runSeason(const SeasonFiles& season, const SeasonLaw& law, const BenchOptions& options);

/// The comparison with a station's days, snow-free ones included.
struct SeasonScore {
  int sweDays = 0, depthDays = 0, surfaceDays = 0;
  double sweError = 0.0, sweBias = 0.0;      ///< kg/m2, root of the mean square and mean
  double depthError = 0.0, depthBias = 0.0;  ///< m
  double surfaceBias = 0.0;                  ///< K, days with snow colder than -0.5 degC
  double peakSwe = 0.0;                      ///< kg/m2
  bool meltsOut = false;                     ///< observed to, after the greatest depth
  double meltOutError = 0.0;                 ///< days, positive when late; NaN if the run keeps its snow
};
SeasonScore scoreSeason(const SeasonRun& run, const std::vector<SnowObservation>& observations);

}  // namespace spin
