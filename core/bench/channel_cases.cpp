// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_trials.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kDensity = 1000.0, kHalf = 0.5;  // kg/m3, m
constexpr double kPush = 4000.0;                  // Pa/m

/// Flow between plates at z = 0 and 1 m, along x: what drives it and what is known of it.
struct Channel {
  std::string id;
  Rheology rheology;
  double push = kPush;        ///< Pa/m
  double plateSpeed = 0.0;    ///< of the upper plate, m/s
  double fastest = 1.0;       ///< m/s
  double startShare = 0.9;    ///< of the exact speed at the start; 0 = from rest
  std::vector<double> marks;  ///< times at which the profile is compared, s
  std::function<double(double z, double t)> exact;
  double plug = 0.0;  ///< half width of the part that moves as one, m
};

FlowConfig channelConfig(const Channel& channel, const FlowTrial& trial) {
  const FlowMode& mode = trial.mode;
  const int across = trial.across;
  const int width = slabWidth(mode.supportSpacings);
  FlowConfig c;
  c.spacing = 2.0 * kHalf / across;
  c.supportSpacings = mode.supportSpacings;
  c.domainMin = {0, 0, -0.3};
  c.domainMax = {width * c.spacing, width * c.spacing, 1.3};
  c.periodic[0] = c.periodic[1] = true;
  c.density = trial.density;
  c.courant = trial.courant;
  c.pressure = trial.pressure;
  c.clampTension = false;
  c.gravity = {channel.push / kDensity, 0, 0};
  c.materials[0].restDensity = kDensity;
  c.materials[0].soundSpeed = 15.0 * channel.fastest;
  c.materials[0].rheology = channel.rheology;
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0}, {{0, 0, 1}, {0, 0, -1}, {channel.plateSpeed, 0, 0}, 0}};
  return c;
}

struct ProfileErrors {
  double l2 = 0.0, plug = 0.0;
};

ProfileErrors errorsOf(const Channel& channel, const FlowSolver& solver, double t) {
  double squares = 0.0, scale = 0.0, plug = 0.0;
  int inPlug = 0;
  for (const FlowSample& s : solver.samples()) {
    const double z = s.particle.position.z, exact = channel.exact(z, t), u = s.particle.velocity.x;
    squares += (u - exact) * (u - exact);
    scale += exact * exact;
    if (std::abs(z - kHalf) < 0.7 * channel.plug) plug += u, ++inPlug;
  }
  return {std::sqrt(squares / scale),
          inPlug > 0 ? std::abs(plug / inPlug / channel.exact(kHalf, t) - 1.0) : 0.0};
}

