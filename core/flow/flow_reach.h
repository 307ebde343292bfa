// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/fields/raster.h"

namespace spin {

/// Where flow begins: a place and its height of energy, m.
struct FlowStart {
  double x = 0.0, y = 0.0;
  double energy = 0.0;  ///< height + depth + v^2 / 2g
};

/// Ground that flow can come to, and how fast it can be there.
struct FlowReach {
  Box3d box;               ///< of the ground reached, m; empty if there is none
  double speedHead = 0.0;  ///< largest height of energy above the ground, m
};

/// Spreads from the starts over the ground; per metre of way `loss` metres of energy are lost (the tangent of
/// the energy line, Heim 1932), and no cell is entered above the energy line. Large rasters are taken in
/// steps of several cells.
FlowReach findReach(const Raster<float>& heights, const std::vector<FlowStart>& starts, double loss);

}  // namespace spin
