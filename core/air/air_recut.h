// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "core/air/air_exchange.h"

namespace spin {

/// Bricks as they were before solids moved, by their place in AirWindow::nearKeys().
using BricksBefore = std::map<std::size_t, BrickSolids>;

/// Where the content of cells goes whose volume solids have changed: it stays in them, and what was in cells
/// that have closed goes on through the faces that were open, to the nearest cells that still are.
struct RecutPlan {
  static constexpr std::uint32_t kLost = UINT32_MAX;
  struct Gift {
    std::uint32_t from, to;  ///< in the lists below; kLost: no open cell is within reach
    double share;            ///< of all that `from` holds by then
  };
  std::vector<std::uint32_t> index;         ///< of cells in the window's arrays
  std::vector<double> volume, volumeAfter;  ///< open shares before and after
  std::vector<Gift> gifts;                  ///< in the order of giving; of a cell all together
};

RecutPlan planRecut(const AirWindow& window, const std::vector<BrickSolids>& solids,
                    const BricksBefore& before);

/// Turns the cells' values per volume into those afterwards and returns what is lost, in cells' volumes.
/// `mixes`: what comes into a cell mixes with what is there, as warmth does, and is not pressed into its
/// volume; the rest is lost too.
double applyRecut(const RecutPlan& plan, bool mixes, std::vector<float>& values);

}  // namespace spin
