// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kSlope = 24.0 * 3.14159265358979323846 / 180.0;
/// Steps that are tried; the largest is where sound goes a spacing in a step.
constexpr double kShortest = 2e-4, kPrecision = 1.05;
constexpr double kMostCompression = 0.1, kMostGain = 0.01;
constexpr int kMoments = 10;

/// Water beside the Cross fluid of the scene water_and_snow, a small piece of it, on a slope of 24 degrees.
struct TwoFluids {
  FlowConfig config;
  std::vector<FlowParticle> particles;
};

/// `atCap`: the second fluid is as viscous as the cap allows everywhere, as the published one is whose shear
/// rate is the trace of the velocity gradient, which a flow that keeps its volume does not have.
TwoFluids twoFluids(double sound, double cap, bool atCap, ViscosityMode viscosity) {
  constexpr int kAlong = 20, kAcross = 10, kLayers = 12;
  TwoFluids made;
  FlowConfig& c = made.config;
  c.spacing = 0.05;
  c.gravity = {kGravity * std::sin(kSlope), 0.0, -kGravity * std::cos(kSlope)};
  c.density = DensityMode::Continuity;
  c.smoothing = 0.1;
  c.viscosity = viscosity;
  c.domainMin = {-1.0, -0.2, -0.2};
  c.domainMax = {4.0, 1.2, 2.0};
  c.walls.planes = {
      {{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 0}, {0, 1, 0}, {}, 0}, {{0, 1, 0}, {0, -1, 0}, {}, 0}};
  c.materials.resize(2);
  for (FlowMaterialConfig& m : c.materials) m.soundSpeed = sound;
  c.materials[0].restDensity = 999.8;
  c.materials[0].rheology.viscosity = 1.79e-3f;
  c.materials[1].restDensity = 400.0;
  Rheology& r = c.materials[1].rheology;
  r.law = RheologyLaw::Cross;
  r.viscosity = static_cast<float>(atCap ? cap : 100.0);
  r.viscosityAtSpeed = static_cast<float>(atCap ? cap : 1.0);
  r.crossFactor = 3000.0f;
  r.exponent = 2.0f;
  r.least = 1.0f;
  r.most = static_cast<float>(cap);
  made.particles = flowLattice(c, kAlong, 2 * kAcross, kLayers, {}, 0.0);
  for (FlowParticle& p : made.particles) p.material = p.position.y > 0.5 ? 1 : 0;
  // Only the step that is asked for counts.
  c.courant = c.forceFactor = c.viscousFactor = 1.0;
  return made;
}

/// Kinetic and potential energy by mass, J; mean of what is too dense.
struct Health {
  double energy = 0.0, compression = 0.0;
};
Health healthOf(const FlowSolver& solver, const FlowConfig& c) {
  Health health;
  for (const FlowSample& s : solver.samples()) {
    const FlowParticle& p = s.particle;
    health.energy +=
        c.particleMass(p.material) * (0.5 * dot(p.velocity, p.velocity) - dot(c.gravity, p.position));
    health.compression += std::max(s.density / c.materials[p.material].restDensity - 1.0, 0.0);
  }
  health.compression /= std::max(static_cast<double>(solver.count()), 1.0);
  return health;
}

/// Whether steps of just this length carry the fluids through `seconds`: all states are finite, no step had
/// to be shortened, energy never gains a hundredth of what the fall frees, the mean compression stays below a
/// tenth.
bool holds(const TwoFluids& fluids, double stepSeconds, double seconds, const BenchOptions& options) {
  auto solver = startFlow(fluids.config, fluids.particles, options);
  if (!solver) return false;
  const double start = healthOf(**solver, fluids.config).energy;
  double freed = 0.0;
  for (const FlowParticle& p : fluids.particles)
    freed += fluids.config.particleMass(p.material) * 0.5 * std::pow(fluids.config.gravity.x * seconds, 2);
  const int steps = static_cast<int>(std::ceil(seconds / kMoments / stepSeconds));
  for (int k = 0; k < kMoments; ++k) {
    for (int s = 0; s < steps; ++s) {
      const Result<FlowStep> done = (*solver)->step(stepSeconds);
      if (!done || done->limit != StepLimit::Asked) return false;
    }
    const Health now = healthOf(**solver, fluids.config);
    if (!(now.energy <= start + kMostGain * freed) || !(now.compression <= kMostCompression)) return false;
  }
  return true;
}

Result<BenchRow> measure(const BenchOptions& options, double sound, double cap, bool atCap,
                         ViscosityMode viscosity, double published) {
  const BenchMeter meter;
  const TwoFluids fluids = twoFluids(sound, cap, atCap, viscosity);
  const double seconds = options.quick ? 0.1 : 0.3;
  BenchRow row;
  row.settings["sound"] = fmt::format("{:g} m/s", sound);
  row.settings["cap"] = fmt::format("{:g} Pa s", cap);
  row.settings["fluid"] = atCap ? "at the cap" : "Cross";
  row.settings["viscosity"] = viscosity == ViscosityMode::Implicit ? "implicit" : "pairwise";
  double low = kShortest, high = fluids.config.spacing / sound;
  if (!holds(fluids, low, seconds, options))
    return Error{ErrorKind::Failed, "The longest step was not found", row.settings["fluid"],
                 fmt::format("not even {:g} s is stable", low), "Look at the case"};
  while (high / low > kPrecision) {
    const double middle = std::sqrt(low * high);
    (holds(fluids, middle, seconds, options) ? low : high) = middle;
  }
  row.addFigure("longest_step", low, "s");
  row.addFigure("published_step", published, "s");
  const double nu = cap / fluids.config.materials[1].restDensity;
  row.addFigure("viscous_number", nu * low / (fluids.config.spacing * fluids.config.spacing), "1");
  row.addFigure("courant", sound * low / fluids.config.spacing, "1");
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  // As the scene has it, and so soft that the viscosity can bind the step.
  const std::vector<double> sounds = options.quick ? std::vector{26.6} : std::vector{26.6, 10.0};
  const std::pair<double, double> caps[] = {{100.0, 1e-3}, {300.0, 5e-4}};
  for (const double sound : sounds)
    for (const auto& [cap, published] : caps)
      for (const bool atCap : {false, true})
        for (const ViscosityMode viscosity : {ViscosityMode::Pairwise, ViscosityMode::Implicit}) {
          if (options.quick && viscosity == ViscosityMode::Implicit) continue;
          Result<BenchRow> row = measure(options, sound, cap, atCap, viscosity, published);
          if (!row) return row.error();
          rows.push_back(std::move(*row));
        }
  return rows;
}

}  // namespace

BenchCase twoFluidsStepCase() {
  return {"two-fluids-step", "longest fixed step of water beside a Cross fluid, by the cap of its viscosity",
          "a thesis of Zhejiang University on large snow scenes and avalanches", run};
}

}  // namespace spin
