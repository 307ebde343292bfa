// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kDensity = 1000.0, kYield = 100.0, kSide = 0.3;  // SI

/// One side of a square block that slumps on a bed it sticks to. It creeps on where it should rest, by stress
/// over the highest viscosity; the threshold of rest lies above that.
Result<BenchRow> measure(const BenchOptions& options, int layers, double most) {
  BenchRow row;
  row.caseId = "slump";
  row.settings = {{"layers", std::to_string(layers)}, {"most_viscosity", std::to_string(std::lround(most))}};
  const BenchMeter meter;
  FlowConfig c;
  c.spacing = kSide / layers;
  c.density = DensityMode::Continuity;
  const int width = slabWidth(c.supportSpacings);
  const double edge = 4.0 * c.spacing;
  c.domainMin = {-edge, 0, -edge};
  c.domainMax = {5.0 * kSide, width * c.spacing, 2.0 * kSide};
  c.periodic[1] = true;
  c.materials[0].soundSpeed = 15.0 * std::sqrt(kGravity * kSide);
  Rheology& r = c.materials[0].rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = 10.0f;
  r.cohesion = static_cast<float>(kYield);
  r.regularisation = 1000.0f;
  r.most = static_cast<float>(most);
  c.walls.surfaces = {{WallFriction::NoSlip, 0.0f}, {WallFriction::FreeSlip, 0.0f}};
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 0}, {1, 0, 0}, {}, 1}};
  auto particles = flowLattice(c, layers, width, layers, {}, 0.0);
  for (FlowParticle& p : particles)
    p.excess = kGravity * (kSide - p.position.z) / std::pow(c.materials[0].soundSpeed, 2);
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  const double rest = 0.01 * std::sqrt(kGravity * kSide), frame = 0.1;
  double t = 0.0, speed = 1.0, front = 0.0, top = 0.0;
  while (t < 4.0 && (speed > rest || t < 0.5)) {
    if (const Result<int> steps = runFlow(**solver, frame); !steps) return steps.error();
    t += frame;
    speed = front = top = 0.0;
    const auto samples = (*solver)->samples();
    for (const FlowSample& s : samples) {
      speed += dot(s.particle.velocity, s.particle.velocity) / static_cast<double>(samples.size());
      front = std::max(front, s.particle.position.x + 0.5 * c.spacing);
      top = std::max(top, s.particle.position.z + 0.5 * c.spacing);
    }
    speed = std::sqrt(speed);
  }
  const double area = kSide * kSide;
  const double exact = std::cbrt(9.0 * kDensity * kGravity * area * area / (8.0 * kYield));
  row.addError("front_error", std::abs(front / exact - 1.0), "1", 0.1);
  row.addFigure("front", front, "m");
  row.addFigure("front_exact", exact, "m");
  row.addFigure("height", top, "m");
  row.addFigure("height_exact", std::sqrt(2.0 * kYield * exact / (kDensity * kGravity)), "m");
  row.addError("speed_at_rest", speed / std::sqrt(kGravity * kSide), "sqrt(g H)", 0.01);
  row.addFigure("time_to_rest", t, "s");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / t, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int layers : options.quick ? std::vector<int>{12} : std::vector<int>{12, 24}) {
    Result<BenchRow> row = measure(options, layers, 1000.0);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase slumpCase() {
  return {"slump", "how far a yield-stress block slumps", "h^2 = 2 tau_y (xf - x)/(rho g)", run};
}

}  // namespace spin
