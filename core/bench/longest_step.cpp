// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/longest_step.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kMostCompression = 0.1, kMostGain = 0.01, kPrecision = 1.03;
constexpr int kMoments = 20;

struct Health {
  double energy = 0.0, compression = 0.0;
};

/// Energy per mass against the height of the domain's floor, m2/s2.
Health healthOf(const FlowSolver& solver, const FlowConfig& c) {
  Health health;
  for (const FlowSample& s : solver.samples()) {
    const FlowParticle& p = s.particle;
    health.energy += 0.5 * dot(p.velocity, p.velocity) - dot(c.gravity, p.position);
    health.compression = std::max(health.compression, s.density / c.materials[p.material].restDensity - 1.0);
  }
  return health;
}

bool carries(const FlowConfig& config, const std::vector<FlowParticle>& particles, double seconds,
             const BenchOptions& options) {
  auto solver = startFlow(config, particles, options);
  if (!solver) return false;
  const double start = healthOf(**solver, config).energy;
  for (int k = 0; k < kMoments; ++k) {
    if (!runFlow(**solver, seconds / kMoments)) return false;
    const Health now = healthOf(**solver, config);
    if (!(now.energy <= start + kMostGain * std::abs(start)) || !(now.compression <= kMostCompression))
      return false;
  }
  return true;
}

}  // namespace

Result<double> longestCourant(FlowConfig config, const std::vector<FlowParticle>& particles, double seconds,
                              const BenchOptions& options) {
  const auto holds = [&](double courant) {
    config.courant = courant;
    // What else binds the step would hide what sound does.
    config.forceFactor = courant;
    return carries(config, particles, seconds, options);
  };
  double low = 0.1, high = 1.0;
  if (holds(high)) return high;
  if (!holds(low))
    return Error{ErrorKind::Failed, "The longest step was not found", "state equation",
                 "not even a tenth of a spacing per step is stable", "Look at the scene"};
  while (high / low > kPrecision) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace spin
