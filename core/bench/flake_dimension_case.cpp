// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <time.h>

#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/flake/flake_grower.h"
#include "core/flake/flake_measure.h"

namespace spin {
namespace {

/// Time that this thread has worked: a rate per core whatever else the machine does.
double threadSeconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The finest particles allowed, so that only their number ends the growth.
FlakeSettings settingsOf(FlakeSymmetry symmetry, int particles, int run) {
  FlakeSettings settings;
  settings.symmetry = symmetry;
  settings.seed = static_cast<std::uint64_t>(100 + run);
  settings.radius = kLargestFlake;
  settings.particleDiameter = kLargestFlake / kLargestReach;
  settings.particles = particles;
  return settings;
}

BenchRow measure(FlakeSymmetry symmetry, const char* id, int particles, int runs) {
  BenchRow row;
  row.caseId = "flake-dimension";
  row.settings = {{"symmetry", id}, {"particles", std::to_string(particles)}, {"runs", std::to_string(runs)}};
  const BenchMeter meter;
  double sum = 0.0, squares = 0.0, byRadius = 0.0, prefactor = 0.0, seconds = 0.0, grown = 0.0;
  for (int run = 0; run < runs; ++run) {
    const double start = threadSeconds();
    FlakeGrower grower(settingsOf(symmetry, particles, run));
    while (!grower.done()) (void)grower.grow(static_cast<std::size_t>(particles), CancelToken());
    seconds += threadSeconds() - start;
    grown += static_cast<double>(grower.centres().size());
    const double d = gyrationDimension(grower.centres());
    const MassRadiusLaw law = massRadiusLaw(grower.centres());
    sum += d, squares += d * d, byRadius += law.dimension, prefactor += law.prefactor;
  }
  const double mean = sum / runs;
  if (symmetry == FlakeSymmetry::Free && runs >= 5)  // single clusters scatter by 0.03 to 0.06
    row.addError("dimension_error", std::abs(mean - 1.71), "1", 0.05);
  row.addFigure("dimension", mean, "1");
  row.addFigure("dimension_spread", std::sqrt(std::max(squares / runs - mean * mean, 0.0)), "1");
  row.addFigure("dimension_by_radius", byRadius / runs, "1");
  row.addFigure("mass_radius_prefactor", prefactor / runs, "1");
  if (symmetry == FlakeSymmetry::Free && particles >= 100000)
    row.addRate("particles_per_second", grown / seconds, "1/s", 100000.0);
  else
    row.addTime("particles_per_second", grown / seconds, "1/s");
  meter.finish(row);
  row.threads = 1;
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  rows.push_back(measure(FlakeSymmetry::Free, "free", 10000, options.quick ? 12 : 24));
  rows.push_back(measure(FlakeSymmetry::Free, "free", 100000, options.quick ? 1 : 10));
  rows.push_back(measure(FlakeSymmetry::Six, "six", 10000, options.quick ? 2 : 10));
  rows.push_back(measure(FlakeSymmetry::Eight, "eight", 10000, options.quick ? 2 : 10));
  return rows;
}

}  // namespace

BenchCase flakeDimensionCase() {
  return {"flake-dimension",
          "fractal dimension of grown flakes by their radius of gyration, and growing speed",
          "diffusion-limited aggregation off the lattice in the plane: 1.71", run};
}

}  // namespace spin
