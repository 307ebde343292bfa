// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/host_device.h"

/// SI everywhere; these convert at the user's edge. Constants with their sources.
namespace spin {

inline constexpr double kPi = 3.14159265358979323846;
/// Standard gravity, m/s2 (CGPM 1901).
inline constexpr double kStandardGravity = 9.80665;
/// 0 degrees Celsius in K.
inline constexpr double kZeroCelsius = 273.15;
/// Density of liquid water, kg/m3.
inline constexpr double kWaterDensity = 1000.0;
/// Density of ice, kg/m3.
inline constexpr double kIceDensity = 917.0;

SPIN_HD constexpr double celsiusToKelvin(double celsius) {
  return celsius + kZeroCelsius;
}
SPIN_HD constexpr double kelvinToCelsius(double kelvin) {
  return kelvin - kZeroCelsius;
}
SPIN_HD constexpr double degreesToRadians(double degrees) {
  return degrees * (kPi / 180.0);
}
SPIN_HD constexpr double radiansToDegrees(double radians) {
  return radians * (180.0 / kPi);
}
/// Precipitation: 1 mm/h of water is 1 kg/m2 in 3600 s.
SPIN_HD constexpr double millimetresPerHourToSi(double mmPerHour) {
  return mmPerHour / 3600.0;
}
SPIN_HD constexpr double siToMillimetresPerHour(double kgPerM2S) {
  return kgPerM2S * 3600.0;
}

}  // namespace spin
