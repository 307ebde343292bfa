// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/dam_break.h"

#include <algorithm>
#include <cmath>

#include "core/bench/bench_meter.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kWidth = 1.0, kDepth = 2.0;

FlowConfig columnConfig(const FlowTrial& setting) {
  FlowConfig c;
  c.spacing = kWidth / setting.across;
  c.supportSpacings = setting.mode.supportSpacings;
  c.density = setting.density;
  c.courant = setting.courant;
  c.pressure = setting.pressure;
  const double edge = 4.0 * c.spacing;
  c.domainMin = {-edge, 0, -edge};
  c.domainMax = {6.0, slabWidth(c.supportSpacings) * c.spacing, kDepth + 1.0};
  c.periodic[1] = true;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(2.0 * kGravity * kDepth);
  // Artificial viscosity of alpha = 0.02 (Monaghan 1992: nu = alpha c h / 10).
  c.materials[0].rheology.viscosity = static_cast<float>(2.0 * c.materials[0].soundSpeed * c.spacing);
  c.walls.surfaces = {{setting.floor, 0.0f}, {WallFriction::FreeSlip, 0.0f}};
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 0}, {1, 0, 0}, {}, 1}};
  return c;
}

/// What lies ahead of the front in one row across is spray: the front is where a whole row has come.
double frontOf(const std::vector<FlowSample>& samples, int row, double spacing) {
  std::vector<double> x;
  x.reserve(samples.size());
  for (const FlowSample& s : samples) x.push_back(s.particle.position.x);
  const auto at = x.end() - row;
  std::nth_element(x.begin(), at, x.end());
  return *at + 0.5 * spacing;
}

double energyOf(const std::vector<FlowSample>& samples) {
  double sum = 0.0;
  for (const FlowSample& s : samples)
    sum += 0.5 * dot(s.particle.velocity, s.particle.velocity) + kGravity * s.particle.position.z;
  return sum;
}

double positionAt(const std::vector<FrontPoint>& front, double t) {
  const auto after =
      std::find_if(front.begin() + 1, front.end() - 1, [&](const FrontPoint& p) { return p.t >= t; });
  const FrontPoint &a = *(after - 1), &b = *after;
  return std::max(front.front().x, a.x + (t - a.t) / (b.t - a.t) * (b.x - a.x));
}

}  // namespace

Result<std::vector<FlowParticle>> settled(FlowConfig config, std::vector<FlowParticle> particles,
                                          double depth, double seconds, const BenchOptions& options) {
  const double viscosity =
      0.1 * config.materials[0].restDensity * std::sqrt(length(config.gravity) * depth) * depth;
  config.materials[0].rheology.viscosity = static_cast<float>(viscosity);
  auto solver = startFlow(config, particles, options);
  if (!solver) return solver.error();
  if (const Result<int> steps = runFlow(**solver, seconds); !steps) return steps.error();
  const std::vector<FlowSample> samples = (*solver)->samples();
  particles.clear();
  for (const FlowSample& s : samples) {
    particles.push_back(s.particle);
    particles.back().velocity = {};
  }
  return particles;
}

Result<DamFront> runDamFront(const BenchOptions& options, const FlowTrial& setting) {
  const FlowConfig c = columnConfig(setting);
  const int row = slabWidth(c.supportSpacings);
  auto particles = flowLattice(c, setting.across, row, 2 * setting.across, {}, 0.1);
  if (setting.density == DensityMode::Summation) {
    FlowConfig closed = c;
    closed.walls.planes.push_back({{kWidth, 0, 0}, {-1, 0, 0}, {}, 1});
    auto rest = settled(closed, particles, kDepth, 4.0 * std::sqrt(kDepth / kGravity), options);
    if (!rest) return rest.error();
    particles = std::move(*rest);
  }
  const BenchMeter meter;
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  DamFront result;
  result.device = (*solver)->device();
  constexpr double kFrame = 0.01;
  constexpr int kFrames = 80;
  double start = 0.0;
  for (int k = 0;; ++k) {
    const auto samples = (*solver)->samples();
    result.front.push_back({k * kFrame, frontOf(samples, row, c.spacing)});
    result.energy = energyOf(samples);
    if (k == 0) start = result.energy;
    if (k == kFrames) break;
    if (const Result<int> steps = runFlow(**solver, kFrame); !steps) return steps.error();
  }
  result.energy /= start;
  result.seconds = meter.seconds() / (kFrames * kFrame);
  return result;
}

double frontError(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& measured,
                  double shift) {
  double squares = 0.0, scale = 0.0;
  for (const FrontPoint& p : measured) {
    const double error = positionAt(front, p.t - shift) - p.x;
    squares += error * error;
    scale += p.x * p.x;
  }
  return std::sqrt(squares / scale);
}

double shiftedFrontError(const std::vector<FrontPoint>& front, const std::vector<FrontPoint>& measured,
                         double& shift) {
  shift = 0.0;
  double least = frontError(front, measured, 0.0);
  for (int k = -100; k <= 100; ++k) {
    const double error = frontError(front, measured, 0.001 * k);
    if (error < least) least = error, shift = 0.001 * k;
  }
  return least;
}

std::vector<FrontPoint> koshizukaOkaFront() {
  return {std::begin(kKoshizukaOkaFront), std::end(kKoshizukaOkaFront)};
}

std::vector<FrontPoint> martinMoyceFront(bool narrow) {
  const double second = std::sqrt(2.0 * kGravity / kWidth);
  std::vector<FrontPoint> points;
  const auto take = [&](const FrontPoint& p) {
    if (p.x <= 4.2) points.push_back({p.t / second, p.x * kWidth});
  };
  if (narrow)
    for (const FrontPoint& p : kMartinMoyceNarrowFront) take(p);
  else
    for (const FrontPoint& p : kMartinMoyceFront) take(p);
  return points;
}

}  // namespace spin
