// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/bench/bench_meter.h"
#include "core/bench/dam_break.h"

namespace spin {
namespace {

constexpr double kGravity = 9.80665, kDensity = 1000.0;
constexpr double kArrivalPressure = 0.05;  // rho g H

const char* floorName(const FlowTrial& setting) {
  return setting.floor == WallFriction::FreeSlip ? "free slip" : "no slip";
}

/// Pressure at a sensor: the mean of what is within two spacings of it, each brought to its height. The water
/// has come when it presses: what runs up the wall at first is a film.
class Sensor {
 public:
  Sensor(const ImpactSensor& sensor, const FlowConfig& config) : m_sensor(sensor), m_config(config) {}

  void add(const std::vector<FlowSample>& samples, double time) {
    double sum = 0.0, weight = 0.0;
    for (const FlowSample& s : samples) {
      const double dx = kLobovskyTank - s.particle.position.x, dz = s.particle.position.z - m_sensor.height;
      const double w = std::max(0.0, 1.0 - std::hypot(dx, dz) / (2.0 * m_config.spacing));
      sum += w * (s.pressure + kDensity * kGravity * dz);
      weight += w;
    }
    const double share = sum / (kDensity * kGravity * kLobovskyDepth);
    if (m_arrival == 0.0 && weight > 0.0 && share / weight > kArrivalPressure) m_arrival = time;
    if (time < kLobovskyPlateau[0] || time > kLobovskyPlateau[1]) return;
    m_plateau += weight > 0.0 ? share / weight : 0.0;
    ++m_moments;
  }
  void report(bool plateau, BenchRow& row) const {
    const std::string id = m_sensor.id;
    row.addError(id + "_arrival", std::abs(m_arrival / m_sensor.arrival - 1.0), "1", 0.03);
    row.addFigure(id + "_arrival_time", m_arrival, "sqrt(H/g)");
    if (!plateau) return;
    const double middle = 0.5 * (m_sensor.low + m_sensor.high);
    row.addError(id + "_plateau", std::abs(m_plateau / m_moments / middle - 1.0), "1", 0.1);
    row.addFigure(id + "_plateau_pressure", m_plateau / m_moments, "rho g H");
  }

 private:
  ImpactSensor m_sensor;
  FlowConfig m_config;
  double m_arrival = 0.0, m_plateau = 0.0;
  int m_moments = 0;
};

FlowConfig tankConfig(const FlowTrial& setting) {
  FlowConfig c;
  c.spacing = kLobovskyDepth / setting.across;
  c.supportSpacings = setting.mode.supportSpacings;
  c.density = setting.density;
  c.courant = setting.courant;
  c.pressure = setting.pressure;
  const double edge = 4.0 * c.spacing;
  c.domainMin = {-edge, 0, -edge};
  c.domainMax = {kLobovskyTank + edge, slabWidth(c.supportSpacings) * c.spacing, 5.0 * kLobovskyDepth};
  c.periodic[1] = true;
  c.materials[0].soundSpeed = 14.0 * std::sqrt(2.0 * kGravity * kLobovskyDepth);
  c.materials[0].rheology.viscosity = static_cast<float>(2.0 * c.materials[0].soundSpeed * c.spacing);
  c.walls.surfaces = {{setting.floor, 0.0f}};
  c.walls.planes = {{{0, 0, 0}, {0, 0, 1}, {}, 0},
                    {{0, 0, 0}, {1, 0, 0}, {}, 0},
                    {{kLobovskyTank, 0, 0}, {-1, 0, 0}, {}, 0}};
  return c;
}

Result<BenchRow> measureImpact(const BenchOptions& options, const FlowTrial& setting) {
  BenchRow row;
  row.caseId = "dam-break";
  row.settings["measured"] = "pressure";
  describe(setting, row);
  row.settings["floor"] = floorName(setting);
  const BenchMeter meter;
  const FlowConfig c = tankConfig(setting);
  auto solver = startFlow(
      c, flowLattice(c, 2 * setting.across, slabWidth(c.supportSpacings), setting.across, {}, 0.1), options);
  if (!solver) return solver.error();
  std::vector<Sensor> sensors;
  for (const ImpactSensor& s : kLobovskySensors) sensors.emplace_back(s, c);
  const double second = std::sqrt(kLobovskyDepth / kGravity), frame = 0.01, end = options.quick ? 3.0 : 5.4;
  for (double t = 0.0; t < end; t += frame) {
    if (const Result<int> steps = runFlow(**solver, frame * second); !steps) return steps.error();
    const auto samples = (*solver)->samples();
    for (Sensor& s : sensors) s.add(samples, t + frame);
  }
  for (const Sensor& s : sensors) s.report(!options.quick, row);
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / (end * second), "1");
  nameDevice(**solver, options, row);
  return row;
}

std::vector<FlowTrial> settingsOf(const BenchOptions& options) {
  FlowTrial coarse, fine, accurate, sums;
  coarse.across = options.quick ? 16 : 20;
  if (options.quick) return {coarse};
  fine.across = 40;
  accurate.mode = kAccurateMode;
  sums.density = DensityMode::Summation;
  FlowTrial sticky = fine;
  sticky.floor = WallFriction::NoSlip;
  return {coarse, fine, accurate, sums, sticky};
}

std::vector<std::pair<int, WallFriction>> impactsOf(const BenchOptions& options) {
  if (options.quick) return {{40, WallFriction::FreeSlip}};
  return {{20, WallFriction::FreeSlip},
          {40, WallFriction::FreeSlip},
          {20, WallFriction::NoSlip},
          {40, WallFriction::NoSlip}};
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const FlowTrial& setting : settingsOf(options)) {
    Result<BenchRow> row = damFrontTrial(options, setting);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  // On its way of five depths, a layer of a fifth of a depth: how the floor holds it counts.
  FlowTrial impact;
  for (const auto& [across, floor] : impactsOf(options)) {
    impact.across = across;
    impact.floor = floor;
    Result<BenchRow> row = measureImpact(options, impact);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

Result<BenchRow> damFrontTrial(const BenchOptions& options, const FlowTrial& setting) {
  BenchRow row;
  row.caseId = "dam-break";
  row.settings["measured"] = "front";
  describe(setting, row);
  row.settings["floor"] = floorName(setting);
  const BenchMeter meter;
  const Result<DamFront> run = runDamFront(options, setting);
  if (!run) return run.error();
  double shift = 0.0;
  row.addError("koshizuka_oka", shiftedFrontError(run->front, koshizukaOkaFront(), shift), "1", 0.03);
  row.addFigure("shift", shift, "s");
  row.addFigure("koshizuka_oka_raw", frontError(run->front, koshizukaOkaFront(), 0.0), "1");
  row.addFigure("martin_moyce", shiftedFrontError(run->front, martinMoyceFront(false), shift), "1");
  row.addFigure("martin_moyce_narrow", shiftedFrontError(run->front, martinMoyceFront(true), shift), "1");
  row.addFigure("energy_kept", run->energy, "1");
  row.addTime("seconds_per_simulated_second", run->seconds, "1");
  meter.finish(row);
  row.device = run->device;
  return row;
}

BenchCase damBreakCase() {
  return {"dam-break", "front of a collapsing column; pressures on the wall it hits",
          "Koshizuka and Oka 1996, Martin and Moyce 1952, Lobovsky et al. 2014", run};
}

}  // namespace spin