Result<BenchRow> measure(const BenchOptions& options, const Channel& channel, const FlowTrial& trial,
                         double bar) {
  const FlowMode& mode = trial.mode;
  const int across = trial.across;
  BenchRow row;
  row.caseId = channel.id;
  describe(trial, row);
  const BenchMeter meter;
  const FlowConfig c = channelConfig(channel, trial);
  const int width = slabWidth(mode.supportSpacings);
  // A perfect lattice keeps its rows, which no flow outside a channel does.
  auto particles = flowLattice(c, width, width, across, {}, 0.1);
  for (FlowParticle& p : particles) p.velocity.x = channel.startShare * channel.exact(p.position.z, 0.0);
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  double t = 0.0, largest = 0.0;
  ProfileErrors last;
  int steps = 0;
  for (const double mark : channel.marks) {
    const Result<int> done = runFlow(**solver, mark - t);
    if (!done) return done.error();
    steps += *done;
    t = mark;
    last = errorsOf(channel, **solver, t);
    largest = worse(largest, last.l2);
  }
  row.addError("profile_l2", last.l2, "1", bar);
  if (channel.marks.size() > 1) row.addFigure("profile_l2_worst_time", largest, "1");
  if (channel.plug > 0.0)
    row.addError("plug_speed_error", last.plug, "1", mode.supportSpacings > 2.5 ? 0.02 : 0.04);
  row.addFigure("steps", steps, "1");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / t, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> runChannel(const BenchOptions& options, Channel channel, double accurateBar,
                                         double fastBar) {
  if (options.quick && channel.startShare > 0.0) {
    // Short: whether the exact profile stays; the full run lets it arise.
    channel.startShare = 1.0;
    channel.marks = {0.05};
  }
  std::vector<BenchRow> rows;
  const std::vector<int> across = options.quick ? std::vector<int>{20} : std::vector<int>{20, 40};
  for (const int n : across)
    for (const FlowMode& mode : {kFastMode, kAccurateMode}) {
      if (options.quick && mode.supportSpacings > 2.5) continue;
      FlowTrial trial;
      trial.mode = mode;
      trial.across = n;
      Result<BenchRow> row =
          measure(options, channel, trial, mode.supportSpacings > 2.5 ? accurateBar : fastBar);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  return rows;
}

/// Start-up between plates at rest (Morris et al. 1997): the parabola less its decaying modes.
Channel poiseuille() {
  Channel channel;
  channel.id = "poiseuille";
  channel.rheology.viscosity = 1000.0f;  // 1 m2/s
  channel.push = 8000.0;
  channel.startShare = 0.0;
  channel.marks = {0.02, 0.05, 0.1, 0.2, 0.6};
  channel.exact = [](double z, double t) {
    double u = 4.0 * z * (1.0 - z);
    for (int m = 1; m < 120; m += 2)
      u -= 32.0 / (m * m * m * kPi * kPi * kPi) * std::sin(m * kPi * z) * std::exp(-m * m * kPi * kPi * t);
    return u;
  };
  return channel;
}

/// The upper plate starts to slide at 1 m/s.
Channel couette() {
  Channel channel;
  channel.id = "couette";
  channel.rheology.viscosity = 1000.0f;
  channel.push = 0.0;
  channel.plateSpeed = 1.0;
  channel.startShare = 0.0;
  channel.marks = {0.05, 0.1, 0.2, 0.6};
  channel.exact = [](double z, double t) {
    double u = z;
    for (int k = 1; k < 120; ++k)
      u += 2.0 / (k * kPi) * (k % 2 ? -1.0 : 1.0) * std::exp(-k * k * kPi * kPi * t) * std::sin(k * kPi * z);
    return u;
  };
  return channel;
}

/// Herschel-Bulkley: K [Pa s^n], n, yield stress [Pa]; a power law without yield and Bingham with n = 1 are
/// cases of it.
Channel yieldChannel(const char* id, double consistency, double n, double yield, double most) {
  Channel channel;
  channel.id = id;
  Rheology& r = channel.rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = static_cast<float>(consistency);
  r.exponent = static_cast<float>(n);
  r.cohesion = static_cast<float>(yield);
  r.most = static_cast<float>(most);
  const double e = (n + 1.0) / n;
  channel.exact = [=](double z, double) {
    const double y = std::abs(z - kHalf), excess = std::max(kPush * y - yield, 0.0);
    return n / ((n + 1.0) * kPush) * std::pow(consistency, -1.0 / n) *
           (std::pow(kPush * kHalf - yield, e) - std::pow(excess, e));
  };
  channel.fastest = channel.exact(kHalf, 0.0);
  channel.plug = yield / kPush;
  channel.marks = {0.5};
  return channel;
}

/// Cross with n = 1, where the flow curve is monotone: the profile by integration of the shear rate that
/// carries each stress.
Channel crossChannel() {
  constexpr double kRest = 2000.0, kSpeed = 200.0, kFactor = 1.0;
  Channel channel;
  channel.id = "channel-cross";
  Rheology& r = channel.rheology;
  r.law = RheologyLaw::Cross;
  r.viscosity = static_cast<float>(kRest);
  r.viscosityAtSpeed = static_cast<float>(kSpeed);
  r.crossFactor = static_cast<float>(kFactor);
  // (mu_inf + (mu_0 - mu_inf) / (1 + K g)) g = s is a quadratic in g.
  const auto rate = [](double stress) {
    const double a = kSpeed * kFactor, b = kRest - stress * kFactor;
    return (-b + std::sqrt(b * b + 4.0 * a * stress)) / (2.0 * a);
  };
  channel.exact = [rate](double z, double) {
    constexpr int kParts = 400;
    const double from = std::abs(z - kHalf), part = (kHalf - from) / kParts;
    double u = 0.0;
    for (int k = 0; k < kParts; ++k) u += rate(kPush * (from + (k + 0.5) * part)) * part;
    return u;
  };
  channel.fastest = channel.exact(kHalf, 0.0);
  channel.marks = {1.2};
  return channel;
}

Result<std::vector<BenchRow>> runPoiseuille(const BenchOptions& options) {
  return runChannel(options, poiseuille(), 0.01, 0.025);
}
Result<std::vector<BenchRow>> runCouette(const BenchOptions& options) {
  return runChannel(options, couette(), 0.01, 0.025);
}
Result<std::vector<BenchRow>> runPower(const BenchOptions& options) {
  return runChannel(options, yieldChannel("channel-power", 1000.0, 0.5, 0.0, 2e4), 0.015, 0.03);
}
Result<std::vector<BenchRow>> runBingham(const BenchOptions& options) {
  return runChannel(options, yieldChannel("channel-bingham", 1000.0, 1.0, 500.0, 5e4), 0.015, 0.03);
}
Result<std::vector<BenchRow>> runHerschel(const BenchOptions& options) {
  return runChannel(options, yieldChannel("channel-herschel", 1000.0, 0.7, 500.0, 5e4), 0.015, 0.05);
}
Result<std::vector<BenchRow>> runCross(const BenchOptions& options) {
  return runChannel(options, crossChannel(), 0.015, 0.03);
}

}  // namespace

Result<BenchRow> poiseuilleTrial(const BenchOptions& options, const FlowTrial& trial) {
  return measure(options, poiseuille(), trial, trial.mode.supportSpacings > 2.5 ? 0.01 : 0.025);
}

BenchCase poiseuilleCase() {
  return {"poiseuille", "start-up and steady profile between plates", "series of Morris et al. 1997",
          runPoiseuille};
}
BenchCase couetteCase() {
  return {"couette", "start-up and steady profile under a sliding plate", "series of Morris et al. 1997",
          runCouette};
}
BenchCase channelPowerCase() {
  return {"channel-power", "profile of a power-law fluid between plates", "closed form", runPower};
}
BenchCase channelBinghamCase() {
  return {"channel-bingham", "profile and plug of a Bingham fluid between plates", "closed form", runBingham};
}
BenchCase channelHerschelCase() {
  return {"channel-herschel", "profile and plug of a Herschel-Bulkley fluid between plates", "closed form",
          runHerschel};
}
BenchCase channelCrossCase() {
  return {"channel-cross", "profile of a Cross fluid between plates", "integrated flow curve", runCross};
}

}  // namespace spin
