// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665;

/// Ground over [-cell, length] x [-cell, width] with the given height by x.
template <class Height>
Raster<float> groundOf(double length, double width, double cell, const Height& height) {
  Raster<float> ground(static_cast<int>(length / cell) + 3, static_cast<int>(width / cell) + 3, -cell, -cell,
                       cell);
  for (int j = 0; j < ground.height; ++j)
    for (int i = 0; i < ground.width; ++i) ground.at(i, j) = static_cast<float>(height(ground.x(i)));
  return ground;
}

/// A slab of fluid on a smooth slope of 30 degrees, as a height field.
Result<BenchRow> measureSlip(const BenchOptions& options, const FlowMode& mode) {
  BenchRow row;
  row.caseId = "incline-slip";
  row.settings = {{"mode", mode.id}};
  const BenchMeter meter;
  const double slope = std::tan(kPi / 6.0), cosine = std::cos(kPi / 6.0), sine = 0.5;
  FlowConfig c;
  c.spacing = 0.05;
  c.supportSpacings = mode.supportSpacings;
  c.density = DensityMode::Continuity;
  c.domainMin = {0, 0, -1};
  c.domainMax = {12, 3, 9};
  c.materials[0].soundSpeed = 40.0;
  // A block: it holds together while it slides.
  c.materials[0].rheology.viscosity = 1000.0f;
  c.walls.ground = groundOf(12, 3, 0.25, [&](double x) { return slope * x; });
  c.walls.surfaces = {{WallFriction::FreeSlip, 0.0f}};
  auto particles = flowLattice(c, 16, 16, 4, {}, 0.0);
  for (FlowParticle& p : particles)
    p.position = {10.0 + p.position.x * cosine - p.position.z * sine, 1.0 + p.position.y,
                  10.0 * slope + p.position.x * sine + p.position.z * cosine};
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  const auto speed = [&] {
    double sum = 0.0;
    for (const FlowSample& s : (*solver)->samples())
      sum -= s.particle.velocity.x * cosine + s.particle.velocity.z * sine;
    return sum / static_cast<double>((*solver)->count());
  };
  if (const Result<int> steps = runFlow(**solver, 0.2); !steps) return steps.error();
  const double early = speed();
  if (const Result<int> steps = runFlow(**solver, 0.8); !steps) return steps.error();
  row.addError("acceleration_error", std::abs((speed() - early) / 0.8 / (kGravity * sine) - 1.0), "1", 0.02);
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> runSlip(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const FlowMode& mode : {kFastMode, kAccurateMode}) {
    if (options.quick && mode.supportSpacings > 2.5) continue;
    Result<BenchRow> row = measureSlip(options, mode);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

FlowConfig throwConfig(double spacing) {
  FlowConfig c;
  c.spacing = spacing;
  c.density = DensityMode::Continuity;
  c.domainMin = {-2, -2, -2};
  c.domainMax = {6, 4, 5};
  c.materials[0].soundSpeed = 100.0;
  return c;
}

/// A block of water at 10 m/s.
std::vector<FlowParticle> thrown(const FlowConfig& c, Vec3d corner) {
  const int n = static_cast<int>(std::lround(0.8 / c.spacing));
  auto particles = flowLattice(c, n, n, n, corner, 0.1);
  for (FlowParticle& p : particles) p.velocity.x = 10.0;
  return particles;
}

/// How far the deepest particle was ever inside, by `depth`, m.
template <class Depth>
Result<BenchRow> measurePenetration(const BenchOptions& options, const char* wall, const FlowConfig& c,
                                    Vec3d corner, const Depth& depth) {
  BenchRow row;
  row.caseId = "penetration";
  row.settings = {{"wall", wall}};
  const BenchMeter meter;
  const auto particles = thrown(c, corner);
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  double deepest = 0.0;
  const double end = 0.5, frame = 0.002;
  for (double t = 0.0; t < end; t += frame) {
    if (const Result<int> steps = runFlow(**solver, frame); !steps) return steps.error();
    for (const FlowSample& s : (*solver)->samples()) deepest = worse(deepest, depth(s.particle.position));
  }
  row.addError("deepest", deepest / c.spacing, "spacings", 0.1);
  row.addFigure("particles_left",
                static_cast<double>((*solver)->count()) / static_cast<double>(particles.size()), "1");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / end, "1");
  nameDevice(**solver, options, row);
  return row;
}

/// Facets of the field are triangles: below it is what lies under the plane of the quad's triangle.
double depthUnder(const Raster<float>& ground, Vec3d p) {
  const double gx = (p.x - ground.originX) / ground.cellSize, gy = (p.y - ground.originY) / ground.cellSize;
  if (!(gx >= 0.0 && gy >= 0.0) || gx >= ground.width - 1 || gy >= ground.height - 1) return 0.0;
  const int i = static_cast<int>(gx), j = static_cast<int>(gy);
  const double u = gx - i, v = gy - j;
  const auto z = [&](int a, int b) { return static_cast<double>(ground.at(i + a, j + b)); };
  const double du = u >= v ? z(1, 0) - z(0, 0) : z(1, 1) - z(0, 1);
  const double dv = u >= v ? z(1, 1) - z(1, 0) : z(0, 1) - z(0, 0);
  const double sx = du / ground.cellSize, sy = dv / ground.cellSize;
  return (z(0, 0) + du * u + dv * v - p.z) / std::sqrt(1.0 + sx * sx + sy * sy);
}

Result<std::vector<BenchRow>> runPenetration(const BenchOptions& options) {
  const double spacing = options.quick ? 0.1 : 0.05;
  FlowConfig steps = throwConfig(spacing);
  // Steps of 0.5 m on the whole rise at 45 degrees; their walls are one cell wide.
  steps.walls.ground =
      groundOf(6, 4, 0.125, [](double x) { return x < 1.0 ? 0.0 : 0.5 * std::floor((x - 0.5) / 0.5); });
  Result<BenchRow> stepped = measurePenetration(options, "stepped 45 degree ground", steps, {0.05, 1.0, 0.1},
                                                [&](Vec3d p) { return depthUnder(steps.walls.ground, p); });
  if (!stepped) return stepped.error();

  FlowConfig triangle = throwConfig(spacing);
  FlowWallsConfig::MeshWall wall;
  wall.triangles.positions = {{2, -6, -6}, {2, 6, -6}, {2, 0, 12}};
  wall.triangles.indices = {0, 1, 2};
  triangle.walls.meshes = {wall};
  // The plate is taken for a solid one spacing thick.
  Result<BenchRow> plate = measurePenetration(options, "one triangle", triangle, {0.5, 0.5, 0.5},
                                              [](Vec3d p) { return p.x - 2.0; });
  if (!plate) return plate.error();
  return std::vector<BenchRow>{std::move(*stepped), std::move(*plate)};
}

}  // namespace

BenchCase inclineSlipCase() {
  return {"incline-slip", "acceleration of a frictionless slab on a 30 degree height field", "a = g sin t",
          runSlip};
}
BenchCase penetrationCase() {
  return {"penetration", "deepest particle of water thrown at stepped ground and at one triangle",
          "none inside", runPenetration};
}

}  // namespace spin
