// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/bench/air_trials.h"
#include "core/bench/bench_meter.h"
#include "core/bench/lid_cavity_reference.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

struct CavityRun {
  int reynolds = 0;  ///< index of kCavityReynolds
  int across = 0;
  double seconds = 0.0;  ///< at most
  double bar = 0.0;
};

AirConfig cavity(const CavityRun& run, const AirTrial& trial) {
  const int n = run.across;
  AirConfig c = stillBox({n, kBrickY, n}, 1.0 / n);
  c.stickySides = {true, true, false, false, true, true};
  c.wallVelocity[5] = {1, 0, 0};
  c.viscosity = 1.0 / kCavityReynolds[run.reynolds];
  c.advection = trial.advection;
  c.reflection = trial.reflection;
  return c;
}

/// A velocity between cell centres and the walls beyond the outer ones, linearly; `at` as a share of the
/// side.
double between(const std::vector<double>& centres, double low, double high, double at) {
  const auto n = static_cast<double>(centres.size());
  const double place = at * n - 0.5;
  if (place <= 0.0) return low + (centres.front() - low) * (at * n / 0.5);
  if (place >= n - 1.0) return high + (centres.back() - high) * ((1.0 - at) * n / 0.5);
  const auto below = static_cast<std::size_t>(place);
  return centres[below] + (centres[below + 1] - centres[below]) * (place - std::floor(place));
}

/// Largest distance from the reference along both middles, where faces lie, in lid speeds.
double errorOf(const AirBox& box, int reynolds) {
  const int n = box.cells()[0];
  std::vector<double> u, v;
  for (int k = 0; k < n; ++k) {
    u.push_back(static_cast<double>(box.at(AirValue::U, n / 2, 1, k)));
    v.push_back(static_cast<double>(box.at(AirValue::W, k, 1, n / 2)));
  }
  double most = 0.0;
  for (const CavityPoint& p : kCavityU)
    most = worse(most, std::abs(between(u, 0.0, 1.0, p.at) - p.speed[reynolds]));
  for (const CavityPoint& p : kCavityV)
    most = worse(most, std::abs(between(v, 0.0, 0.0, p.at) - p.speed[reynolds]));
  return most;
}

double mostApart(const AirBox& a, const AirBox& b) {
  double most = 0.0;
  a.forEach([&](int i, int j, int k) {
    for (const AirValue field : {AirValue::U, AirValue::W})
      most = worse(most, std::abs(static_cast<double>(a.at(field, i, j, k)) -
                                  static_cast<double>(b.at(field, i, j, k))));
  });
  return most;
}

Result<BenchRow> measure(const BenchOptions& options, const CavityRun& run, const AirTrial& given) {
  AirTrial trial = given;
  trial.across = run.across;
  BenchRow row;
  row.caseId = "lid-cavity";
  describe(trial, row);
  row.settings["reynolds"] = std::to_string(kCavityReynolds[run.reynolds]);
  const BenchMeter meter;
  const AirConfig config = cavity(run, trial);
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  // Steady when nothing moves by more than a 2000th of the lid's speed in a second.
  double time = 0.0, change = 1.0;
  AirBox before((*solver)->state());
  while (time < run.seconds && change > 5e-4) {
    const int steps = static_cast<int>(std::lround(run.across / trial.courant));
    for (int s = 0; s < steps; ++s)
      if (const Result<AirStep> step = (*solver)->step(1.0 / steps); !step) return step.error();
    time += 1.0;
    AirBox now((*solver)->state());
    change = mostApart(now, before);
    before = std::move(now);
  }
  row.addError("profile_error", errorOf(before, run.reynolds), "1", run.bar);
  row.addFigure("last_change", change, "1/s");
  row.addFigure("time", time, "s");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / time, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<CavityRun> runs = {
      {0, 64, 20.0, 0.03}, {0, 128, 20.0, 0.015}, {1, 128, 40.0, 0.03}, {2, 128, 60.0, 0.03}};
  // Quick: not steady to the last digit.
  if (options.quick) runs = {{0, 32, 8.0, 0.03}};
  std::vector<BenchRow> rows;
  for (const CavityRun& r : runs) {
    Result<BenchRow> row = measure(options, r, {});
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase lidCavityCase() {
  return {"lid-cavity", "steady profiles under a sliding lid, Re 100, 400 and 1000",
          "Newton solution at the places of Ghia, Ghia and Shin 1982", run};
}

}  // namespace spin
