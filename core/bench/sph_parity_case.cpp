// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"
#include "core/bench/worst.h"
#ifdef SPIN_HAVE_CUDA
#include "gpu/cuda_device.h"
#include "gpu/flow_solver_cuda.h"
#endif

namespace spin {
namespace {

using Solver = std::unique_ptr<FlowSolver>;

/// What of the solver a row goes through.
struct Path {
  const char* id;
  void (*set)(FlowConfig&);
};
constexpr Path kPaths[] = {
    {"summation", [](FlowConfig&) {}},
    {"continuity", [](FlowConfig& c) { c.density = DensityMode::Continuity; }},
    {"herschel-bulkley, xsph",
     [](FlowConfig& c) {
       Rheology& r = c.materials[0].rheology;
       r.law = RheologyLaw::Yield;
       r.exponent = 0.8f;
       r.cohesion = 1.0f;
       r.most = 5.0f;
       c.smoothing = 0.2;
     }},
    {"implicit pressure and viscosity",
     [](FlowConfig& c) {
       c.pressure = PressureMode::Implicit;
       c.viscosity = ViscosityMode::Implicit;
     }},
};

/// A cube of water in a tank hardly longer than it is.
FlowConfig tank(int along) {
  FlowConfig c;
  c.spacing = 1.0 / along;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(2.0 * 9.80665);
  c.materials[0].rheology.viscosity = 0.5f;
  const double margin = 4.0 * c.spacing;
  c.domainMin = {-margin, -margin, -margin};
  c.domainMax = {1.1 + margin, 1.0 + margin, 2.5};
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0},
                    {{0, 0, 0}, {1, 0, 0}, {}, 0},
                    {{1.1, 0, 0}, {-1, 0, 0}, {}, 0},
                    {{0, 0, 0}, {0, 1, 0}, {}, 0},
                    {{0, 1, 0}, {0, -1, 0}, {}, 0}};
  return c;
}

struct Differences {
  double place = 0.0, speed = 0.0, pressure = 0.0;  ///< root mean squares, against the scales
  double energy = 0.0;                              ///< of the sums
};

/// Of the same particles; scales are a spacing, the fastest particle and the largest pressure.
Differences differencesOf(const std::vector<FlowSample>& a, const std::vector<FlowSample>& b,
                          double spacing) {
  Differences d;
  if (a.size() != b.size()) return {NAN, NAN, NAN, NAN};
  double fastest = 1e-12, most = 1e-12, energyA = 0.0, energyB = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3d apart = a[i].particle.position - b[i].particle.position;
    const Vec3d faster = a[i].particle.velocity - b[i].particle.velocity;
    d.place += dot(apart, apart);
    d.speed += dot(faster, faster);
    d.pressure += (a[i].pressure - b[i].pressure) * (a[i].pressure - b[i].pressure);
    fastest = std::max(fastest, length(a[i].particle.velocity));
    most = std::max(most, std::abs(a[i].pressure));
    energyA += dot(a[i].particle.velocity, a[i].particle.velocity);
    energyB += dot(b[i].particle.velocity, b[i].particle.velocity);
  }
  const double n = static_cast<double>(a.size());
  return {std::sqrt(d.place / n) / spacing, std::sqrt(d.speed / n) / fastest,
          std::sqrt(d.pressure / n) / most, std::abs(energyA - energyB) / std::max(energyA, 1e-12)};
}

/// Both take the same steps, those of the first.
Status advance(FlowSolver& first, FlowSolver& second, int steps) {
  for (int k = 0; k < steps; ++k) {
    const Result<FlowStep> done = first.step(1e-3);
    if (!done) return done.error();
    double left = done->seconds;
    // A limit that is lower in its last bit is no reason for a step of nothing: the next one's density would
    // go by it.
    while (left > 1e-6 * done->seconds) {
      const Result<FlowStep> same = second.step(left);
      if (!same) return same.error();
      left -= same->seconds;
    }
  }
  return {};
}

Result<BenchRow> compare(const Path& path, const FlowConfig& config, FlowSolver& reference, FlowSolver& other,
                         const std::string& name) {
  const BenchMeter meter;
  BenchRow row;
  row.caseId = "sph-parity";
  row.settings = {{"path", path.id}, {"against baseline", name}};
  const int along = static_cast<int>(std::lround(1.0 / config.spacing));
  auto particles = flowLattice(config, along, along, along, {}, 0.1);
  // At rest nothing would differ for long: it is thrown at the far wall, and stirred.
  const CounterRandom random{23, 5};
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles[i].velocity = {3.0 + random.uniformDouble(i, 0), random.uniformDouble(i, 1) - 0.5,
                             random.uniformDouble(i, 2) - 0.5};
  for (FlowSolver* solver : {&reference, &other})
    if (const Status ok = solver->add(particles); !ok) return ok.error();
  int gone = 0;
  for (const int mark : {1, 100}) {
    if (const Status ok = advance(reference, other, mark - gone); !ok) return ok.error();
    gone = mark;
    const Differences d = differencesOf(reference.samples(), other.samples(), config.spacing);
    const std::string when = mark == 1 ? "_after_1_step" : fmt::format("_after_{}_steps", mark);
    // Rounding alone: a float has 6e-8, and a hundred steps of impact make more of it.
    row.addError("place" + when, d.place, "spacings", mark == 1 ? 1e-6 : 1e-3);
    row.addError("speed" + when, d.speed, "fastest", mark == 1 ? 1e-5 : 1e-3);
    row.addError("pressure" + when, d.pressure, "largest", mark == 1 ? 1e-5 : 1e-3);
    row.addError("kinetic_energy" + when, d.energy, "1", mark == 1 ? 1e-5 : 1e-3);
  }
  meter.finish(row);
  row.device = other.device();
  row.isa = name;
  return row;
}

/// The baseline set on the processor against every other set, and against the card.
Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const int along = options.quick ? 16 : 32;
  for (const Path& path : kPaths) {
    FlowConfig config = tank(along);
    path.set(config);
    const auto add = [&](Result<Solver> other, const std::string& name) -> Status {
      Result<Solver> reference = makeFlowSolverCpu(config, options.threads, Isa::Baseline);
      if (!reference) return reference.error();
      if (!other) return other.error();
      Result<BenchRow> row = compare(path, config, **reference, **other, name);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
      return {};
    };
    if (options.device != "cuda")
      for (const Isa isa : runnableIsas())
        if (isa != Isa::Baseline)
          if (Status ok = add(makeFlowSolverCpu(config, options.threads, isa), isaName(isa)); !ok)
            return ok.error();
#ifdef SPIN_HAVE_CUDA
    if (options.device != "cpu" && cudaAvailable())
      if (Status ok = add(makeFlowSolverCuda(config), cudaDevice()->backend); !ok) return ok.error();
#endif
  }
  if (!rows.empty()) return rows;
  BenchRow row;
  row.caseId = "sph-parity";
  row.skipped = "there is nothing to compare the baseline with on this machine";
  return std::vector<BenchRow>{row};
}

}  // namespace

BenchCase sphParityCase() {
  return {"sph-parity", "what instruction sets and cards make different in the same flow",
          "the processor's baseline set", run};
}

}  // namespace spin
