// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/air/air_solver.h"
#include "core/cloud/surrounding_air.h"

namespace spin {

/// Water that air passes.
struct WaterContact {
  Vec3d position{};
  Vec3d velocity{};          ///< m/s: vapour has it when it leaves
  double conductance = 0.0;  ///< W/K of heat; that of vapour follows from it (Lewis number 1)
  double quantum = 0.0;      ///< kg; it gives and gets vapour in whole numbers of this; > 0
  double most = 0.0;         ///< kg that it can give, >= 0
  double room = 0.0;         ///< kg that it can get, >= 0
};

/// What water did to the air within some time.
struct ContactEffect {
  std::vector<AirSource> sources;  ///< warmth and vapour, a source per cell
  std::vector<double> vapour;      ///< kg that each contact gave; below 0 it got some
};

/// Heat and vapour between water of one temperature and the air of the cells that it is in. Per cell the air
/// goes towards the water's temperature and its saturation as exp(-time), so no step overshoots. The grid's
/// cells have edges of `cell` and begin at `origin`.
ContactEffect exchangeHeat(const std::vector<WaterContact>& contacts, const AirSolver& grid, Vec3d origin,
                           double cell, double waterTemperature, const SurroundingAir& air, double seconds);

}  // namespace spin
