// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/flow_bench_scene.h"

namespace spin {
namespace {

/// Vortices of Taylor and Green in a periodic square of 1 m at Re = 100, in a slab; no term beyond the
/// solver's own (no shifting of particles, no background pressure).
Result<BenchRow> measure(const BenchOptions& options, const FlowMode& mode, DensityMode density, int across) {
  BenchRow row;
  row.caseId = "taylor-green-sph";
  row.settings = {{"mode", mode.id},
                  {"density", density == DensityMode::Continuity ? "continuity" : "summation"},
                  {"across", std::to_string(across)}};
  const BenchMeter meter;
  FlowConfig c;
  c.spacing = 1.0 / across;
  c.supportSpacings = mode.supportSpacings;
  c.density = density;
  c.gravity = {};
  c.clampTension = false;
  const int width = slabWidth(mode.supportSpacings);
  c.domainMax = {1.0, width * c.spacing, 1.0};
  c.periodic[0] = c.periodic[1] = c.periodic[2] = true;
  c.materials[0].soundSpeed = 10.0;
  c.materials[0].rheology.viscosity = 10.0f;
  const auto exact = [](Vec3d p) {
    const double k = 2.0 * kPi;
    return Vec3d{-std::cos(k * p.x) * std::sin(k * p.z), 0.0, std::sin(k * p.x) * std::cos(k * p.z)};
  };
  auto particles = flowLattice(c, across, width, across, {}, 0.0);
  for (FlowParticle& p : particles) {
    p.velocity = exact(p.position);
    // Balances the turning: p = -rho U^2/4 (cos 2kx + cos 2kz).
    const double pressure =
        -250.0 * (std::cos(4.0 * kPi * p.position.x) + std::cos(4.0 * kPi * p.position.z));
    p.excess = pressure / (1000.0 * 100.0);
  }
  auto solver = startFlow(c, particles, options);
  if (!solver) return solver.error();
  const double seconds = options.quick ? 0.2 : 1.0;
  if (const Result<int> steps = runFlow(**solver, seconds); !steps) return steps.error();
  const double decay = std::exp(-8.0 * kPi * kPi * seconds / 100.0);
  double error = 0.0, fastest = 0.0;
  const auto samples = (*solver)->samples();
  for (const FlowSample& s : samples) {
    const double speed = length(s.particle.velocity);
    error += std::abs(speed - decay * length(exact(s.particle.position)));
    fastest = std::max(fastest, speed);
  }
  row.addFigure("decay_error", std::abs(fastest / decay - 1.0), "1");
  row.addFigure("speed_l1", error / static_cast<double>(samples.size()) / decay, "1");
  row.addFigure("time", seconds, "s");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / seconds, "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const auto add = [&](const FlowMode& mode, DensityMode density, int across) -> Status {
    Result<BenchRow> row = measure(options, mode, density, across);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
    return {};
  };
  if (Status ok = add(kFastMode, DensityMode::Continuity, options.quick ? 30 : 50); !ok) return ok.error();
  if (options.quick) return rows;
  if (Status ok = add(kFastMode, DensityMode::Summation, 50); !ok) return ok.error();
  if (Status ok = add(kAccurateMode, DensityMode::Continuity, 51); !ok) return ok.error();
  return rows;
}

}  // namespace

BenchCase taylorGreenSphCase() {
  return {"taylor-green-sph", "decay of vortices at Re 100", "exact solution of Taylor and Green", run};
}

}  // namespace spin
