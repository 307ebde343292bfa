// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/flow_bench_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/bench/flow_trials.h"
#ifdef SPIN_HAVE_CUDA
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"
#endif

namespace spin {
namespace {

Vec3d wrapped(const FlowConfig& c, Vec3d p) {
  const auto inside = [&](int axis) {
    const double low = c.domainMin[axis], length = c.domainMax[axis] - low;
    return c.periodic[axis] ? p[axis] - length * std::floor((p[axis] - low) / length) : p[axis];
  };
  return {inside(0), inside(1), inside(2)};
}

}  // namespace

std::vector<FlowParticle> flowLattice(const FlowConfig& config, int nx, int ny, int nz, Vec3d corner,
                                      double jitter) {
  const CounterRandom random{11, 4};
  std::vector<FlowParticle> particles;
  particles.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) *
                    static_cast<std::size_t>(nz));
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::uint64_t id = particles.size();
        const auto shift = [&](std::uint32_t draw) {
          return jitter * (2.0 * random.uniformDouble(id, draw) - 1.0);
        };
        const Vec3d cell{i + 0.5 + shift(0), j + 0.5 + shift(1), k + 0.5 + shift(2)};
        FlowParticle p;
        p.position = wrapped(config, corner + cell * config.spacing);
        particles.push_back(p);
      }
  return particles;
}

int slabWidth(double supportSpacings) {
  return static_cast<int>(std::lround(supportSpacings * std::max(3.0, std::ceil(7.0 / supportSpacings))));
}

Result<std::unique_ptr<FlowSolver>> startFlow(const FlowConfig& config,
                                              const std::vector<FlowParticle>& particles,
                                              const BenchOptions& options) {
  Result<std::unique_ptr<FlowSolver>> solver = [&]() -> Result<std::unique_ptr<FlowSolver>> {
#ifdef SPIN_HAVE_CUDA
    if (options.device != "cpu" && cudaAvailable()) return makeFlowSolverCuda(config);
#endif
    const Result<Isa> isa = chooseIsa(options.isa);
    if (!isa) return isa.error();
    return makeFlowSolverCpu(config, options.threads, *isa);
  }();
  if (!solver) return solver.error();
  if (Status added = (*solver)->add(particles); !added) return added.error();
  return solver;
}

Result<int> runFlow(FlowSolver& solver, double seconds) {
  // What rounding leaves of the last step is no step.
  const double least = 1e-9 * seconds;
  int steps = 0;
  for (; seconds > least; ++steps) {
    const Result<FlowStep> done = solver.step(seconds);
    if (!done) return done.error();
    seconds -= done->seconds;
  }
  return steps;
}

void describe(const FlowTrial& trial, BenchRow& row) {
  row.settings["mode"] = trial.mode.id;
  row.settings["density"] = trial.density == DensityMode::Continuity ? "continuity" : "summation";
  row.settings["pressure"] = trial.pressure == PressureMode::Implicit ? "implicit" : "state equation";
  row.settings["across"] = std::to_string(trial.across);
  row.settings["courant"] = fmt::format("{:g}", trial.courant);
}

void nameDevice(const FlowSolver& solver, const BenchOptions& options, BenchRow& row) {
  row.device = solver.device();
  if (row.device != "cpu") return;
  if (const Result<Isa> isa = chooseIsa(options.isa)) row.isa = isaName(*isa);
  row.threads = CpuBackend(options.threads).threads();
}

}  // namespace spin
