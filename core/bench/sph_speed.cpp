// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <string_view>

#include "core/base/parallel.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"
#include "core/sph/sph_slice.h"
#ifdef SPIN_HAVE_CUDA
#include "gpu/cuda_device.h"
#include "gpu/sph_slice_cuda.h"
#endif

namespace spin {
namespace {

using Solver = std::unique_ptr<SphSliceSolver>;

/// A cube of water on a floor, periodic across, free to collapse to both sides.
struct DamBreak {
  SphSliceConfig config;
  std::vector<Vec3d> positions;
};

DamBreak damBreak(int particles) {
  constexpr double kEdge = 1.0;  // m
  const int along = static_cast<int>(std::lround(std::cbrt(particles)));
  const int across = along + along % 2;  // whole supports, two spacings each
  DamBreak scene;
  SphSliceConfig& c = scene.config;
  c.spacing = kEdge / along;
  c.viscosity = 0.5;
  c.soundSpeed = 10.0 * std::sqrt(2.0 * c.gravity * kEdge);
  c.domainMax = {3.0 * kEdge, across * c.spacing, 1.5 * kEdge};
  c.periodicY = true;
  for (int k = 0; k < along; ++k)
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < along; ++i)
        scene.positions.push_back(
            {kEdge + (i + 0.5) * c.spacing, (j + 0.5) * c.spacing, (k + 0.5) * c.spacing});
  return scene;
}

struct StepTime {
  double wall = 0.0;  ///< s
  double cpu = 0.0;   ///< s, all threads together
};

/// Median wall time of a batch of steps, and the processor time of all; asking for the timings waits for a
/// device that works ahead.
Result<StepTime> timePerStep(SphSliceSolver& solver, double timeStep) {
  constexpr int kWarmUp = 3, kBatches = 5, kSteps = 4;
  for (int s = 0; s < kWarmUp; ++s)
    if (const Status ok = solver.step(timeStep); !ok) return ok.error();
  solver.timings().clear();
  std::vector<double> batches;
  const std::clock_t cpuStart = std::clock();
  for (int b = 0; b < kBatches; ++b) {
    const auto start = std::chrono::steady_clock::now();
    for (int s = 0; s < kSteps; ++s)
      if (const Status ok = solver.step(timeStep); !ok) return ok.error();
    solver.timings();
    batches.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                      kSteps);
  }
  std::nth_element(batches.begin(), batches.begin() + kBatches / 2, batches.end());
  const double cpu = static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
  return StepTime{batches[kBatches / 2], cpu / (kBatches * kSteps)};
}

double largestDensityError(const SphSliceSolver& solver, double restDensity) {
  double largest = 0.0;
  for (const SphParticle& p : solver.particles()) {
    largest = worse(largest, p.density / restDensity - 1.0);
  }
  return largest;
}

Result<BenchRow> measure(const DamBreak& scene, SphSliceSolver& solver, int threads, const std::string& isa) {
  const BenchMeter meter;
  BenchRow row;
  const double n = static_cast<double>(scene.positions.size());
  if (const Status ok = solver.setParticles(scene.positions, {}); !ok) return ok.error();
  const Result<StepTime> time = timePerStep(solver, scene.config.stableTimeStep());
  if (!time) return time.error();
  row.caseId = "sph-speed";
  row.settings = {{"particles", fmt::format("{}", scene.positions.size())}};
  row.addTime("particle_steps_per_second", n / time->wall, "1/s");
  // Says on a busy machine what a free one would do; a card has its own clock.
  if (std::string_view(solver.device()) == "cpu")
    row.addTime("particle_steps_per_cpu_second", n / time->cpu, "1/s");
  row.addError("bytes_per_particle", static_cast<double>(solver.bytes()) / n, "B", 150.0);
  // Compression beyond a tenth would mean that the scene, or the solver, has blown up.
  row.addError("largest_compression", largestDensityError(solver, scene.config.restDensity), "1", 0.1);
  double total = 0.0;
  const std::vector<StageTime> stages = solver.timings().table();
  for (const StageTime& stage : stages) total += stage.seconds;
  for (const StageTime& stage : stages)
    row.addTime("share_" + stage.name, 100.0 * stage.seconds / total, "%");
  meter.finish(row);
  row.device = solver.device();
  row.isa = isa;
  row.threads = threads;
  return row;
}

BenchRow skippedRow(const std::string& why) {
  BenchRow row;
  row.caseId = "sph-speed";
  row.skipped = why;
  return row;
}

Status addCpuRows(const BenchOptions& options, const DamBreak& scene, std::vector<BenchRow>& rows) {
  std::vector<Isa> sets;
  if (options.isa == "auto" && !options.quick) {
    sets = runnableIsas();
  } else {
    const Result<Isa> isa = chooseIsa(options.isa);
    if (!isa) return rows.push_back(skippedRow(isa.error().text())), Status{};
    sets = {*isa};
  }
  const int threads = CpuBackend(options.threads).threads();
  for (auto isa = sets.rbegin(); isa != sets.rend(); ++isa) {
    Result<Solver> solver = makeSphSliceCpu(scene.config, threads, *isa);
    if (!solver) return solver.error();
    Result<BenchRow> row = measure(scene, **solver, threads, isaName(*isa));
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return {};
}

/// Rows for the card; where there is none, a skipped row if the card was asked for.
Status addCudaRows(const BenchOptions& options, const DamBreak& scene, std::vector<BenchRow>& rows) {
#ifdef SPIN_HAVE_CUDA
  if (cudaAvailable()) {
    Result<Solver> solver = makeSphSliceCuda(scene.config);
    if (!solver) return solver.error();
    Result<BenchRow> row = measure(scene, **solver, 1, cudaDevice()->backend);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  } else if (options.device == "cuda") {
    rows.push_back(skippedRow(cudaDevice().error().text()));
  }
#else
  static_cast<void>(scene);
  if (options.device == "cuda") rows.push_back(skippedRow("this program was built without CUDA"));
#endif
  return {};
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const std::vector<int> sizes =
      options.quick ? std::vector<int>{50000, 200000} : std::vector<int>{50000, 200000, 1000000, 4000000};
  std::vector<BenchRow> rows;
  for (const int size : sizes) {
    const DamBreak scene = damBreak(size);
    if (options.device != "cpu")
      if (const Status ok = addCudaRows(options, scene, rows); !ok) return ok.error();
    if (options.device != "cuda")
      if (const Status ok = addCpuRows(options, scene, rows); !ok) return ok.error();
  }
  return rows;
}

}  // namespace

BenchCase sphSpeedCase() {
  return {"sph-speed", "particle-steps per second of the particle solver's slice, dam break",
          "rates of peers in resources/docs/performance.md", run};
}

}  // namespace spin
