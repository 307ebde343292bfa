// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_frame.h"

#include <algorithm>

namespace spin {
namespace {

std::shared_ptr<ParticlePart> sprayPart(const CloudReport& r, double film) {
  auto part = std::make_shared<ParticlePart>();
  ParticleSet& set = part->particles;
  set.name = "spray";
  set.attributes = {{"velocity", "m/s", 3, {}},
                    {"diameter", "m", 1, {}},
                    {"mass", "kg", 1, {}},
                    {"age", "s", 1, {}},
                    {"material", "", 1, {}}};
  for (const SprayParcel& p : r.state.parcels) {
    set.ids.push_back(p.id);
    set.positions.push_back(p.position.to<float>());
    for (int axis = 0; axis < 3; ++axis)
      set.attributes[0].values.push_back(static_cast<float>(p.velocity[axis]));
    const double mass = static_cast<double>(p.units) * kGivenUnit * r.scene.flow.particleMass(p.material);
    const double values[] = {p.diameter, mass, std::max(film - p.born, 0.0), static_cast<double>(p.material)};
    for (std::size_t k = 0; k < 4; ++k) set.attributes[k + 1].values.push_back(static_cast<float>(values[k]));
  }
  return part;
}

/// Water in all its forms, kg.
double waterOf(const AirAmounts& amounts) {
  return amounts[static_cast<std::size_t>(AirScalar::Mist)] +
         amounts[static_cast<std::size_t>(AirScalar::Snow)] +
         amounts[static_cast<std::size_t>(AirScalar::Vapour)];
}

/// On its way between air and flow, kg.
double sprayMass(const CloudReport& r) {
  double sum = 0.0;
  for (const SprayParcel& p : r.state.parcels)
    sum += static_cast<double>(p.units) * kGivenUnit * r.scene.flow.particleMass(p.material);
  for (const FlowParticle& p : r.coupling.rejoining)
    sum += (1.0 - p.given) * r.scene.flow.particleMass(p.material);
  for (const FlowParticle& p : r.coupling.refused)
    sum += (1.0 - p.given) * r.scene.flow.particleMass(p.material);
  return sum;
}

void publishBudget(const CloudReport& r, MassBudget& budget) {
  const AirBudget air = r.air.budget();
  const CloudAccount& account = r.state.account;
  double settling = 0.0;
  if (r.cover)
    for (const auto* list : {&r.cover->falling, &r.cover->refused})
      for (const SnowGrain& grain : *list) settling += grain.kilograms;
  budget.set("air_entered", true, waterOf(air.enteredSides) + waterOf(air.condensed));
  budget.set("air_present", false, waterOf(air.present));
  budget.set("air_left", false, waterOf(air.leftSides));
  budget.set("air_given_up", false, waterOf(air.givenUp));
  budget.set("air_ran_off", false, account.ranOff);
  budget.set("air_settling", false, settling);
  budget.set("air_on_things", false, account.onThings);
  budget.set("spray_present", false, sprayMass(r));
  budget.set("spray_left", false, account.sprayLeft);
}

void publishSteps(const CloudReport& r, std::map<std::string, double>& figures) {
  double steps = 0.0, solves = 0.0, iterations = 0.0, residual = 0.0, fastest = 0.0, missed = 0.0;
  for (const AirStep& s : r.steps) {
    steps += s.subSteps;
    solves += s.solves;
    iterations += s.iterations;
    residual = std::max(residual, s.residual);
    fastest = std::max(fastest, s.fastest);
    missed += s.reached ? 0.0 : 1.0;
  }
  figures["air_steps"] = steps;
  figures["air_iterations"] = iterations / std::max(solves, 1.0);
  figures["air_residual"] = residual;
  figures["air_max_speed_m_s"] = fastest;
  if (missed > 0.0) figures["air_steps_not_solved"] = missed;
}

}  // namespace

void publishCloud(const CloudReport& r, Frame& frame) {
  auto part = std::make_shared<AirPart>();
  r.air.publish(true, *part);
  part->dropDiameter = r.settings.mistDiameter;
  part->snowDiameter = r.settings.grainDiameter;
  frame.parts["air"] = std::move(part);
  frame.parts["spray"] = sprayPart(r, frame.info.time.film);
  publishBudget(r, frame.info.budget);
  std::map<std::string, double>& figures = frame.info.figures;
  publishSteps(r, figures);
  const AirBudget budget = r.air.budget();
  figures["air_cells"] = static_cast<double>(r.air.cells());
  figures["air_cell_m"] = r.scene.air.cell;
  figures["air_mist_kg"] = budget.present[static_cast<std::size_t>(AirScalar::Mist)];
  figures["air_snow_kg"] = budget.present[static_cast<std::size_t>(AirScalar::Snow)];
  figures["air_settled_kg"] = r.state.account.settled;
  figures["spray_parcels"] = static_cast<double>(r.state.parcels.size());
  if (r.state.account.refused > 0) figures["spray_refused"] = static_cast<double>(r.state.account.refused);
}

}  // namespace spin
