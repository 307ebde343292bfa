// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "core/bench/flow_trials.h"

namespace spin {
namespace {

/// A flow, its error and the resolutions it is computed at.
struct Probe {
  const char* id;
  const char* error;  ///< name in the trial's row
  Result<BenchRow> (*run)(const BenchOptions&, const FlowTrial&);
  std::vector<int> coarse, fine;  ///< of the quick form, of the full one
};

/// One curve of the plot: a way to compute.
struct Way {
  const char* id;
  FlowMode mode;
  DensityMode density;
  double courant;
  PressureMode pressure = PressureMode::EquationOfState;
};

std::vector<Way> waysOf(bool quick) {
  const std::vector<Way> all = {
      {"fast", kFastMode, DensityMode::Continuity, 0.25},
      {"fast, long steps", kFastMode, DensityMode::Continuity, 0.4},
      {"fast, by summation", kFastMode, DensityMode::Summation, 0.25},
      {"fast, implicit pressure", kFastMode, DensityMode::Summation, 0.25, PressureMode::Implicit},
      {"accurate", kAccurateMode, DensityMode::Continuity, 0.25}};
  return quick ? std::vector<Way>{all.front()} : all;
}

/// The trial's row with its error under a name of its own, so that each way is one curve.
Result<BenchRow> measure(const BenchOptions& options, const Probe& probe, const Way& way, int across) {
  FlowTrial trial;
  trial.mode = way.mode;
  trial.density = way.density;
  trial.courant = way.courant;
  trial.pressure = way.pressure;
  trial.across = across;
  Result<BenchRow> run = probe.run(options, trial);
  if (!run) return run.error();
  BenchRow row;
  row.caseId = "sph-work-precision";
  describe(trial, row);
  row.settings["flow"] = probe.id;
  for (const auto& [name, metric] : run->metrics) {
    if (name == probe.error)
      row.addError(std::string(probe.id) + " " + way.id, metric.value, metric.unit, metric.bar);
    else if (name == "seconds_per_simulated_second")
      row.addTime(name, metric.value, metric.unit);
  }
  row.seconds = run->seconds;
  row.peakBytes = run->peakBytes;
  row.device = run->device;
  row.isa = run->isa;
  row.threads = run->threads;
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const Probe probes[] = {{"dam break", "koshizuka_oka", damFrontTrial, {8}, {10, 20, 40}},
                          {"column", "pressure_rms", hydrostaticTrial, {16}, {20, 40}},
                          {"channel", "profile_l2", poiseuilleTrial, {12}, {10, 20, 40}}};
  std::vector<BenchRow> rows;
  for (const Probe& probe : probes)
    for (const Way& way : waysOf(options.quick))
      for (const int across : options.quick ? probe.coarse : probe.fine) {
        Result<BenchRow> row = measure(options, probe, way, across);
        if (!row) return row.error();
        rows.push_back(std::move(*row));
      }
  return rows;
}

}  // namespace

BenchCase sphWorkPrecisionCase() {
  return {"sph-work-precision",
          "errors of dam break, column and channel against seconds per simulated second",
          "as in their own cases", run};
}

}  // namespace spin
