// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <map>

#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665;
constexpr double kSpacing = 0.05;
constexpr int kWide = 18, kLayers = 12;
constexpr double kRadius = 5.0 * kSpacing;                          ///< of the ball
constexpr Vec3d kHalf{5 * kSpacing, 5 * kSpacing, 2.5 * kSpacing};  ///< of the box

TriangleMesh boxOf(Vec3d h) {
  TriangleMesh m;
  for (int k = 0; k < 8; ++k)
    m.positions.push_back({k & 1 ? h.x : -h.x, k & 2 ? h.y : -h.y, k & 4 ? h.z : -h.z});
  m.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
               2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return m;
}

/// Rings of triangles from pole to pole.
TriangleMesh ballOf(double radius) {
  constexpr std::uint32_t kRings = 24, kRound = 48;
  TriangleMesh m;
  for (std::uint32_t i = 0; i <= kRings; ++i)
    for (std::uint32_t j = 0; j < kRound; ++j) {
      const double t = M_PI * i / kRings, p = 2 * M_PI * j / kRound;
      const double ring = i == 0 || i == kRings ? 0.0 : std::sin(t);
      m.positions.push_back(Vec3d{ring * std::cos(p), ring * std::sin(p), std::cos(t)} * radius);
    }
  for (std::uint32_t i = 0; i < kRings; ++i)
    for (std::uint32_t j = 0; j < kRound; ++j) {
      const std::uint32_t a = i * kRound + j, b = i * kRound + (j + 1) % kRound, c = a + kRound,
                          d = b + kRound;
      for (const std::uint32_t k : {a, c, b, b, c, d}) m.indices.push_back(k);
    }
  return m;
}

/// Depth below the water's surface of the lowest point of a body that floats.
double depthOf(bool ball, double ratio) {
  if (!ball) return ratio * 2.0 * kHalf.z;
  // Cap: V = pi d^2 (3 R - d) / 3.
  double low = 0.0, high = 2.0 * kRadius;
  for (int k = 0; k < 60; ++k) {
    const double d = 0.5 * (low + high);
    (d * d * (3.0 * kRadius - d) < ratio * 4.0 * kRadius * kRadius * kRadius ? low : high) = d;
  }
  return low;
}

struct Floating {
  bool ball;
  double ratio;
  FlowMode mode;
  DensityMode density;
  PressureMode pressure = PressureMode::EquationOfState;
};

FlowConfig tank(const Floating& f) {
  FlowConfig c;
  c.spacing = kSpacing;
  c.supportSpacings = f.mode.supportSpacings;
  c.density = f.density;
  c.pressure = f.pressure;
  c.domainMin = {0, 0, -4 * kSpacing};
  c.domainMax = {kWide * kSpacing, kWide * kSpacing, 2 * kLayers * kSpacing};
  c.periodic[0] = c.periodic[1] = true;
  c.countImpulse = true;
  c.materials[0].soundSpeed = 10.0 * std::sqrt(2.0 * kGravity * kLayers * kSpacing);
  // Takes out the body's bobbing; at rest it does nothing.
  c.materials[0].rheology.viscosity = 40.0f;
  c.walls.planes = {{}};
  return c;
}

bool within(const Floating& f, Vec3d p, double margin) {
  if (f.ball) return length(p) < kRadius + margin;
  return std::abs(p.x) < kHalf.x + margin && std::abs(p.y) < kHalf.y + margin &&
         std::abs(p.z) < kHalf.z + margin;
}

Vec3d momentumOf(const FlowConfig& c, const FlowSolver& solver) {
  Vec3d sum = solver.bodies()[0].velocity * c.bodies[0].mass();
  for (const FlowSample& s : solver.samples()) sum += s.particle.velocity * c.particleMass(0);
  return sum;
}

Result<BenchRow> measure(const BenchOptions& options, const Floating& f) {
  BenchRow row;
  row.caseId = "buoyancy";
  row.settings = {{"mode", f.mode.id},
                  {"body", f.ball ? "sphere" : "box"},
                  {"ratio", fmt::format("{:.2f}", f.ratio)},
                  {"density", f.pressure == PressureMode::Implicit   ? "implicit"
                              : f.density == DensityMode::Continuity ? "continuity"
                                                                     : "summation"}};
  const BenchMeter meter;
  FlowConfig c = tank(f);
  auto shape = makeRigidShape(f.ball ? ballOf(kRadius) : boxOf(kHalf));
  if (!shape) return shape.error();
  const double middle = 0.5 * kWide * kSpacing, area = 4.0 * middle * middle, volume = (*shape)->mass.volume;
  const double lowest = f.ball ? kRadius : kHalf.z;
  RigidBodyConfig body;
  body.shape = *shape;
  body.density = f.ratio * 1000.0;
  // Near its place, with room for the water round it.
  body.start.position = {middle, middle,
                         kLayers * kSpacing - depthOf(f.ball, f.ratio) + lowest + 0.5 * kSpacing};
  c.bodies = {body};
  std::vector<FlowParticle> particles;
  for (const FlowParticle& p : flowLattice(c, kWide, kWide, kLayers, {}, 0.0))
    if (!within(f, p.position - body.start.position, 0.25 * kSpacing)) particles.push_back(p);
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  const double calm = options.quick ? 0.5 : 2.0;
  Result<int> steps = runFlow(**solver, calm);
  double height = 0.0;
  int moments = 0;
  for (; steps && moments < 25; ++moments) {
    steps = runFlow(**solver, 0.02);
    height += (*solver)->bodies()[0].position.z;
  }
  if (!steps) return steps.error();
  const double water = static_cast<double>(particles.size()) * kSpacing * kSpacing * kSpacing;
  const double level = (water + f.ratio * volume) / area;
  const double depth = level - (height / moments - lowest);
  row.addFigure("depth", depth, "m");
  row.addError("depth_error", std::abs(depth - depthOf(f.ball, f.ratio)) / kSpacing, "spacings", 0.5);
  const double seconds = calm + 0.5, mass = water * 1000.0 + body.mass();
  const Vec3d open = momentumOf(c, **solver) - (*solver)->outerImpulse();
  row.addError("momentum_error", length(open) / (mass * kGravity * seconds), "1", 1e-5);
  row.addError("lost", static_cast<double>(particles.size() - (*solver)->count()), "particles", 0.0);
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / seconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<Floating> cases;
  for (const bool ball : {false, true})
    for (const double ratio : {0.25, 0.5, 0.75})
      for (const DensityMode density : {DensityMode::Summation, DensityMode::Continuity})
        for (const FlowMode& mode : {kFastMode, kAccurateMode})
          if (mode.supportSpacings < 2.5 || ratio == 0.5) cases.push_back({ball, ratio, mode, density});
  for (const bool ball : {false, true})
    for (const double ratio : {0.25, 0.5, 0.75})
      cases.push_back({ball, ratio, kFastMode, DensityMode::Summation, PressureMode::Implicit});
  if (options.quick)
    cases = {{false, 0.5, kFastMode, DensityMode::Continuity},
             {true, 0.25, kFastMode, DensityMode::Summation}};
  std::vector<BenchRow> rows;
  for (const Floating& f : cases) {
    Result<BenchRow> row = measure(options, f);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase buoyancyCase() {
  return {"buoyancy", "how deep a box and a sphere float, and whether momentum closes", "Archimedes' depth",
          run};
}

}  // namespace spin
