// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kDensity = 1000.0, kDepth = 1.0;  // m/s2, kg/m3, m

/// A layer with a free surface that runs down a slope: what is known of it.
struct Film {
  std::string id;
  Rheology rheology;
  double tangent = 0.25;                ///< of the slope
  std::function<double(double)> exact;  ///< speed at height z above the bed, m/s
  double bar = 0.03;
};

/// Gravity down the slope and on to it, where z is normal to the bed.
Vec3d gravityOn(double tangent) {
  const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
  return {kGravity * tangent * cosine, 0.0, -kGravity * cosine};
}

FlowConfig filmConfig(const Film& film, const FlowMode& mode, int layers) {
  const int width = slabWidth(mode.supportSpacings);
  FlowConfig c;
  c.spacing = kDepth / layers;
  c.supportSpacings = mode.supportSpacings;
  c.density = DensityMode::Continuity;
  c.domainMin = {0, 0, -4.0 * c.spacing};
  c.domainMax = {width * c.spacing, width * c.spacing, 1.5 * kDepth};
  c.periodic[0] = c.periodic[1] = true;
  c.gravity = gravityOn(film.tangent);
  c.materials[0].restDensity = kDensity;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(kGravity * kDepth);
  c.materials[0].rheology = film.rheology;
  c.walls.planes = {{}};
  return c;
}

/// At rest across the layer, along it `share` of the exact speed.
std::vector<FlowParticle> filmParticles(const FlowConfig& c, const Film& film, int layers, double share) {
  const int width = slabWidth(c.supportSpacings);
  auto particles = flowLattice(c, width, width, layers, {}, 0.0);
  const double sound = c.materials[0].soundSpeed;
  for (FlowParticle& p : particles) {
    if (share > 0.0) p.velocity.x = share * film.exact(p.position.z);
    p.excess = -c.gravity.z * (kDepth - p.position.z) / (sound * sound);
  }
  return particles;
}

/// Mean speed of the upper two layers.
double surfaceSpeed(const FlowSolver& solver, double spacing) {
  double sum = 0.0;
  int counted = 0;
  for (const FlowSample& s : solver.samples())
    if (s.particle.position.z > kDepth - 2.0 * spacing) sum += s.particle.velocity.x, ++counted;
  return sum / counted;
}

