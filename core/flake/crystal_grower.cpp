// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/crystal_grower.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/base/check.h"

namespace spin {
namespace {

constexpr std::array<std::array<int, 2>, 6> kSides{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};

/// The image of a cell in the sector i >= j >= 0.
std::array<int, 2> folded(int i, int j) {
  std::array<int, 3> sides{std::abs(i), std::abs(j), std::abs(i + j)};
  std::sort(sides.begin(), sides.end());
  // The largest is the sum of the other two.
  return {sides[1], sides[0]};
}

}  // namespace

CrystalLaw crystalLaw(CrystalHabit habit) {
  switch (habit) {
    case CrystalHabit::Fern:
      return {0.45, 1.05, 0.08, 0.025, 0.003, 0.12, 5e-5};
    case CrystalHabit::Broad:
      return {0.65, 1.7, 0.08, 0.025, 0.003, 0.06, 5e-5};
    case CrystalHabit::Plate:
      return {0.45, 1.3, 0.08, 0.025, 0.003, 0.12, 5e-5};
    case CrystalHabit::Stellar:
      break;
  }
  return {0.45, 1.3, 0.08, 0.025, 0.003, 0.06, 5e-5};
}

Status checkCrystalSettings(const CrystalSettings& settings) {
  const auto refuse = [](const char* where, const std::string& why) {
    return badInput("The crystal cannot be grown", where, why);
  };
  const CrystalLaw& law = settings.law;
  const auto share = [](double x, double most) { return x >= 0.0 && x <= most; };  // a NaN is none
  if (!share(law.vapour, 1.0) || law.vapour < 0.05) return refuse("vapour", "it must lie between 0.05 and 1");
  if (!share(law.tipMass, 5.0) || law.tipMass < 1.0) return refuse("tip_mass", "it must lie between 1 and 5");
  if (!share(law.hollowMass, 1.0) || !share(law.scarce, 1.0))
    return refuse("hollow_mass", "hollow mass and scarcity must lie between 0 and 1");
  if (!share(law.freezing, 0.5) || !share(law.melting, 0.5) || !share(law.sublimation, 0.5))
    return refuse("freezing", "freezing, melting and sublimation must lie between 0 and 0.5");
  if (settings.cells < 8 || settings.cells > 1000)
    return refuse("cells", fmt::format("{} is not between 8 and 1000", settings.cells));
  if (!(settings.weather >= 0.0 && settings.weather <= 1.0))
    return refuse("weather", fmt::format("{:g} is not between 0 and 1", settings.weather));
  if (settings.mostSteps < 1) return refuse("most_steps", fmt::format("{} is below 1", settings.mostSteps));
  return {};
}

CrystalGrower::CrystalGrower(const CrystalSettings& settings) : m_settings(settings), m_law(settings.law) {
  SPIN_CHECK(checkCrystalSettings(settings).ok(), "a crystal of unchecked settings");
  // Vapour must come from farther away than the tips, or the arms feel the rim.
  m_rings = settings.cells + settings.cells / 3 + 4;
  buildSector();
  changeWeather();
  m_frozen[0] = 1;
  m_ice[0] = 1.0;
  m_vapour[0] = 0.0;
  addIce(0);
}

void CrystalGrower::buildSector() {
  for (int i = 0; i <= m_rings; ++i) {
    m_firstOfRow.push_back(static_cast<std::int32_t>(m_ring.size()));
    for (int j = 0; j <= std::min(i, m_rings - i); ++j) {
      m_ring.push_back(i + j);
      m_share.push_back(i == 0 ? 1.0 : (j == 0 || i == j) ? 6.0 : 12.0);
    }
  }
  const std::size_t cells = m_ring.size();
  for (int i = 0; i <= m_rings; ++i)
    for (int j = 0; j <= std::min(i, m_rings - i); ++j) {
      auto& sides = m_neighbours.emplace_back();
      for (std::size_t s = 0; s < 6; ++s) {
        const std::int32_t k = indexOf(i + kSides[s][0], j + kSides[s][1]);
        sides[s] = k == kNone ? static_cast<std::int32_t>(cells) : k;
      }
    }
  m_vapour.assign(cells + 1, m_law.vapour);
  m_next = m_vapour;
  m_boundary.assign(cells + 1, 0.0);
  m_ice = m_boundary;
  m_frozen.assign(cells + 1, 0);
  m_touched = m_frozen;
}

std::int32_t CrystalGrower::indexOf(int i, int j) const {
  const auto [a, b] = folded(i, j);
  return a + b > m_rings ? kNone : m_firstOfRow[static_cast<std::size_t>(a)] + b;
}

bool CrystalGrower::frozen(int i, int j) const {
  const std::int32_t k = indexOf(i, j);
  return k != kNone && m_frozen[static_cast<std::size_t>(k)];
}

double CrystalGrower::thickness(int i, int j) const {
  return frozen(i, j) ? m_ice[static_cast<std::size_t>(indexOf(i, j))] : 0.0;
}

int CrystalGrower::iceCells() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < m_share.size(); ++k) sum += m_frozen[k] ? m_share[k] : 0.0;
  return static_cast<int>(sum);
}

