// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/air_contact.h"

#include <algorithm>
#include <cmath>
#include <compare>

#include "core/physics/humid_air.h"

namespace spin {
namespace {

struct CellKey {
  std::int32_t z, y, x;
  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

}  // namespace

ContactEffect exchangeHeat(const std::vector<WaterContact>& contacts, const AirSolver& grid, Vec3d origin,
                           double cell, double waterTemperature, const SurroundingAir& air, double seconds) {
  const auto index = [&](double p, double low) {
    return static_cast<std::int32_t>(std::floor((p - low) / cell));
  };
  const auto centreOf = [&](const CellKey& k) {
    return origin + Vec3d{k.x + 0.5, k.y + 0.5, k.z + 0.5} * cell;
  };
  std::vector<std::pair<CellKey, std::size_t>> order;
  order.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3d p = contacts[k].position;
    order.push_back({{index(p.z, origin.z), index(p.y, origin.y), index(p.x, origin.x)}, k});
  }
  std::sort(order.begin(), order.end());
  const double volume = cell * cell * cell, capacity = air.carrier.density * kDryAirHeat * volume;
  const double warmer = waterTemperature - air.temperature, moister = air.excessOver(waterTemperature);
  ContactEffect effect;
  effect.vapour.assign(contacts.size(), 0.0);
  std::vector<Vec3d> places;
  for (std::size_t k = 0; k < order.size(); ++k)
    if (k == 0 || order[k].first != order[k - 1].first) places.push_back(centreOf(order[k].first));
  const std::vector<AirAmounts> now = grid.densities(places);
  std::size_t number = 0;
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const AirAmounts& here = now[number++];
    double conductance = 0.0;
    for (end = begin; end < order.size() && order[end].first == order[begin].first; ++end)
      conductance += contacts[order[end].second].conductance;
    if (!(conductance > 0.0)) continue;
    const double warmth = here[static_cast<std::size_t>(AirScalar::Warmth)];
    const double vapour = here[static_cast<std::size_t>(AirScalar::Vapour)];
    const double share = -std::expm1(-conductance * seconds / capacity);
    AirSource source;
    source.position = centreOf(order[begin].first);
    source.amounts[static_cast<std::size_t>(AirScalar::Warmth)] = share * (warmer - warmth) * volume;
    const double wanted = share * (moister - vapour) * volume / conductance;
    double kilograms = 0.0;
    for (std::size_t m = begin; m < end; ++m) {
      const WaterContact& c = contacts[order[m].second];
      const double own = std::clamp(wanted * c.conductance, -c.room, c.most);
      effect.vapour[order[m].second] = std::trunc(own / c.quantum) * c.quantum;
      kilograms += effect.vapour[order[m].second];
      source.impulse += c.velocity * effect.vapour[order[m].second];
    }
    source.amounts[static_cast<std::size_t>(AirScalar::Vapour)] = kilograms;
    effect.sources.push_back(source);
  }
  return effect;
}

}  // namespace spin
