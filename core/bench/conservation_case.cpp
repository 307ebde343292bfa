// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kSpacing = 0.05;

const char* nameOf(DensityMode mode) {
  return mode == DensityMode::Continuity ? "continuity" : "summation";
}

/// Two fluids stirred in a periodic box without gravity: sums in double.
Result<BenchRow> measureMomentum(const BenchOptions& options, DensityMode density, int steps) {
  BenchRow row;
  row.caseId = "conservation";
  row.settings = {{"measured", "momentum"}, {"density", nameOf(density)}, {"steps", std::to_string(steps)}};
  const BenchMeter meter;
  const int n = 20;
  FlowConfig c;
  c.spacing = kSpacing;
  c.gravity = {};
  c.density = density;
  c.smoothing = 0.1;
  c.domainMax = {n * kSpacing, n * kSpacing, n * kSpacing};
  c.periodic[0] = c.periodic[1] = c.periodic[2] = true;
  c.materials[0].soundSpeed = 10.0;
  c.materials[0].rheology.viscosity = 2.0f;
  c.materials.push_back(c.materials[0]);
  c.materials[1].restDensity = 300.0;
  auto particles = flowLattice(c, n, n, n, {}, 0.2);
  const CounterRandom random{4, 9};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto draw = [&](std::uint32_t d) { return 2.0 * random.uniformDouble(i, d) - 1.0; };
    particles[i].velocity = {draw(0), draw(1), draw(2)};
    particles[i].material = i % 3 == 0 ? 1 : 0;
  }
  Vec3d before{}, after{};
  double size = 0.0;
  for (const FlowParticle& p : particles) {
    before += p.velocity * c.particleMass(p.material);
    size += length(p.velocity) * c.particleMass(p.material);
  }
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  for (int k = 0; k < steps; ++k)
    if (const Result<FlowStep> done = (*solver)->step(1.0); !done) return done.error();
  const auto samples = (*solver)->samples();
  for (const FlowSample& s : samples) after += s.particle.velocity * c.particleMass(s.particle.material);
  row.addError("momentum_change", length(after - before) / size, "of sum m |v|", 1e-6);
  row.addError("particles_lost", static_cast<double>(particles.size() - samples.size()), "1", 0.0);
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

/// Kinetic, potential and elastic energy (of the linear state equation) per mass, J/kg.
double energyOf(const std::vector<FlowSample>& samples, double sound) {
  double sum = 0.0;
  for (const FlowSample& s : samples) {
    const double e = std::max(s.density / 1000.0 - 1.0, 0.0);
    sum += 0.5 * dot(s.particle.velocity, s.particle.velocity) + kGravity * s.particle.position.z +
           sound * sound * (std::log1p(e) - e / (1.0 + e));
  }
  return sum / static_cast<double>(samples.size());
}

/// Water that sloshes in a closed tank.
Result<BenchRow> measureSloshing(const BenchOptions& options, DensityMode density, int steps) {
  BenchRow row;
  row.caseId = "conservation";
  row.settings = {{"measured", "sloshing"}, {"density", nameOf(density)}, {"steps", std::to_string(steps)}};
  const BenchMeter meter;
  FlowConfig c;
  c.spacing = kSpacing;
  c.density = density;
  c.periodic[1] = true;
  const int across = 24, layers = 12, width = slabWidth(c.supportSpacings);
  const double tank = across * kSpacing;
  c.domainMin = {-0.2, 0, -0.2};
  c.domainMax = {tank + 0.2, width * kSpacing, 2.0};
  c.walls.surfaces = {{WallFriction::FreeSlip, 0.0f}};
  c.walls.planes = {{}, {{0, 0, 0}, {1, 0, 0}, {}, 0}, {{tank, 0, 0}, {-1, 0, 0}, {}, 0}};
  c.materials[0].soundSpeed = 25.0;
  c.materials[0].rheology.viscosity = 1.0f;
  auto particles = flowLattice(c, across, width, layers, {}, 0.05);
  for (FlowParticle& p : particles) p.velocity.x = 0.8;
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  if (const Result<FlowStep> done = (*solver)->step(1e-9); !done) return done.error();
  const double start = energyOf((*solver)->samples(), c.materials[0].soundSpeed);
  double most = 0.0, last = 0.0;
  for (int k = 0; k < steps; ++k) {
    if (const Result<FlowStep> done = (*solver)->step(1.0); !done) return done.error();
    if (k % 200 != 199) continue;
    last = energyOf((*solver)->samples(), c.materials[0].soundSpeed) / start;
    most = worse(most, last);
  }
  row.addError("energy_gain", std::max(most - 1.0, 0.0), "of the start's", 0.001);
  row.addFigure("energy_at_end", last, "of the start's");
  row.addError("particles_lost", static_cast<double>(particles.size() - (*solver)->samples().size()), "1",
               0.0);
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const DensityMode density : {DensityMode::Continuity, DensityMode::Summation}) {
    Result<BenchRow> row = measureMomentum(options, density, options.quick ? 300 : 10000);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  Result<BenchRow> row = measureSloshing(options, DensityMode::Continuity, options.quick ? 4000 : 100000);
  if (!row) return row.error();
  rows.push_back(std::move(*row));
  return rows;
}

}  // namespace

BenchCase conservationCase() {
  return {"conservation", "momentum in a periodic box; energy and mass of sloshing water", "conserved", run};
}

}  // namespace spin
