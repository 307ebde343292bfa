// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/bench_meter.h"
#include "core/bench/flow_trials.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665;
constexpr double kSpacing = 0.05;

/// Mean height and pressure of every particle over many moments, and the mean square of their speed.
struct ColumnMeans {
  std::vector<double> height, pressure;
  double squares = 0.0;
  int moments = 0;

  void add(const std::vector<FlowSample>& samples) {
    height.resize(samples.size());
    pressure.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      height[i] += samples[i].particle.position.z;
      pressure[i] += samples[i].pressure;
      squares += dot(samples[i].particle.velocity, samples[i].particle.velocity);
    }
    ++moments;
  }
};

void addErrors(const ColumnMeans& means, double depth, const FlowMode& mode, int layers, BenchRow& row) {
  const double weight = 1000.0 * kGravity;
  double sum = 0.0, top = 0.0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < means.height.size(); ++i) {
    const double z = means.height[i] / means.moments;
    top = worse(top, z);
    if (z > depth - 2.0 * kSpacing) continue;  // the free surface, where neighbours are missing
    const double error = (means.pressure[i] / means.moments - weight * (depth - z)) / (weight * depth);
    sum += error * error;
    ++counted;
  }
  const bool accurate = mode.supportSpacings > 2.5;
  row.addError("pressure_rms", std::sqrt(sum / static_cast<double>(counted)), "1",
               accurate ? (layers >= 100 ? 0.012 : 0.025) : 0.05);
  row.addError("height_error", std::abs(top + 0.5 * kSpacing - depth) / kSpacing, "spacings", 1.0);
  const double speed = std::sqrt(means.squares / means.moments / static_cast<double>(means.height.size()));
  row.addError("residual_speed", speed / std::sqrt(kGravity * depth), "sqrt(g H)", 0.02);
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const std::vector<int> depths = options.quick ? std::vector<int>{40} : std::vector<int>{20, 40, 100};
  for (const int layers : depths)
    for (const FlowMode& mode : {kFastMode, kAccurateMode}) {
      if (options.quick && mode.supportSpacings > 2.5) continue;
      FlowTrial trial;
      trial.mode = mode;
      trial.across = layers;
      Result<BenchRow> row = hydrostaticTrial(options, trial);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  return rows;
}

}  // namespace

Result<BenchRow> hydrostaticTrial(const BenchOptions& options, const FlowTrial& trial) {
  const FlowMode& mode = trial.mode;
  const int layers = trial.across;
  BenchRow row;
  row.caseId = "hydrostatic";
  describe(trial, row);
  const BenchMeter meter;
  const double depth = layers * kSpacing;
  const int width = slabWidth(mode.supportSpacings);
  FlowConfig c;
  c.spacing = kSpacing;
  c.supportSpacings = mode.supportSpacings;
  c.density = trial.density;
  c.courant = trial.courant;
  c.pressure = trial.pressure;
  c.domainMin = {0, 0, -4 * kSpacing};
  c.domainMax = {width * kSpacing, width * kSpacing, 1.5 * depth};
  c.periodic[0] = c.periodic[1] = true;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(kGravity * depth);
  // Takes the first oscillations out; at rest it does nothing.
  c.materials[0].rheology.viscosity = static_cast<float>(0.1 * 1000.0 * std::sqrt(kGravity * depth) * depth);
  c.walls.planes = {{}};
  auto solver = startFlow(c, flowLattice(c, width, width, layers, {}, 0.1), options);
  if (!solver) return solver.error();
  const double fall = std::sqrt(depth / kGravity);
  Result<int> steps = runFlow(**solver, 9.0 * fall);
  ColumnMeans means;
  while (steps && means.moments < 100) {
    means.add((*solver)->samples());
    steps = runFlow(**solver, 0.02 * fall);
  }
  if (!steps) return steps.error();
  addErrors(means, depth, mode, layers, row);
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / (11.0 * fall), "1");
  nameDevice(**solver, options, row);
  return row;
}

BenchCase hydrostaticCase() {
  return {"hydrostatic", "pressure, height and residual speed of a water column at rest",
          "p(z) = rho g (H - z)", run};
}

}  // namespace spin
