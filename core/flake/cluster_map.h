// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/math/vec.h"

namespace spin {

/// Discs of diameter 1 in the plane, and what a walker among them asks: how far it may jump without touching
/// any, and what it touches on a short way. Two grids of bytes hold the distance to the nearest disc from
/// below, so that one look-up answers the first question; a disc that is added stamps its neighbourhood.
class ClusterMap {
 public:
  ClusterMap();

  /// Adds a disc by its centre.
  void add(Vec2d centre);
  const std::vector<Vec2d>& centres() const { return m_centres; }

  /// No centre is nearer to p than this; 0 in the cells round a disc. p no farther out than the outermost
  /// disc and 14 more.
  double clearance(Vec2d p) const;
  /// What a walker whose centre goes from p by a way of length 1 along the unit vector u touches first.
  struct Contact {
    int disc = -1;     ///< -1: nothing
    double way = 1.0;  ///< length of the way gone, 0..1
  };
  Contact firstContact(Vec2d p, Vec2d u) const;
  /// Whether a disc at p would overlap one that is there by more than rounding.
  bool overlaps(Vec2d p) const;

 private:
  static constexpr int kCoarse = 8;  ///< edge of a coarse cell in fine ones, which have the edge 1
  struct Grid {
    int half = 0;  ///< cells from the centre to each side
    std::vector<std::uint8_t> distance;
    std::size_t at(int i, int j) const {
      return static_cast<std::size_t>(j + half) * static_cast<std::size_t>(2 * half) +
             static_cast<std::size_t>(i + half);
    }
  };
  void resize(int half);
  void enter(int disc);
  static void stamp(Grid& grid, int i, int j);
  template <class F>
  void forDiscsNear(Vec2d p, int cells, const F& f) const;

  std::vector<Vec2d> m_centres;
  std::vector<std::int32_t> m_next;    ///< by disc: the one before in the same cell
  std::vector<std::int32_t> m_newest;  ///< by fine cell
  Grid m_fine, m_coarse;
};

}  // namespace spin
