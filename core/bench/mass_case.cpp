// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/snow_run.h"

namespace spin {
namespace {

Result<BenchRow> measure(const BenchOptions& options, double wind, int rays, int frames) {
  BenchRow row;
  row.caseId = "mass";
  row.settings = {{"wind_m_s", fmt::format("{:g}", wind)}, {"rays", std::to_string(rays)}};
  const BenchMeter meter;
  SnowBenchScene build;
  build.cells = 96;
  build.houses = 1;
  build.weather.windSpeed = wind;
  build.simulation.exposureRays = rays;
  build.simulation.timeScale = 2880.0;
  build.snowfall.flakeCount = 1000;
  const SceneSnapshot scene = snowBenchSnapshot(build);
  SnowRun run(scene, options.makeRayScene, options.threads);
  double imbalance = 0.0, residual = 0.0;
  Status status = run.begin();
  for (int f = 0; f < frames && status; ++f) {
    status = run.step();
    if (!status) break;
    const MassBudget budget = run.frame().info.budget;
    imbalance = std::max(imbalance, std::abs(budget.relativeImbalance()));
    residual = std::max(residual, std::abs(budget.get("sampling_residual")) / budget.get("emitted"));
  }
  if (!status) return status.error();
  const Frame last = run.frame();
  row.addError("imbalance", imbalance, "1", 1e-6);
  row.addError("sampling_residual_share", residual, "1", 0.005);
  for (const BudgetTerm& term : last.info.budget.terms) row.addFigure(term.name, term.kilograms, "kg");
  for (const auto& [name, value] : last.info.figures)
    if (name.rfind("residual_", 0) == 0) row.addFigure(name, value, "1");
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const std::vector<int> rayCounts = options.quick ? std::vector<int>{64} : std::vector<int>{16, 64, 256};
  for (const int rays : rayCounts)
    for (const double wind : {0.0, 2.0, 10.0}) {
      auto row = measure(options, wind, rays, 6);
      if (!row) return row.error();
      rows.push_back(std::move(row.value()));
    }
  return rows;
}

}  // namespace

BenchCase massCase() {
  return {"mass", "closure of the mass budget over a valley with houses, a lake without data and wind",
          "emitted = deposited + shed + aloft + left + sampling residual", run};
}

}  // namespace spin