double CrystalGrower::totalMass() const {
  double sum = 0.0;
  for (std::size_t k = 0; k < m_share.size(); ++k)
    sum += m_share[k] * (m_vapour[k] + m_boundary[k] + m_ice[k]);
  return sum;
}

double CrystalGrower::progress() const {
  const double bySteps = static_cast<double>(m_steps) / m_settings.mostSteps;
  return std::min(std::max(bySteps, static_cast<double>(m_reach) / m_settings.cells), 1.0);
}

Status CrystalGrower::grow(int steps, const CancelToken& cancel) {
  for (int s = 0; s < steps && !done(); ++s) {
    if (cancel.cancelled())
      return Error{ErrorKind::Cancelled, "The crystal stopped growing", "crystal", "it was cancelled", ""};
    changeWeather();
    diffuse();
    freeze();
    attach();
    melt();
    ++m_steps;
  }
  return {};
}

/// A crystal meets other air every few cells of its growth; that air is the same for all its arms.
void CrystalGrower::changeWeather() {
  const int spell = m_reach / std::max(m_settings.cells / 9, 4);
  if (spell == m_spell) return;
  m_spell = spell;
  const UInt4 w = CounterRandom{m_settings.seed, 0x63727973u}.words(static_cast<std::uint64_t>(spell));
  const auto swing = [&](std::uint32_t word) {
    return 1.0 + m_settings.weather * (2.0 * static_cast<double>(toUnitFloat(word)) - 1.0);
  };
  const CrystalLaw& law = m_settings.law;
  m_law.tipMass = 1.0 + (law.tipMass - 1.0) * swing(w.x);
  m_law.freezing = law.freezing * swing(w.y);
  m_law.melting = law.melting * swing(w.z);
  m_law.hollowMass = law.hollowMass * swing(w.w);
}

/// Every cell outside the ice takes the mean of itself and its neighbours; ice gives back what comes.
void CrystalGrower::diffuse() {
  const std::size_t cells = m_neighbours.size();
  for (std::size_t k = 0; k < cells; ++k) {
    m_next[k] = 0.0;
    if (m_frozen[k]) continue;
    const double own = m_vapour[k];
    double sum = own;
    for (const std::int32_t side : m_neighbours[k]) {
      const auto s = static_cast<std::size_t>(side);
      sum += m_frozen[s] ? own : m_vapour[s];
    }
    m_next[k] = sum * (1.0 / 7.0);
  }
  m_vapour.swap(m_next);
}

void CrystalGrower::freeze() {
  for (const std::int32_t cell : m_edge) {
    const auto k = static_cast<std::size_t>(cell);
    m_boundary[k] += (1.0 - m_law.freezing) * m_vapour[k];
    m_ice[k] += m_law.freezing * m_vapour[k];
    m_vapour[k] = 0.0;
  }
}

void CrystalGrower::attach() {
  m_joining.clear();
  for (const std::int32_t cell : m_edge) {
    const auto k = static_cast<std::size_t>(cell);
    int sides = 0;
    double vapour = m_vapour[k];
    for (const std::int32_t side : m_neighbours[k]) {
      sides += m_frozen[static_cast<std::size_t>(side)];
      vapour += m_frozen[static_cast<std::size_t>(side)] ? 0.0 : m_vapour[static_cast<std::size_t>(side)];
    }
    const double mass = m_boundary[k];
    const bool hollow = sides == 3 && (mass >= 1.0 || (vapour < m_law.scarce && mass >= m_law.hollowMass));
    if (sides >= 4 || hollow || (sides <= 2 && mass >= m_law.tipMass)) m_joining.push_back(cell);
  }
  for (const std::int32_t cell : m_joining) {
    const auto k = static_cast<std::size_t>(cell);
    m_frozen[k] = 1;
    m_ice[k] += m_boundary[k];
    m_boundary[k] = 0.0;
    m_reach = std::max(m_reach, static_cast<int>(m_ring[k]));
  }
  for (const std::int32_t cell : m_joining) addIce(cell);
  if (!m_joining.empty())
    std::erase_if(m_edge, [&](std::int32_t cell) { return m_frozen[static_cast<std::size_t>(cell)] != 0; });
}

void CrystalGrower::melt() {
  for (const std::int32_t cell : m_edge) {
    const auto k = static_cast<std::size_t>(cell);
    m_vapour[k] += m_law.melting * m_boundary[k] + m_law.sublimation * m_ice[k];
    m_boundary[k] *= 1.0 - m_law.melting;
    m_ice[k] *= 1.0 - m_law.sublimation;
  }
}

/// The neighbours of new ice that are not ice become its edge.
void CrystalGrower::addIce(std::int32_t cell) {
  for (const std::int32_t side : m_neighbours[static_cast<std::size_t>(cell)]) {
    const auto s = static_cast<std::size_t>(side);
    if (s == m_neighbours.size() || m_frozen[s] || m_touched[s]) continue;
    m_touched[s] = 1;
    m_edge.push_back(side);
  }
}

}  // namespace spin
