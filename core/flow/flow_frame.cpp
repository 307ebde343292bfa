// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_frame.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/units.h"
#include "core/sph/flow_setup.h"

namespace spin {
namespace {

struct AttributeKind {
  const char* name;
  const char* unit;
  int components;
};
constexpr AttributeKind kAttributes[] = {
    {"velocity", "m/s", 3},   {"density", "kg/m3", 1},  {"pressure", "Pa", 1}, {"acceleration", "m/s2", 3},
    {"shear_rate", "1/s", 1}, {"viscosity", "Pa s", 1}, {"age", "s", 1},       {"neighbours", "", 1},
    {"material", "", 1},      {"class", "", 1},
};

/// Shares of the neighbours within bulk, and of the density at rest, below which a particle counts as
/// isolated or at the surface.
constexpr double kIsolatedShare = 0.15, kSurfaceNeighbours = 0.6, kSurfaceDensity = 0.85;

class Publisher {
 public:
  Publisher(const FlowReport& report, double film) : m_report(report), m_film(film) {}

  std::shared_ptr<ParticlePart> part(const std::vector<FlowSample>& samples) {
    auto part = std::make_shared<ParticlePart>();
    ParticleSet& set = part->particles;
    set.name = "flow";
    set.ids.reserve(samples.size());
    set.positions.reserve(samples.size());
    for (const AttributeKind& kind : kAttributes) {
      set.attributes.push_back({kind.name, kind.unit, kind.components, {}});
      set.attributes.back().values.reserve(samples.size() * static_cast<std::size_t>(kind.components));
    }
    for (const FlowSample& s : samples) add(s, set);
    return part;
  }

 private:
  void add(const FlowSample& s, ParticleSet& set) {
    const double rest = m_report.config.materials[s.particle.material].restDensity;
    // What has just entered has no density yet.
    const double density = s.density > 0.0 ? s.density : rest;
    set.ids.push_back(s.particle.id);
    set.positions.push_back(s.particle.position.to<float>());
    std::size_t at = 0;
    const auto put = [&](double value) { set.attributes[at++].values.push_back(static_cast<float>(value)); };
    const auto putVector = [&](Vec3d value) {
      auto& values = set.attributes[at++].values;
      for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(value[axis]));
    };
    putVector(s.particle.velocity);
    put(density);
    put(s.pressure);
    putVector(s.pairAcceleration);
    put(s.shearRate);
    put(s.viscosity);
    put(m_film - birthOf(s.particle.id));
    put(std::max(s.neighbours, 0));
    put(s.particle.material);
    put(static_cast<double>(flowClassOf(m_report.config, s)));
  }

  /// Samples come by id, so the births are walked once.
  double birthOf(std::uint32_t id) {
    const std::vector<FlowBirth>& births = m_report.births;
    while (m_birth + 1 < births.size() && births[m_birth + 1].firstId <= id) ++m_birth;
    return births.empty() ? m_film : births[m_birth].film;
  }

