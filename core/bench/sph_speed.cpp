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
#include "core/bench/longest_step.h"
#include "core/bench/worst.h"
#include "core/sph/flow_solver.h"
#ifdef SPIN_HAVE_CUDA
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"
#endif

namespace spin {
namespace {

using Solver = std::unique_ptr<FlowSolver>;

/// A cube of water that collapses to one side of a tank: floor and four walls, five half-spaces.
struct DamBreak {
  FlowConfig config;
  std::vector<FlowParticle> particles;
  bool collapses = false;  ///< run to a developed flow, instead of some steps at the start
};

/// `shears` takes a Herschel-Bulkley fluid, which needs the velocity gradient.
DamBreak damBreak(int particles, bool shears) {
  constexpr double kEdge = 1.0;  // m
  const int along = static_cast<int>(std::lround(std::cbrt(particles)));
  DamBreak scene;
  FlowConfig& c = scene.config;
  c.spacing = kEdge / along;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(2.0 * 9.80665 * kEdge);
  c.materials[0].rheology.viscosity = 0.5f;
  if (shears) {
    c.materials[0].rheology.law = RheologyLaw::Yield;
    c.materials[0].rheology.exponent = 0.8f;
    c.materials[0].rheology.cohesion = 1.0f;
    c.materials[0].rheology.most = 5.0f;
  }
  const double margin = 4.0 * c.spacing;
  c.domainMin = {-margin, -margin, -margin};
  c.domainMax = {3.0 * kEdge + margin, kEdge + margin, 2.5 * kEdge};
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0},
                    {{0, 0, 0}, {1, 0, 0}, {}, 0},
                    {{3.0 * kEdge, 0, 0}, {-1, 0, 0}, {}, 0},
                    {{0, 0, 0}, {0, 1, 0}, {}, 0},
                    {{0, kEdge, 0}, {0, -1, 0}, {}, 0}};
  for (int k = 0; k < along; ++k)
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < along; ++i) {
        FlowParticle p;
        p.position = Vec3d{i + 0.5, j + 0.5, k + 0.5} * c.spacing;
        scene.particles.push_back(p);
      }
  return scene;
}

struct StepTime {
  double wall = 0.0;       ///< s
  double cpu = 0.0;        ///< s, all threads together
  double simulated = 0.0;  ///< s
};

/// Median wall time of a batch of steps, and the processor time of all; asking for the timings waits for a
/// device that works ahead.
Result<StepTime> timePerStep(FlowSolver& solver) {
  constexpr int kWarmUp = 3, kBatches = 5, kSteps = 4;
  for (int s = 0; s < kWarmUp; ++s)
    if (const Result<FlowStep> ok = solver.step(1.0); !ok) return ok.error();
  solver.timings().clear();
  std::vector<double> batches;
  const std::clock_t cpuStart = std::clock();
  double simulated = 0.0;
  for (int b = 0; b < kBatches; ++b) {
    const auto start = std::chrono::steady_clock::now();
    for (int s = 0; s < kSteps; ++s) {
      const Result<FlowStep> done = solver.step(1.0);
      if (!done) return done.error();
      simulated += done->seconds;
    }
    solver.timings();
    batches.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() /
                      kSteps);
  }
  std::nth_element(batches.begin(), batches.begin() + kBatches / 2, batches.end());
  const double cpu = static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC;
  return StepTime{batches[kBatches / 2], cpu / (kBatches * kSteps), simulated / (kBatches * kSteps)};
}

double largestDensityError(const FlowSolver& solver, double restDensity) {
  double largest = 0.0;
  for (const FlowSample& p : solver.samples()) {
    largest = worse(largest, p.density / restDensity - 1.0);
  }
  return largest;
}

/// The collapse from the start to a developed flow.
struct Collapse {
  double simulated = 0.0, wall = 0.0;  ///< s
  int steps = 0, iterations = 0, unreached = 0;
  double compression = 0.0;  ///< implicit pressure: largest mean over particles after the first steps
};

