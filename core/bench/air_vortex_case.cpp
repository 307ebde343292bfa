// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_flows.h"
#include "core/bench/air_trials.h"
#include "core/bench/bench_meter.h"

namespace spin {
namespace {

constexpr double kReynolds = 1000.0;
constexpr double kSeconds = 1.0;

struct VortexErrors {
  double keptEnergy = 0.0, velocity = 0.0;
};

VortexErrors errorsOf(const AirBox& now, const AirBox& exact) {
  double energy = 0.0, expected = 0.0, difference = 0.0;
  now.forEach([&](int i, int j, int k) {
    for (const AirValue field : {AirValue::U, AirValue::W}) {
      const double a = static_cast<double>(now.at(field, i, j, k)),
                   b = static_cast<double>(exact.at(field, i, j, k));
      energy += a * a;
      expected += b * b;
      difference += (a - b) * (a - b);
    }
  });
  return {energy / expected, std::sqrt(difference / expected)};
}

}  // namespace

std::string nameOf(const AirTrial& trial) {
  std::string name = trial.advection == AirAdvection::SemiLagrangian ? "semi-Lagrangian"
                     : trial.advection == AirAdvection::Cubic        ? "cubic"
                                                                     : "MacCormack";
  if (trial.reflection) name += ", reflected";
  return name + (trial.pressure == AirPressure::Multigrid ? ", multigrid"
                 : trial.pressure == AirPressure::Jacobi  ? ", Jacobi"
                                                          : ", Gauss-Seidel");
}

void describe(const AirTrial& trial, BenchRow& row) {
  row.settings["scheme"] = nameOf(trial);
  row.settings["across"] = std::to_string(trial.across);
  row.settings["courant"] = fmt::format("{:g}", trial.courant);
}

Result<BenchRow> taylorGreenTrial(const BenchOptions& options, const AirTrial& trial) {
  BenchRow row;
  row.caseId = "taylor-green";
  describe(trial, row);
  const BenchMeter meter;
  const int n = trial.across;
  AirConfig config = stillBox({n, kBrickY, n}, 1.0 / n);
  config.viscosity = 1.0 / kReynolds;
  config.advection = trial.advection;
  config.reflection = trial.reflection;
  config.solver = trial.pressure;
  config.mostCourant = 100.0;
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  AirBox start({n, kBrickY, n});
  setVortices(start, 1.0);
  if (Status set = (*solver)->restore(start.state()); !set) return set.error();
  const int steps = static_cast<int>(std::lround(kSeconds * n / trial.courant));
  int iterations = 0, solves = 0;
  const BenchMeter clock;
  for (int s = 0; s < steps; ++s) {
    const Result<AirStep> step = (*solver)->step(kSeconds / steps);
    if (!step) return step.error();
    iterations += step->iterations;
    solves += step->solves;
  }
  const double seconds = clock.seconds();
  AirBox exact({n, kBrickY, n});
  setVortices(exact, std::exp(-8.0 * kPi * kPi / kReynolds * kSeconds));
  const VortexErrors errors = errorsOf(AirBox((*solver)->state()), exact);
  row.addFigure("kept_energy", errors.keptEnergy, "1");
  row.addFigure("velocity_l2", errors.velocity, "1");
  row.addFigure("iterations_per_solve", static_cast<double>(iterations) / solves, "1");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", seconds / kSeconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

namespace {

double figure(const BenchRow& row, const std::string& name) {
  for (const auto& [key, metric] : row.metrics)
    if (key == name) return metric.value;
  return std::nan("");
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const auto add = [&](const AirTrial& trial) -> Status {
    Result<BenchRow> row = taylorGreenTrial(options, trial);
    if (!row) return row.error();
    // At the default, energy may be neither lost nor won.
    if (trial.advection == AirAdvection::MacCormack && trial.reflection)
      row->addError("energy_error", std::abs(figure(*row, "kept_energy") - 1.0), "1", 0.005);
    rows.push_back(std::move(*row));
    return {};
  };
  const int n = options.quick ? 80 : 128;
  if (Status ok = add({AirAdvection::MacCormack, true, AirPressure::Multigrid, n}); !ok) return ok.error();
  if (options.quick) return rows;
  for (const AirTrial& trial : {AirTrial{AirAdvection::SemiLagrangian, false, AirPressure::Multigrid, n},
                                AirTrial{AirAdvection::MacCormack, false, AirPressure::Multigrid, n},
                                AirTrial{AirAdvection::Cubic, false, AirPressure::Multigrid, n},
                                AirTrial{AirAdvection::Cubic, true, AirPressure::Multigrid, n}})
    if (Status ok = add(trial); !ok) return ok.error();
  return rows;
}

/// Advection by projection, coarse to fine.
Result<std::vector<BenchRow>> runWorkPrecision(const BenchOptions& options) {
  std::vector<AirTrial> ways;
  for (const AirAdvection advection :
       {AirAdvection::SemiLagrangian, AirAdvection::MacCormack, AirAdvection::Cubic})
    for (const bool reflection : {false, true}) ways.push_back({advection, reflection});
  for (const AirPressure pressure : {AirPressure::Jacobi, AirPressure::GaussSeidel})
    ways.push_back({AirAdvection::MacCormack, true, pressure});
  std::vector<BenchRow> rows;
  for (AirTrial& way : ways)
    for (const int n : options.quick ? std::vector<int>{32} : std::vector<int>{32, 64, 128, 256}) {
      way.across = n;
      Result<BenchRow> trial = taylorGreenTrial(options, way);
      if (!trial) return trial.error();
      BenchRow row;
      row.caseId = "air-work-precision";
      describe(way, row);
      // A bar that only nonsense misses: the schemes are compared with each other.
      row.addError(nameOf(way), figure(*trial, "velocity_l2"), "1", 1.0);
      row.addTime("seconds_per_simulated_second", figure(*trial, "seconds_per_simulated_second"), "1");
      row.seconds = trial->seconds;
      row.peakBytes = trial->peakBytes;
      row.device = trial->device;
      row.isa = trial->isa;
      row.threads = trial->threads;
      rows.push_back(std::move(row));
    }
  return rows;
}

}  // namespace

BenchCase taylorGreenCase() {
  return {"taylor-green", "decay of vortices on the grid at Re 1000", "exact solution of Taylor and Green",
          run};
}

BenchCase airWorkPrecisionCase() {
  return {"air-work-precision", "error of decaying vortices against seconds, by advection and projection",
          "exact solution of Taylor and Green", runWorkPrecision};
}

}  // namespace spin
