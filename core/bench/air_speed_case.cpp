// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/base/units.h"
#include "core/bench/air_bench_scene.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

struct SpeedRun {
  int across;
  bool reflection;
  double most;  ///< s a step, the bar
  int steps;
};

/// A warm, misty ball rises over hills in a box of 1 m with an open top; all cells are computed.
AirConfig smoke(const SpeedRun& run) {
  const int n = run.across;
  AirConfig c = stillBox({n, n, n}, 1.0 / n);
  c.closed[5] = false;
  c.gravity = {0, 0, -kStandardGravity};
  c.evaporates = true;
  c.reflection = run.reflection;
  c.tolerance = 1e-3;
  c.solids = {hills(1.0)};
  return c;
}

Result<BenchRow> measure(const BenchOptions& options, const SpeedRun& run) {
  BenchRow row;
  row.caseId = "air-speed";
  row.settings = {{"cells", fmt::format("{}^3", run.across)}, {"reflection", run.reflection ? "yes" : "no"}};
  const BenchMeter meter;
  const AirConfig config = smoke(run);
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  const int n = run.across;
  AirBox box({n, n, n});
  box.forEach([&](int i, int j, int k) {
    const Vec3d p{(i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5, (k + 0.5) / n - 0.45};
    if (length(p) > 0.15) return;
    box.at(AirValue::Mist, i, j, k) = 0.01f;
    box.at(AirValue::Warmth, i, j, k) = 20.0f;
  });
  if (Status set = (*solver)->restore(box.state()); !set) return set.error();
  // Until air moves with about 0.3 m/s. Then steps in which it goes about a cell.
  for (int s = 0; s < 16; ++s)
    if (const Result<AirStep> step = (*solver)->step(0.05); !step) return step.error();
  (*solver)->timings().clear();
  const BenchMeter clock;
  double residual = 0.0, fastest = 0.0;
  int iterations = 0, solves = 0, subSteps = 0;
  for (int s = 0; s < run.steps; ++s) {
    const Result<AirStep> step = (*solver)->step(3.0 / n);
    if (!step) return step.error();
    residual = worse(residual, step->residual);
    fastest = worse(fastest, step->fastest);
    iterations += step->iterations;
    solves += step->solves;
    subSteps += step->subSteps;
  }
  const double seconds = clock.seconds() / run.steps;
  row.addError("residual", residual, "1", 1e-3);
  row.addTime("seconds_per_step", seconds, "s");
  row.addRate("steps_per_second", 1.0 / seconds, "1/s", 1.0 / run.most);
  row.addTime("cells_per_second", static_cast<double>((*solver)->cells()) / seconds, "1/s");
  row.addFigure("iterations_per_solve", static_cast<double>(iterations) / solves, "1");
  row.addFigure("sub_steps_per_step", static_cast<double>(subSteps) / run.steps, "1");
  row.addFigure("fastest", fastest, "m/s");
  row.addFigure("bytes_per_cell",
                static_cast<double>((*solver)->bytes()) / static_cast<double>((*solver)->cells()), "byte");
  for (const StageTime& stage : (*solver)->timings().table())
    row.addTime("ms_" + stage.name, 1e3 * stage.seconds / run.steps, "ms");
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<SpeedRun> runs = {
      {64, false, 0.06, 20}, {64, true, 0.1, 20}, {128, false, 0.4, 10}, {128, true, 0.8, 10}};
  if (options.quick) runs = {{64, false, 0.06, 3}, {64, true, 0.1, 3}};
  std::vector<BenchRow> rows;
  for (const SpeedRun& r : runs) {
    Result<BenchRow> row = measure(options, r);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase airSpeedCase() {
  return {"air-speed", "time of a step of smoke over hills, all cells computed",
          "Jet takes 1.6 and 13 CPU-seconds for 64^3 and 128^3 cells", run};
}

}  // namespace spin
