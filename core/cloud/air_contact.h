// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/air/air_solver.h"
#include "core/cloud/surrounding_air.h"

namespace spin {

/// Water that air passes, or that has gone into the air.
struct WaterContact {
  Vec3d position{};
  Vec3d velocity{};          ///< m/s: vapour has it when it leaves
  double conductance = 0.0;  ///< W/K of heat; that of vapour follows from it (Lewis number 1)
  double mixes = 0.0;        ///< J/K, heat capacity of what has gone into the air
  double quantum = 1.0;      ///< kg; it gives and gets vapour in whole numbers of this; > 0
  double most = 0.0;         ///< kg that it can give, >= 0
  double room = 0.0;         ///< kg that it can get, >= 0
};

/// What water did to the air within some time.
struct ContactEffect {
  std::vector<AirSource> sources;  ///< warmth and vapour, a source per cell
  std::vector<double> vapour;      ///< kg that each contact gave; below 0 it got some
};

/// Heat and vapour between water of one temperature and the air of the cells that it is in. What has gone
/// into a cell shares its heat at once; then the air goes towards the water's temperature and its saturation
/// as exp(-time): neither is ever overshot, however much there is.
Result<ContactEffect> exchangeHeat(const std::vector<WaterContact>& contacts, AirSolver& grid,
                                   double waterTemperature, const SurroundingAir& air, double seconds);

}  // namespace spin
