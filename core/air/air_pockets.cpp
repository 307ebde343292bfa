// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_pockets.h"

#include <algorithm>
#include <numeric>

namespace spin {
namespace {

/// Sets that are joined; a set's number is the least of its members.
class JoinedSets {
 public:
  std::uint32_t add() {
    m_parent.push_back(static_cast<std::uint32_t>(m_parent.size()));
    return m_parent.back();
  }
  std::uint32_t find(std::uint32_t k) {
    while (m_parent[k] != k) k = m_parent[k] = m_parent[m_parent[k]];
    return k;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) m_parent[std::max(a, b)] = std::min(a, b);
  }
  std::size_t size() const { return m_parent.size(); }

 private:
  std::vector<std::uint32_t> m_parent;
};

constexpr std::array<int, 3> kAlong{kBrickX, kBrickY, kBrickZ};
constexpr std::array<int, 3> kStep{1, kBrickX, kBrickX* kBrickY};
constexpr std::uint32_t kNone = UINT32_MAX;

/// Sets of one brick: one for all cells of an open one, else one per cell to begin with.
struct BrickSets {
  std::uint32_t first = 0;
  bool single = true;
  std::uint32_t of(std::size_t cell) const {
    return single ? first : first + static_cast<std::uint32_t>(cell);
  }
};

class PocketFinder {
 public:
  PocketFinder(const AirWindow& window, const std::vector<BrickSolids>& solids)
      : m_window(window), m_solids(solids) {
    for (const BrickKey& key : window.keys()) m_own.push_back(&solidsOf(key));
    for (const BrickSolids* own : m_own) {
      BrickSets sets{static_cast<std::uint32_t>(m_sets.size()), own->open};
      for (std::size_t cell = 0; cell < (own->open ? 1 : kBrickCells); ++cell) m_sets.add();
      m_bricks.push_back(sets);
    }
    m_outside = m_sets.add();
    for (std::size_t b = 0; b < m_bricks.size(); ++b)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!m_bricks[b].single) joinWithin(b, axis);
        joinAcross(b, axis);
      }
  }

  AirPockets pockets() {
    const std::uint32_t outside = m_sets.find(m_outside);
    std::vector<std::uint32_t> numberOf(m_sets.size(), kNone);
    AirPockets found;
    for (std::size_t b = 0; b < m_bricks.size(); ++b) {
      if (m_bricks[b].single && m_sets.find(m_bricks[b].first) == outside) continue;
      for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
        const std::uint32_t set = m_sets.find(m_bricks[b].of(cell));
        if (set == outside || m_own[b]->volume[cell] <= 0.0f) continue;
        if (numberOf[set] == kNone) {
          numberOf[set] = static_cast<std::uint32_t>(found.size());
          found.emplace_back();
        }
        found[numberOf[set]].push_back(indexOf(b, cell));
      }
    }
    return found;
  }

 private:
  const BrickSolids& solidsOf(const BrickKey& key) const {
    return m_solids[static_cast<std::size_t>(m_window.nearPlace(key))];
  }
  std::uint32_t indexOf(std::size_t b, std::size_t cell) const {
    const AirStrides s = m_window.strides();
    const int c = static_cast<int>(cell);
    return static_cast<std::uint32_t>(m_window.active()[b].first + c % kBrickX + c / kBrickX % kBrickY * s.y +
                                      c / kStep[2] * s.z);
  }
  static int placeAlong(std::size_t cell, std::size_t axis) {
    return static_cast<int>(cell) / kStep[axis] % kAlong[axis];
  }
  void joinWithin(std::size_t b, std::size_t axis) {
    for (std::size_t cell = 0; cell < kBrickCells; ++cell)
      if (placeAlong(cell, axis) > 0 && m_own[b]->area[axis][cell] > 0.0f)
        m_sets.join(m_bricks[b].of(cell), m_bricks[b].of(cell - static_cast<std::size_t>(kStep[axis])));
  }
  /// Over the brick's lower side, and over its upper one where no active brick is beyond.
  void joinAcross(std::size_t b, std::size_t axis) {
    BrickKey below = m_window.keys()[b], above = below;
    --below[axis];
    ++above[axis];
    const std::int32_t lower = m_window.activePlace(below);
    joinSide(b, axis, *m_own[b], lower);
    if (m_window.activePlace(above) < 0) joinUpper(b, axis, solidsOf(above));
  }
  void joinSide(std::size_t b, std::size_t axis, const BrickSolids& own, std::int32_t lower) {
    const auto far = static_cast<std::size_t>(kStep[axis] * (kAlong[axis] - 1));
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      if (placeAlong(cell, axis) > 0 || own.area[axis][cell] <= 0.0f) continue;
      const std::uint32_t there =
          lower < 0 ? m_outside : m_bricks[static_cast<std::size_t>(lower)].of(cell + far);
      m_sets.join(m_bricks[b].of(cell), there);
      if (m_bricks[b].single && (lower < 0 || m_bricks[static_cast<std::size_t>(lower)].single)) return;
    }
  }
  void joinUpper(std::size_t b, std::size_t axis, const BrickSolids& above) {
    const auto far = static_cast<std::size_t>(kStep[axis] * (kAlong[axis] - 1));
    for (std::size_t cell = 0; cell < kBrickCells; ++cell)
      if (placeAlong(cell, axis) == 0 && above.area[axis][cell] > 0.0f)
        m_sets.join(m_bricks[b].of(cell + far), m_outside);
  }

  const AirWindow& m_window;
  const std::vector<BrickSolids>& m_solids;
  std::vector<const BrickSolids*> m_own;  ///< by active brick
  JoinedSets m_sets;
  std::vector<BrickSets> m_bricks;
  std::uint32_t m_outside = 0;
};

}  // namespace

AirPockets findPockets(const AirWindow& window, const std::vector<BrickSolids>& solids) {
  return PocketFinder(window, solids).pockets();
}

}  // namespace spin