  const FlowReport& m_report;
  double m_film;
  std::size_t m_birth = 0;
};

std::shared_ptr<ParticlePart> boundaryPart(const std::vector<Vec3d>& places) {
  auto part = std::make_shared<ParticlePart>();
  ParticleSet& set = part->particles;
  set.name = "flow_boundary";
  for (const Vec3d& p : places) {
    set.ids.push_back(set.ids.size());
    set.positions.push_back(p.to<float>());
  }
  return part;
}

using FlowCounts = std::array<std::uint64_t, kMostMaterials>;
using FlowShares = std::array<std::int64_t, kMostMaterials>;

/// Of so many particles, less what they have given away.
double massOf(const FlowConfig& config, const FlowCounts& counts, const FlowShares& given = {}) {
  double sum = 0.0;
  for (std::size_t m = 0; m < config.materials.size(); ++m)
    sum += (static_cast<double>(counts[m]) - static_cast<double>(given[m]) * kGivenUnit) *
           config.particleMass(m);
  return sum;
}

void publishBudget(const FlowReport& r, const std::vector<FlowSample>& samples, MassBudget& budget) {
  FlowCounts moving{};
  FlowShares given{};
  for (const FlowSample& s : samples) {
    ++moving[s.particle.material];
    given[s.particle.material] += unitsGiven(s.particle.given);
  }
  const FlowLosses losses = r.solver.losses();
  budget.set("flow_released", true, massOf(r.config, r.account.released));
  budget.set("flow_inflow", true, massOf(r.config, r.account.inflow));
  budget.set("flow_present", false, massOf(r.config, moving, given));
  budget.set("flow_left", false, massOf(r.config, losses.left, losses.leftGiven));
  budget.set("flow_sunk", false, massOf(r.config, losses.sunk, losses.sunkGiven));
}

void publishMotion(const FlowReport& r, const std::vector<FlowSample>& samples,
                   std::map<std::string, double>& figures) {
  double fastest = 0.0, speeds = 0.0, energy = 0.0, error = 0.0, worst = 0.0;
  for (const FlowSample& s : samples) {
    const double speed = length(s.particle.velocity);
    fastest = std::max(fastest, speed);
    speeds += speed;
    energy += 0.5 * r.config.particleMass(s.particle.material) * speed * speed;
    // Only what is too dense: at a surface the sum is less by nature.
    const double excess = s.density / r.config.materials[s.particle.material].restDensity - 1.0;
    error += std::max(excess, 0.0);
    worst = std::max(worst, excess);
  }
  const double n = std::max(static_cast<double>(samples.size()), 1.0);
  figures["flow_particles"] = static_cast<double>(samples.size());
  figures["flow_max_speed_m_s"] = fastest;
  figures["flow_mean_speed_m_s"] = speeds / n;
  figures["flow_kinetic_energy_j"] = energy;
  figures["flow_density_error"] = error / n;
  figures["flow_density_error_max"] = worst;
}

}  // namespace

FlowClass flowClassOf(const FlowConfig& config, const FlowSample& s) {
  if (s.neighbours < 0) return FlowClass::Main;
  const double reach = config.supportSpacings;
  const double bulk = 4.0 / 3.0 * kPi * reach * reach * reach - 1.0;
  if (s.neighbours <= kIsolatedShare * bulk) return FlowClass::Isolated;
  // The carried density does not tell where the surface is. What has just entered has none yet.
  const bool atSurface =
      config.density == DensityMode::Summation
          ? s.density > 0.0 && s.density < kSurfaceDensity * config.materials[s.particle.material].restDensity
          : s.neighbours < kSurfaceNeighbours * bulk;
  return atSurface ? FlowClass::Surface : FlowClass::Main;
}

double flowFrameBytes() {
  double floats = 3.0;
  for (const AttributeKind& kind : kAttributes) floats += kind.components;
  return floats * sizeof(float) + sizeof(std::uint64_t);
}

void publishFlow(const FlowReport& report, Frame& frame) {
  const std::vector<FlowSample> samples = report.solver.samples();
  frame.parts["flow"] = Publisher(report, frame.info.time.film).part(samples);
  if (const std::vector<Vec3d> places = report.solver.bodyBoundary(); !places.empty())
    frame.parts["flow_boundary"] = boundaryPart(places);
  publishBudget(report, samples, frame.info.budget);
  std::map<std::string, double>& figures = frame.info.figures;
  publishMotion(report, samples, figures);
  figures["flow_spacing_m"] = report.config.spacing;
  figures["flow_layers"] = report.layers;
  const FlowStepCount& steps = report.steps;
  figures["flow_steps"] = steps.steps;
  const double count = std::max(steps.steps, 1u);
  figures["flow_pressure_iterations"] = static_cast<double>(steps.pressureIterations) / count;
  figures["flow_viscosity_iterations"] = static_cast<double>(steps.viscosityIterations) / count;
  figures["flow_steps_with_implicit_viscosity"] = steps.viscositySolves;
  figures["flow_mean_step_s"] = steps.steps > 0 ? steps.seconds / steps.steps : 0.0;
  constexpr const char* kLimits[] = {"flow_steps_as_asked", "flow_steps_by_sound", "flow_steps_by_force",
                                     "flow_steps_by_viscosity", "flow_steps_by_speed"};
  static_assert(std::size(kLimits) == std::tuple_size_v<decltype(steps.limits)>);
  for (std::size_t k = 0; k < std::size(kLimits); ++k) figures[kLimits[k]] = steps.limits[k];
}

}  // namespace spin
