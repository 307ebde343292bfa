// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/longest_step.h"

#include <algorithm>
#include <cmath>

#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kShortest = 0.1, kLongest = 1.0, kPrecision = 1.03;
constexpr double kMostCompression = 0.02, kMostGain = 0.01;
constexpr int kMoments = 20;

struct Health {
  double energy = 0.0, compression = 0.0;  ///< m2/s2 against z = 0, summed; mean of what is too dense
};

Health healthOf(const FlowSolver& solver, const FlowConfig& c) {
  Health health;
  for (const FlowSample& s : solver.samples()) {
    const FlowParticle& p = s.particle;
    health.energy += 0.5 * dot(p.velocity, p.velocity) - dot(c.gravity, p.position);
    health.compression += std::max(s.density / c.materials[p.material].restDensity - 1.0, 0.0);
  }
  health.compression /= std::max(static_cast<double>(solver.count()), 1.0);
  return health;
}

/// The worst that a run comes to.
Result<Health> worstOf(const FlowConfig& config, const std::vector<FlowParticle>& particles, double seconds,
                       const BenchOptions& options) {
  auto solver = startFlow(config, particles, options);
  if (!solver) return solver.error();
  Health worst = healthOf(**solver, config);
  for (int k = 0; k < kMoments; ++k) {
    if (const Result<int> steps = runFlow(**solver, seconds / kMoments); !steps) return steps.error();
    // What is thrown out takes its energy along.
    if ((*solver)->samples().size() < particles.size())
      return Error{ErrorKind::Failed, "The step is too long", "state equation", "particles left the domain",
                   "Take a shorter one"};
    const Health now = healthOf(**solver, config);
    worst = {worse(worst.energy, now.energy), worse(worst.compression, now.compression)};
  }
  return worst;
}

}  // namespace

Result<double> longestCourant(FlowConfig config, const std::vector<FlowParticle>& particles, double seconds,
                              const BenchOptions& options) {
  const auto runAt = [&](double courant) {
    config.courant = courant;
    // What else binds the step would hide what sound does.
    config.forceFactor = courant;
    return worstOf(config, particles, seconds, options);
  };
  const Result<Health> reference = runAt(kShortest);
  if (!reference) return reference.error();
  const auto holds = [&](double courant) {
    const Result<Health> worst = runAt(courant);
    return worst && worst->energy <= reference->energy + kMostGain * std::abs(reference->energy) &&
           worst->compression <= kMostCompression;
  };
  if (holds(kLongest)) return kLongest;
  double low = kShortest, high = kLongest;
  while (high / low > kPrecision) {
    const double middle = std::sqrt(low * high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace spin