Result<BenchRow> measureProfile(const BenchOptions& options, const Film& film, const FlowMode& mode,
                                int layers) {
  BenchRow row;
  row.caseId = film.id;
  row.settings = {{"measured", "profile"}, {"mode", mode.id}, {"layers", std::to_string(layers)}};
  const BenchMeter meter;
  const FlowConfig c = filmConfig(film, mode, layers);
  auto solver = startFlow(c, filmParticles(c, film, layers, options.quick ? 1.0 : 0.9), options);
  if (!solver) return solver.error();
  // From nine tenths, what is missing halves about once a second.
  const double seconds = options.quick ? 0.05 : 5.0;
  const Result<int> steps = runFlow(**solver, seconds);
  if (!steps) return steps.error();
  double squares = 0.0, scale = 0.0;
  for (const FlowSample& s : (*solver)->samples()) {
    const double exact = film.exact(s.particle.position.z), error = s.particle.velocity.x - exact;
    squares += error * error;
    scale += exact * exact;
  }
  row.addError("profile_l2", std::sqrt(squares / scale), "1", film.bar);
  row.addError("surface_speed", std::abs(surfaceSpeed(**solver, c.spacing) / film.exact(kDepth) - 1.0), "1",
               film.bar);
  row.addFigure("steps", *steps, "1");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / seconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

constexpr double kYield = 500.0, kPlastic = 1000.0;  // Pa, Pa s

/// Bingham: u = ((T - tau_y)^2 - (tau(z) - tau_y)_+^2) / (2 mu G) with tau = G (h - z), T = G h.
double binghamSpeed(double tangent, double z) {
  const double push = kDensity * gravityOn(tangent).x;
  const double bed = std::max(push * kDepth - kYield, 0.0);
  const double here = std::max(push * (kDepth - z) - kYield, 0.0);
  return (bed * bed - here * here) / (2.0 * kPlastic * push);
}

/// Slope at which the bed's stress is the yield stress: sin t = tau_y / (rho g h).
double criticalTangent() {
  const double sine = kYield / (kDensity * kGravity * kDepth);
  return sine / std::sqrt(1.0 - sine * sine);
}

/// From rest, two hundredths below the critical slope, with a regularisation that is stiff enough: what is
/// left is its creep, which is reached within a few of its own short relaxation times h^2 / nu.
Result<BenchRow> measureStop(const BenchOptions& options, const FlowMode& mode, int layers) {
  BenchRow row;
  row.caseId = "film-bingham";
  row.settings = {{"measured", "stop"}, {"mode", mode.id}, {"layers", std::to_string(layers)}};
  const BenchMeter meter;
  const double flowing = binghamSpeed(1.1 * criticalTangent(), kDepth);
  Film film;
  Rheology& r = film.rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = static_cast<float>(kPlastic);
  r.cohesion = static_cast<float>(kYield);
  // Creep of about h/m is to stay below half a hundredth of the flowing speed.
  r.regularisation = static_cast<float>(400.0 * kDepth / flowing);
  r.most = 1e12f;
  const double relaxation = kDepth * kDepth * kDensity / (kYield * static_cast<double>(r.regularisation));
  double speed[2] = {};
  for (const int above : {0, 1}) {
    film.tangent = (above ? 1.02 : 0.98) * criticalTangent();
    const FlowConfig c = filmConfig(film, mode, layers);
    auto solver = startFlow(c, filmParticles(c, film, layers, 0.0), options);
    if (!solver) return solver.error();
    const Result<int> steps = runFlow(**solver, 3.0 * relaxation);
    if (!steps) return steps.error();
    speed[above] = surfaceSpeed(**solver, c.spacing);
    nameDevice(**solver, options, row);
  }
  row.addError("speed_below_critical", speed[0] / flowing, "of 1.1 critical", 0.01);
  row.addFigure("speed_above_critical", speed[1] / flowing, "of 1.1 critical");
  meter.finish(row);
  return row;
}

Film binghamFilm() {
  Film film;
  film.id = "film-bingham";
  Rheology& r = film.rheology;
  r.law = RheologyLaw::Yield;
  r.viscosity = static_cast<float>(kPlastic);
  r.cohesion = static_cast<float>(kYield);
  r.most = 3e4f;
  film.exact = [t = film.tangent](double z) { return binghamSpeed(t, z); };
  return film;
}

/// Cross with n = 1, whose flow curve is monotone: shear rates integrated over the depth.
Film crossFilm() {
  constexpr double kRest = 2000.0, kSpeed = 200.0, kFactor = 1.0;
  Film film;
  film.id = "film-cross";
  Rheology& r = film.rheology;
  r.law = RheologyLaw::Cross;
  r.viscosity = static_cast<float>(kRest);
  r.viscosityAtSpeed = static_cast<float>(kSpeed);
  r.crossFactor = static_cast<float>(kFactor);
  const double push = kDensity * gravityOn(film.tangent).x;
  film.exact = [push](double z) {
    constexpr int kParts = 400;
    double u = 0.0;
    for (int k = 0; k < kParts; ++k) {
      const double stress = push * (kDepth - (k + 0.5) * z / kParts);
      const double b = kRest - stress * kFactor;
      u += (-b + std::sqrt(b * b + 4.0 * kSpeed * kFactor * stress)) / (2.0 * kSpeed * kFactor) * z / kParts;
    }
    return u;
  };
  return film;
}

Result<std::vector<BenchRow>> runFilm(const BenchOptions& options, const Film& film, bool stops) {
  std::vector<BenchRow> rows;
  const std::vector<int> layers = options.quick ? std::vector<int>{20} : std::vector<int>{20, 40};
  for (const int n : layers)
    for (const FlowMode& mode : {kFastMode, kAccurateMode}) {
      if ((options.quick || n > 20) && mode.supportSpacings > 2.5) continue;
      Result<BenchRow> row = measureProfile(options, film, mode, n);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  if (!stops) return rows;
  Result<BenchRow> row = measureStop(options, kFastMode, options.quick ? 10 : 20);
  if (!row) return row.error();
  rows.push_back(std::move(*row));
  return rows;
}

Result<std::vector<BenchRow>> runBingham(const BenchOptions& options) {
  return runFilm(options, binghamFilm(), true);
}
Result<std::vector<BenchRow>> runCross(const BenchOptions& options) {
  return runFilm(options, crossFilm(), false);
}

}  // namespace

BenchCase filmBinghamCase() {
  return {"film-bingham", "profile and stop of a yield-stress layer on a slope", "closed form", runBingham};
}
BenchCase filmCrossCase() {
  return {"film-cross", "profile of a Cross fluid's layer on a slope", "integrated flow curve", runCross};
}

}  // namespace spin