Result<Collapse> runCollapse(FlowSolver& solver, double seconds) {
  Collapse run;
  solver.timings().clear();
  const auto start = std::chrono::steady_clock::now();
  while (run.simulated < seconds) {
    const Result<FlowStep> done = solver.step(1.0);
    if (!done) return done.error();
    run.simulated += done->seconds;
    ++run.steps;
    run.iterations += done->pressure.iterations;
    run.unreached += done->pressure.reached ? 0 : 1;
    if (run.simulated > 0.2 * seconds) run.compression = worse(run.compression, done->compression);
  }
  solver.timings();
  run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

/// At 200,000 particles on two threads; 0 = none.
double rateBar(std::size_t particles, int threads, const std::string& isa, bool shears) {
  if (threads != 2 || particles < 150'000 || particles > 250'000) return 0.0;
  if (isa == isaName(Isa::Avx512)) return shears ? 3e6 : 8e6;
  return isa == isaName(Isa::Avx2) && !shears ? 5e6 : 0.0;
}

void addStages(FlowSolver& solver, BenchRow& row) {
  double total = 0.0;
  const std::vector<StageTime> stages = solver.timings().table();
  for (const StageTime& stage : stages) total += stage.seconds;
  for (const StageTime& stage : stages)
    row.addTime("share_" + stage.name, 100.0 * stage.seconds / total, "%");
}

constexpr double kCollapseSeconds = 0.3;

/// Seconds per simulated second: of the implicit pressure, or of the state equation with the longest step
/// that carries the scene.
Result<BenchRow> measureCollapse(const DamBreak& scene, FlowSolver& solver, int threads,
                                 const std::string& isa) {
  const FlowConfig& c = scene.config;
  const bool implicit = c.pressure == PressureMode::Implicit;
  const BenchMeter meter;
  BenchRow row;
  const double n = static_cast<double>(scene.particles.size());
  if (const Status ok = solver.add(scene.particles); !ok) return ok.error();
  const Result<Collapse> run = runCollapse(solver, kCollapseSeconds);
  if (!run) return run.error();
  row.caseId = "sph-speed";
  row.settings = {{"particles", fmt::format("{}", scene.particles.size())},
                  {"solver", implicit ? "implicit, 1 %" : "state equation, longest step"}};
  row.addTime("seconds_per_simulated_second", run->wall / run->simulated, "1");
  row.addTime("particle_steps_per_second", n * run->steps / run->wall, "1/s");
  row.addFigure("seconds_per_step", run->simulated / run->steps, "s");
  if (implicit) {
    row.addFigure("iterations_per_step", static_cast<double>(run->iterations) / run->steps, "1");
    row.addFigure("steps_not_converged", run->unreached, "1");
    row.addError("mean_compression", run->compression, "1", c.densityError);
  } else {
    row.addFigure("courant", c.courant, "1");
  }
  row.addFigure("bytes_per_particle", static_cast<double>(solver.bytes()) / n, "B");
  addStages(solver, row);
  meter.finish(row);
  row.device = solver.device();
  row.isa = isa;
  row.threads = threads;
  return row;
}

Result<BenchRow> measure(const DamBreak& scene, FlowSolver& solver, int threads, const std::string& isa) {
  if (scene.collapses) return measureCollapse(scene, solver, threads, isa);
  const BenchMeter meter;
  BenchRow row;
  const double n = static_cast<double>(scene.particles.size());
  if (const Status ok = solver.add(scene.particles); !ok) return ok.error();
  const Result<StepTime> time = timePerStep(solver);
  if (!time) return time.error();
  row.caseId = "sph-speed";
  const bool shears = scene.config.materials[0].rheology.needsShearRate();
  row.settings = {{"particles", fmt::format("{}", scene.particles.size())},
                  {"rheology", shears ? "herschel-bulkley" : "newtonian"},
                  {"density", scene.config.density == DensityMode::Continuity ? "continuity" : "summation"}};
  const double rate = n / time->wall;
  if (const double bar = rateBar(scene.particles.size(), threads, isa, shears); bar > 0.0)
    row.addRate("particle_steps_per_second", rate, "1/s", bar);
  else
    row.addTime("particle_steps_per_second", rate, "1/s");
  row.addTime("seconds_per_simulated_second", time->wall / time->simulated, "1");
  // Says on a busy machine what a free one would do; a card has its own clock.
  if (std::string_view(solver.device()) == "cpu")
    row.addTime("particle_steps_per_cpu_second", n / time->cpu, "1/s");
  row.addError("bytes_per_particle", static_cast<double>(solver.bytes()) / n, "B", 150.0);
  // Compression beyond a tenth would mean that the scene, or the solver, has blown up.
  row.addError("largest_compression", largestDensityError(solver, scene.config.materials[0].restDensity), "1",
               0.1);
  addStages(solver, row);
  meter.finish(row);
  row.device = solver.device();
  row.isa = isa;
  row.threads = threads;
  return row;
}

enum class Kind { Newtonian, Carried, Shears, Implicit, Longest };

/// The scene of a row; the longest step is searched with a small one, on a processor. It goes by continuity:
/// by summation the state equation gains energy from walls at any step.
Result<DamBreak> sceneOf(Kind kind, int particles, const BenchOptions& options) {
  constexpr int kSmall = 8000;
  DamBreak scene = damBreak(particles, kind == Kind::Shears);
  FlowConfig& c = scene.config;
  scene.collapses = kind == Kind::Implicit || kind == Kind::Longest;
  if (kind == Kind::Implicit) c.pressure = PressureMode::Implicit;
  if (kind == Kind::Carried || kind == Kind::Longest) c.density = DensityMode::Continuity;
  if (kind != Kind::Longest) return scene;
  DamBreak small = damBreak(kSmall, false);
  small.config.density = c.density;
  BenchOptions onProcessor = options;
  onProcessor.device = "cpu";
  const Result<double> courant =
      longestCourant(small.config, small.particles, 2.0 * kCollapseSeconds, onProcessor);
  if (!courant) return courant.error();
  c.courant = c.forceFactor = *courant;
  return scene;
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
    Result<Solver> solver = makeFlowSolverCpu(scene.config, threads, *isa);
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
    Result<Solver> solver = makeFlowSolverCuda(scene.config);
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

std::vector<Kind> kindsOf(int particles, bool quick) {
  if (particles == 200000 && !quick)
    return {Kind::Newtonian, Kind::Carried, Kind::Shears, Kind::Implicit, Kind::Longest};
  if (particles == 200000) return {Kind::Newtonian, Kind::Carried, Kind::Shears};
  if (particles == 50000) return {Kind::Newtonian, Kind::Implicit};
  return {Kind::Newtonian};
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<int> sizes{50000, 200000};
  if (!options.quick) sizes.insert(sizes.end(), {1000000, 4000000});
  // What a card needs to be busy, as others publish it.
  if (!options.quick && options.device == "cuda") sizes = {200000, 512000, 2000000, 8000000};
  std::vector<BenchRow> rows;
  for (const int size : sizes)
    for (const Kind kind : kindsOf(size, options.quick)) {
      const Result<DamBreak> scene = sceneOf(kind, size, options);
      if (!scene) return scene.error();
      if (options.device != "cpu")
        if (const Status ok = addCudaRows(options, *scene, rows); !ok) return ok.error();
      if (options.device != "cuda")
        if (const Status ok = addCpuRows(options, *scene, rows); !ok) return ok.error();
    }
  return rows;
}

}  // namespace

BenchCase sphSpeedCase() {
  return {"sph-speed", "particle-steps per second of the particle solver, dam break in a tank",
          "rates of peers in resources/docs/performance.md", run};
}

}  // namespace spin
