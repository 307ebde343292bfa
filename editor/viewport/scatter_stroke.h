// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/property/value.h"

namespace spin {

/// Points in plan by square cells, to ask what lies near.
class PlanGrid {
 public:
  explicit PlanGrid(double cellSize) : m_cellSize(cellSize) {}
  void add(Vec2d p) { m_cells[keyAt(p)].push_back(p); }
  /// Whether a point lies nearer than a distance that is at most the cell size.
  bool anyNearer(Vec2d p, double distance) const;
  bool anyInCell(Vec2d p) const { return m_cells.count(keyAt(p)) > 0; }
  std::uint64_t keyAt(Vec2d p) const;
  static std::uint64_t keyOf(std::int64_t i, std::int64_t j);

 private:
  double m_cellSize;
  std::unordered_map<std::uint64_t, std::vector<Vec2d>> m_cells;
};

/// What a stroke of copies works with.
struct ScatterTask {
  bool erase = false;
  double radius = 12.0;                 ///< m
  double density = 0.02;                ///< copies per m2 that a stroke fills up to; > 0
  double distance = 2.0;                ///< m, between copies at least; 0 = no limit
  std::uint64_t seed = 1;               ///< of the places
  std::size_t most = 100'000;           ///< copies there may be
  Vec2d own{};                          ///< where the model itself stands
  std::function<bool(Vec2d)> isGround;  ///< whether a copy may stand there; null = everywhere
};

/// One stroke that scatters copies of a model, or takes them away. The plane is cut into squares that hold
/// one copy at the wanted density, each with places of its own by the seed; a square is filled when the tip
/// passes its first place, unless a copy stands in it already. So going over it again adds nothing, and the
/// result does not depend on how often the pointer reports. A first touch that meets no place puts one copy
/// under the pointer, so that single ones can be set.
class ScatterStroke {
 public:
  ScatterStroke(PlanPoints copies, ScatterTask task);

  /// Scatters from the last position (or at this one, for the first) to here; local metres. True if copies
  /// came or went.
  bool moveTo(Vec2d position);
  const PlanPoints& copies() const { return m_copies; }
  /// Copies that came, or went if below 0.
  int change() const { return static_cast<int>(m_copies.size()) - m_before; }
  bool full() const { return m_copies.size() >= m_task.most; }

 private:
  struct Square {
    double when;  ///< share of the way at which the tip gets there
    std::int64_t i, j;
  };
  bool eraseAlong(Vec2d from, Vec2d to);
  std::vector<Square> squaresAlong(Vec2d from, Vec2d to);
  bool fill(const Square& square, Vec2d from, Vec2d to);
  bool place(Vec2d p);
  Vec2d placeIn(std::int64_t i, std::int64_t j, std::uint32_t attempt) const;

  PlanPoints m_copies;
  ScatterTask m_task;
  int m_before;
  double m_side;                               ///< of a square, m
  PlanGrid m_squares;                          ///< what stands in each square
  PlanGrid m_near;                             ///< for the least distance
  std::unordered_set<std::uint64_t> m_passed;  ///< squares that this stroke has dealt with
  std::optional<Vec2d> m_last;
};

}  // namespace spin
