// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flake/cluster_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spin {
namespace {

constexpr int kReach = 15;            // cells that a stamp reaches to each side
constexpr int kRow = 2 * kReach + 2;  // bytes of a stamp's row; a constant multiple of 16 vectorises
constexpr double kUnit = 8.0;         // steps of the stored distance to a cell
constexpr std::uint8_t kBeside = 1;   // for 0 steps
constexpr std::uint8_t kFar = 255;    // farther than any stamp
constexpr int kMargin = kReach + 2;   // cells beyond the outermost disc, for stamps and walkers
constexpr double kOverlap = 1.0 - 1e-9;

using Stamp = std::array<std::uint8_t, static_cast<std::size_t>(kRow) * (2 * kReach + 1)>;

/// Least distance of two points in cells that are (dx, dy) apart, in steps, rounded down; 0 only for the cell
/// itself, so that a cell that holds a disc is told from one beside it, which has kBeside.
Stamp makeStamp() {
  Stamp stamp{};
  for (int dy = -kReach; dy <= kReach; ++dy)
    for (int dx = -kReach; dx <= kReach + 1; ++dx) {
      const double x = std::max(std::abs(dx) - 1, 0), y = std::max(std::abs(dy) - 1, 0);
      const double steps = kUnit * std::sqrt(x * x + y * y);
      // Only what lies within the stamp's circle may be told: beyond it a disc outside the stamp may be
      // nearer.
      stamp[static_cast<std::size_t>((dy + kReach) * kRow + dx + kReach)] =
          steps < kUnit * (kReach - 1) ? std::max(static_cast<std::uint8_t>(steps), kBeside) : kFar;
    }
  stamp[static_cast<std::size_t>(kReach * kRow + kReach)] = 0;
  return stamp;
}

int cellOf(double x) {
  return static_cast<int>(std::floor(x));
}

}  // namespace

ClusterMap::ClusterMap() {
  resize(4 * kCoarse);
}

void ClusterMap::resize(int half) {
  m_fine.half = half;
  m_coarse.half = half / kCoarse + kMargin;
  const auto cells = [](const Grid& g) {
    return 4 * static_cast<std::size_t>(g.half) * static_cast<std::size_t>(g.half);
  };
  m_fine.distance.assign(cells(m_fine), kFar);
  m_coarse.distance.assign(cells(m_coarse), kFar);
  m_newest.assign(cells(m_fine), -1);
  for (std::size_t k = 0; k < m_centres.size(); ++k) enter(static_cast<int>(k));
}

void ClusterMap::add(Vec2d centre) {
  m_centres.push_back(centre);
  m_next.push_back(-1);
  // Walkers come from a circle, so what counts is the distance from the middle, not from the sides.
  const double reach = std::sqrt(centre.x * centre.x + centre.y * centre.y);
  if (reach + kMargin + 1.0 < m_fine.half) {
    enter(static_cast<int>(m_centres.size()) - 1);
    return;
  }
  const int needed = static_cast<int>(1.4 * reach) + 2 * kMargin;
  resize((needed / kCoarse + 1) * kCoarse);
}

void ClusterMap::enter(int disc) {
  const Vec2d p = m_centres[static_cast<std::size_t>(disc)];
  const int i = cellOf(p.x), j = cellOf(p.y);
  std::int32_t& newest = m_newest[m_fine.at(i, j)];
  m_next[static_cast<std::size_t>(disc)] = newest;
  if (newest < 0) {
    stamp(m_fine, i, j);
    const int ci = cellOf(p.x / kCoarse), cj = cellOf(p.y / kCoarse);
    if (m_coarse.distance[m_coarse.at(ci, cj)] != 0) stamp(m_coarse, ci, cj);
  }
  newest = disc;
}

void ClusterMap::stamp(Grid& grid, int i, int j) {
  static const Stamp kStamp = makeStamp();
  for (int dy = -kReach; dy <= kReach; ++dy) {
    std::uint8_t* __restrict row = grid.distance.data() + grid.at(i - kReach, j + dy);
    const std::uint8_t* __restrict mask = kStamp.data() + static_cast<std::size_t>((dy + kReach) * kRow);
    for (int k = 0; k < kRow; ++k) row[k] = row[k] < mask[k] ? row[k] : mask[k];
  }
}

double ClusterMap::clearance(Vec2d p) const {
  const std::uint8_t fine = m_fine.distance[m_fine.at(cellOf(p.x), cellOf(p.y))];
  if (fine <= kBeside) return 0.0;
  if (fine != kFar) return fine / kUnit;
  const std::uint8_t coarse = m_coarse.distance[m_coarse.at(cellOf(p.x / kCoarse), cellOf(p.y / kCoarse))];
  const double far = coarse == kFar ? kReach - 1.0 : coarse / kUnit;
  return std::max(kReach - 1.0, kCoarse * far);
}

template <class F>
void ClusterMap::forDiscsNear(Vec2d p, int cells, const F& f) const {
  const int i = cellOf(p.x), j = cellOf(p.y);
  for (int y = j - cells; y <= j + cells; ++y)
    for (int x = i - cells; x <= i + cells; ++x)
      for (std::int32_t k = m_newest[m_fine.at(x, y)]; k >= 0; k = m_next[static_cast<std::size_t>(k)]) f(k);
}

ClusterMap::Contact ClusterMap::firstContact(Vec2d p, Vec2d u) const {
  Contact first;
  // Centres that a walker can touch are nearer than 2.
  forDiscsNear(p, 2, [&](std::int32_t k) {
    const Vec2d away = p - m_centres[static_cast<std::size_t>(k)];
    const double along = u.x * away.x + u.y * away.y;
    const double rest = along * along - (away.x * away.x + away.y * away.y - 1.0);
    if (along >= 0.0 || rest < 0.0) return;
    const double way = std::max(-along - std::sqrt(rest), 0.0);
    if (way < first.way) first = {k, way};
  });
  return first;
}

bool ClusterMap::overlaps(Vec2d p) const {
  bool found = false;
  forDiscsNear(p, 1, [&](std::int32_t k) {
    const Vec2d away = p - m_centres[static_cast<std::size_t>(k)];
    found = found || away.x * away.x + away.y * away.y < kOverlap * kOverlap;
  });
  return found;
}

}  // namespace spin
