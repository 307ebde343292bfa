// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_flows.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr int kAcross = 32;

/// A backward Euler step over any time takes the mode to 1 / (1 + nu dt lambda) of itself, with the
/// lattice's own lambda = 2 (4/h^2) sin^2(pi m / (2 N)).
Result<BenchRow> measure(const BenchOptions& options, int waves, double share) {
  BenchRow row;
  row.caseId = "diffusion";
  row.settings = {{"waves", std::to_string(waves)}, {"nu dt/h2", fmt::format("{:g}", share)}};
  const BenchMeter meter;
  AirConfig config = stillBox({kAcross, kBrickY, kAcross}, 1.0 / kAcross);
  config.stages = {false, false, false, true, false};
  config.tolerance = 1e-6;
  config.mostIterations = 2000;
  config.viscosity = share * config.cell * config.cell;
  config.mostCourant = 100.0;
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  AirBox before({kAcross, kBrickY, kAcross});
  setDiffusionMode(before, waves);
  if (Status set = (*solver)->restore(before.state()); !set) return set.error();
  const Result<AirStep> step = (*solver)->step(1.0);
  if (!step) return step.error();
  const AirBox after((*solver)->state());
  const double sine = std::sin(0.5 * kPi * waves / kAcross);
  const double factor = 1.0 / (1.0 + share * 8.0 * sine * sine);
  double most = 0.0;
  after.forEach([&](int i, int j, int k) {
    for (const AirValue field : {AirValue::U, AirValue::V, AirValue::W})
      most = worse(most, std::abs(static_cast<double>(after.at(field, i, j, k)) -
                                  factor * static_cast<double>(before.at(field, i, j, k))));
  });
  row.addError("factor_error", most, "1", 1e-5);
  row.addFigure("factor", factor, "1");
  row.addFigure("sub_steps", step->subSteps, "1");
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int waves : {1, 3})
    for (const double share : {0.1, 10.0, 1000.0}) {
      Result<BenchRow> row = measure(options, waves, share);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  return rows;
}

}  // namespace

BenchCase diffusionCase() {
  return {"diffusion", "one mode of the velocity after one implicit step of any length",
          "1 / (1 + nu dt lambda)", run};
}

}  // namespace spin
