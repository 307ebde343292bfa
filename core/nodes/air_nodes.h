// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/property/property_table.h"

namespace spin {

enum class AirScheme : std::uint8_t { SemiLagrangian, MacCormack, Cubic };
enum class AirPressureSolve : std::uint8_t { Multigrid, Jacobi, GaussSeidel };
enum class AirLift : std::uint8_t { HumidAir, StackedCells, FogDensity };

/// What hangs in the air over flow: mist of water, powder of snow, and the spray that flies between.
struct AirNode : NodeData {
  double cell = 0.0;             ///< m; 0 = four spacings of the flow
  double coupling = 1.0 / 24.0;  ///< s of film from one exchange with the flow to the next, at most
  AirScheme advection = AirScheme::MacCormack;
  bool reflection = true;
  AirPressureSolve solver = AirPressureSolve::Multigrid;
  double tolerance = 1e-3;
  AirLift lift = AirLift::HumidAir;
  double margin = 20.0;        ///< m, of the air's box round that of the flow
  double headroom = 20.0;      ///< m, of it above that of the flow
  double smallEddies = 0.17;   ///< C of eddies smaller than a cell (Smagorinsky 1963; Lilly 1967)
  double eddyViscosity = 0.0;  ///< m2/s, everywhere
  bool evaporates = true;

  double mistDiameter = 30e-6;       ///< m, of the droplets of mist
  double grainDiameter = 150e-6;     ///< m, of the grains of powder
  double waterTemperature = 277.15;  ///< K, of all water that flows
  bool waterWarms = true;            ///< water's surface and drops warm (or cool) and moisten the air

  double impactAcceleration = 100.0;  ///< m/s2
  double impactWater = 3e-6;          ///< share of a particle that turns to mist per m/s that an impact takes
  double impactSnow = 4e-3;           ///< the same of snow
  double mistSpeed = 6.0;             ///< m/s
  double mistRate = 1e-5;             ///< 1/s, share of the surface of water at three times that speed
  double powderSpeed = 8.0;           ///< m/s
  double powderRate = 0.05;           ///< 1/s, share of the surface of snow at three times that speed
  double mostGiven = 0.5;             ///< share that a particle in the flow gives at most

  bool spray = true;
  double lumpDiameter = 0.1;     ///< m, of water that leaves the flow; the air tears it to drops
  double dropDiameter = 2e-3;    ///< m, of drops; less where the air tears them
  double clumpDiameter = 20e-3;  ///< m, of snow
  double sprayLife = 3000.0;     ///< s in which drops fray into mist (to 1/e); lumps by their surface
  double clumpLife = 10.0;       ///< s in which clumps of snow fray into powder (to 1/e)
  double sprayRate = 0.2;        ///< 1/s, share of a particle that is thrown up where all potentials are 1
  double trappedLow = 3.0;       ///< m/s, mean speed at which neighbours come nearer
  double trappedHigh = 15.0;     ///< m/s
  double crestLow = 0.05;        ///< mean of 1 - cosine of the angle between normals
  double crestHigh = 0.25;       ///< the same
  double energyLow = 10.0;       ///< J/kg
  double energyHigh = 200.0;     ///< J/kg
  int mostDrops = 60000;         ///< parcels of spray
};
extern const NodeType kAirType;

}  // namespace spin
