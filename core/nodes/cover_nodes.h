// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/property/property_table.h"

namespace spin {

/// What becomes of snow that lies; the laws are those of core/physics.
enum class CoverLaw : std::uint8_t { EnergyBalance, DegreeDay, Published, Lies };

/// How the snow cover ages and melts.
struct SnowCoverNode : NodeData {
  CoverLaw law = CoverLaw::EnergyBalance;
  double degreeDayFactor = 4.0 / 86400.0;  ///< kg/(m2 s K)
  double degreeDayThreshold = 273.15;      ///< K
  double freshAlbedo = 0.85;
  double oldAlbedo = 0.5;
  double windHeight = 10.0;       ///< m above the surface at which the wind is measured
  double airHeight = 2.0;         ///< m, of temperature and humidity
  bool slopesAndShadow = true;    ///< sun and sky by slope and horizon; off: everything lies level and open
  double horizonReach = 10000.0;  ///< m within which mountains shade
};
extern const NodeType kSnowCoverType;

/// Warm ground: a hot spring, a pipe below a path, an outlet.
struct HeatSourceNode : NodeData {
  Vec3d position{};      ///< m, local; z does not count
  double radius = 5.0;   ///< m; the heat fades to its edge
  double power = 100.0;  ///< W/m2 into the ground at the centre
};
extern const NodeType kHeatSourceType;

}  // namespace spin
