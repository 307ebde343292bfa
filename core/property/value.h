// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/math/vec.h"

namespace spin {

/// Points in plan: local metres east and north, such as the corners of an area.
using PlanPoints = std::vector<Vec2d>;

/// What a property holds. Enumerations are std::int64_t, colours Vec3d (linear RGB), paths std::string with
/// '/'.
using Value = std::variant<bool, std::int64_t, double, Vec3d, std::string, PlanPoints>;

enum class PropertyKind { Bool, Int, Real, Vector, Colour, Choice, Points, Text, Path };

/// Units at the user's edge. Values are stored and computed in SI; displayed = si * scale + offset.
enum class Unit {
  None,
  Metre,
  Millimetre,
  MetrePerSecond,
  Degree,
  Kelvin,
  PrecipitationRate,
  KilogramPerCubicMetre,
  Second,
  PerSecond,
  Factor,
  Pixel,
  Byte,
  SquareMetrePerSecond,
  CubicMetrePerSecond,
  PascalSecond,
  Pascal,
  PerMetre,
  KelvinPerMetre,
  PercentPerHundredMetres,  ///< of a share per metre
  WattPerSquareMetre,
  KilogramPerSquareMetreDayKelvin,  ///< of kg/(m2 s K)
};

struct UnitInfo {
  const char* suffix;  ///< shown after the number: "mm/h"
  double scale;
  double offset;
};
UnitInfo unitInfo(Unit unit);
inline double toDisplay(Unit unit, double si) {
  return si * unitInfo(unit).scale + unitInfo(unit).offset;
}
inline double fromDisplay(Unit unit, double shown) {
  return (shown - unitInfo(unit).offset) / unitInfo(unit).scale;
}

/// Text form for the command line and messages: "true", "3", "0.25", "1 2 3", points as "1 2; 3 4", text as
/// is. Reals round-trip.
std::string toText(const Value& value);

}  // namespace spin
