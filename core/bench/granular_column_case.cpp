// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kRadius = 0.1,
                 kFriction = 0.404;  // m/s2, m, tan 22 degrees (glass beads)

FlowConfig columnConfig(double spacing, double height) {
  FlowConfig c;
  c.spacing = spacing;
  c.density = DensityMode::Continuity;
  const double edge = 4.0 * spacing;
  c.domainMin = {-edge, -edge, -edge};
  c.domainMax = {6.0 * kRadius, 6.0 * kRadius, height + 4.0 * edge};
  FlowMaterialConfig& m = c.materials[0];
  m.restDensity = 1600.0;
  m.soundSpeed = 12.0 * std::sqrt(2.0 * kGravity * height);
  m.rheology.law = RheologyLaw::Yield;
  m.rheology.viscosity = 1.0f;
  m.rheology.frictionTangent = static_cast<float>(kFriction);
  m.rheology.regularisation = 1000.0f;
  m.rheology.most = 2e3f;
  c.viscosity = ViscosityMode::Auto;
  // A quarter of the column between two planes of symmetry.
  // The bed is as rough as the grains: those that touch it rest.
  c.walls.surfaces = {{WallFriction::NoSlip, 0.0f}, {WallFriction::FreeSlip, 0.0f}};
  c.walls.planes = {
      {{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 0}, {1, 0, 0}, {}, 1}, {{0, 0, 0}, {0, 1, 0}, {}, 1}};
  return c;
}

/// Radius that holds all but what has bounced away: 99.7 % of the mass.
double radiusOf(const std::vector<FlowSample>& samples, double spacing) {
  std::vector<double> r;
  r.reserve(samples.size());
  for (const FlowSample& s : samples) r.push_back(std::hypot(s.particle.position.x, s.particle.position.y));
  const auto at = r.begin() + static_cast<std::ptrdiff_t>(0.997 * static_cast<double>(r.size()));
  std::nth_element(r.begin(), at, r.end());
  return *at + 0.5 * spacing;
}

/// Lube et al. 2004: spread over the radius by the aspect ratio.
double measuredSpread(double aspect) {
  return aspect < 1.7 ? 1.24 * aspect : 1.6 * std::sqrt(aspect);
}

Result<BenchRow> measure(const BenchOptions& options, double aspect, int across, double& spread) {
  BenchRow row;
  row.caseId = "granular-column";
  row.settings = {{"aspect", fmt::format("{:g}", aspect)}, {"radius", fmt::format("{} spacings", across)}};
  const BenchMeter meter;
  const double spacing = kRadius / across, height = aspect * kRadius;
  const FlowConfig c = columnConfig(spacing, height);
  const int layers = static_cast<int>(std::lround(height / spacing));
  auto particles = flowLattice(c, across, across, layers, {}, 0.0);
  std::erase_if(particles,
                [](const FlowParticle& p) { return std::hypot(p.position.x, p.position.y) > kRadius; });
  for (FlowParticle& p : particles)
    p.excess = kGravity * (height - p.position.z) / std::pow(c.materials[0].soundSpeed, 2);
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  // At rest after 3 sqrt(h/g) and more (Lube et al. 2004).
  const double seconds = 3.3 * std::sqrt(height / kGravity) + 0.1;
  if (const Result<int> steps = runFlow(**solver, seconds); !steps) return steps.error();
  const auto samples = (*solver)->samples();
  spread = radiusOf(samples, spacing) / kRadius - 1.0;
  double squares = 0.0;
  for (const FlowSample& s : samples) squares += dot(s.particle.velocity, s.particle.velocity);
  row.addError("spread_error", std::abs(spread / measuredSpread(aspect) - 1.0), "1", 0.15);
  row.addFigure("spread", spread, "R0");
  row.addFigure("spread_measured", measuredSpread(aspect), "R0");
  row.addFigure("speed_at_end",
                std::sqrt(squares / static_cast<double>(samples.size()) / (kGravity * height)), "sqrt(g h)");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / seconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

/// Slope of log spread over log aspect between two columns.
void addExponent(const char* name, double from, double to, double spreadFrom, double spreadTo, double exact,
                 BenchRow& row) {
  const double exponent = std::log(spreadTo / spreadFrom) / std::log(to / from);
  row.addError(name, std::abs(exponent - exact), "1", 0.1);
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const std::vector<double> aspects =
      options.quick ? std::vector<double>{1.0} : std::vector<double>{0.6, 1.2, 2.5, 5.0};
  std::vector<double> spreads;
  for (const double aspect : aspects) {
    double spread = 0.0;
    Result<BenchRow> row = measure(options, aspect, options.quick ? 10 : 14, spread);
    if (!row) return row.error();
    spreads.push_back(spread);
    rows.push_back(std::move(*row));
  }
  if (options.quick) return rows;
  addExponent("exponent_error_low", aspects[0], aspects[1], spreads[0], spreads[1], 1.0, rows.back());
  addExponent("exponent_error_high", aspects[2], aspects[3], spreads[2], spreads[3], 0.5, rows.back());
  return rows;
}

}  // namespace

BenchCase granularColumnCase() {
  return {"granular-column", "how far a column of grains spreads", "Lube et al. 2004", run};
}

}  // namespace spin
