// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/air_contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/physics/humid_air.h"

namespace spin {

Result<ContactEffect> exchangeHeat(const std::vector<WaterContact>& contacts, AirSolver& grid,
                                   double waterTemperature, const SurroundingAir& air, double seconds) {
  std::vector<Vec3d> places;
  for (const WaterContact& c : contacts) places.push_back(c.position);
  const Result<std::vector<AirCellNow>> cells = grid.cellsAt(places);
  if (!cells) return cells.error();
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return (*cells)[a].cell < (*cells)[b].cell; });
  const double warmer = waterTemperature - air.temperature, moister = air.excessOver(waterTemperature);
  ContactEffect effect;
  effect.vapour.assign(contacts.size(), 0.0);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const AirCellNow& here = (*cells)[order[begin]];
    double conductance = 0.0, mixes = 0.0;
    for (end = begin; end < order.size() && (*cells)[order[end]].cell == here.cell; ++end) {
      conductance += contacts[order[end]].conductance;
      mixes += contacts[order[end]].mixes;
    }
    if (!(here.volume > 0.0)) continue;
    const double capacity = air.carrier.density * kDryAirHeat * here.volume;
    const double warmth = here.densities[static_cast<std::size_t>(AirScalar::Warmth)];
    const double mixed = warmth + (warmer - warmth) * mixes / (capacity + mixes);
    const double share = -std::expm1(-conductance * seconds / capacity);
    AirSource source;
    source.position = contacts[order[begin]].position;
    source.amounts[static_cast<std::size_t>(AirScalar::Warmth)] =
        (mixed + share * (warmer - mixed) - warmth) * here.volume;
    const double vapour = here.densities[static_cast<std::size_t>(AirScalar::Vapour)];
    double kilograms = 0.0;
    for (std::size_t m = begin; m < end && conductance > 0.0; ++m) {
      const WaterContact& c = contacts[order[m]];
      const double wanted = share * (moister - vapour) * here.volume * c.conductance / conductance;
      const double own = std::clamp(wanted, -c.room, c.most);
      effect.vapour[order[m]] = std::trunc(own / c.quantum) * c.quantum;
      kilograms += effect.vapour[order[m]];
      source.impulse += c.velocity * effect.vapour[order[m]];
    }
    source.amounts[static_cast<std::size_t>(AirScalar::Vapour)] = kilograms;
    effect.sources.push_back(source);
  }
  return effect;
}

}  // namespace spin
