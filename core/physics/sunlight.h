// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/units.h"
#include "core/math/vec.h"

/// Where the sun stands, and what of its light reaches a slope.
namespace spin {

inline constexpr double kSolarConstant = 1361.0;  ///< W/m2 at the mean distance

struct Sun {
  Vec3d direction{0, 0, -1};    ///< unit vector towards it: x east, y north, z up
  double extraterrestrial = 0;  ///< W/m2 across its rays above the air
  bool isUp() const { return direction.z > 0.0; }
};

/// The sun at a time (s from 1970-01-01 00:00 UTC) and place (rad, north and east positive): low-precision
/// formulae of the Astronomical Almanac, 0.01 degrees between 1950 and 2050.
inline Sun sunAt(double time, double latitude, double longitude) {
  const double days = time / 86400.0 - 10957.5;  // from the epoch J2000
  const double anomaly = degreesToRadians(357.528 + 0.9856003 * days);
  const double mean = 280.460 + 0.9856474 * days;
  const double ecliptic =
      degreesToRadians(mean + 1.915 * std::sin(anomaly) + 0.020 * std::sin(2.0 * anomaly));
  const double obliquity = degreesToRadians(23.439 - 4e-7 * days);
  const double declination = std::asin(std::sin(obliquity) * std::sin(ecliptic));
  const double ascension = std::atan2(std::cos(obliquity) * std::sin(ecliptic), std::cos(ecliptic));
  const double sidereal = degreesToRadians(280.46062 + 360.98564737 * days);
  const double hourAngle = sidereal + longitude - ascension;
  Sun sun;
  sun.direction.x = -std::cos(declination) * std::sin(hourAngle);
  sun.direction.y = std::cos(latitude) * std::sin(declination) -
                    std::sin(latitude) * std::cos(declination) * std::cos(hourAngle);
  sun.direction.z = std::sin(latitude) * std::sin(declination) +
                    std::cos(latitude) * std::cos(declination) * std::cos(hourAngle);
  const double distance = 1.00014 - 0.01671 * std::cos(anomaly) - 0.00014 * std::cos(2.0 * anomaly);
  sun.extraterrestrial = kSolarConstant / (distance * distance);
  return sun;
}

struct Shortwave {
  double direct = 0.0, diffuse = 0.0;  ///< W/m2 on level ground
};

/// Parts of what a pyranometer on level ground measures, by its clearness (Erbs, Klein and Duffie 1982).
/// sunSine: mean of the sun's height over the step, as its sine; at or below 0 all light is diffuse.
inline Shortwave splitShortwave(double global, double sunSine, double extraterrestrial) {
  // Near the horizon the quotient is that of two small numbers, and the air has scattered the beam.
  if (!(sunSine > 0.02) || !(global > 0.0)) return {0.0, std::max(global, 0.0)};
  const double k = std::clamp(global / (extraterrestrial * sunSine), 0.0, 1.0);
  double diffuse = 0.165;
  if (k <= 0.22)
    diffuse = 1.0 - 0.09 * k;
  else if (k <= 0.8)
    diffuse = 0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)));
  return {global * (1.0 - diffuse), global * diffuse};
}

/// Direct light on a slope over that on level ground; 0 where the slope turns away. Held at the factor that
/// a sun at 3 degrees would give.
inline double slopeBeamFactor(Vec3d normal, Vec3d towardsSun) {
  if (towardsSun.z <= 0.0) return 0.0;
  return std::max(dot(normal, towardsSun), 0.0) / std::max(towardsSun.z, 0.05);
}

}  // namespace spin
