// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"

namespace spin {

/// Fall speed and mass of one type of falling snow by its largest dimension D:
///   v_t = speedFactor (D/mm)^speedExponent m/s,   m = massFactor (D/mm)^massExponent mg.
/// Source: Locatelli and Hobbs 1974, "Fall speeds and masses of solid precipitation particles", table 1
/// (p. 2188). Speeds hold from 2 to 10, 2 to 12 and 0.8 to 2.8 mm for the three types. Beyond the sizes
/// measured there the mass law would make flakes thinner than any seen (half a
/// metre across at 0.4 g), so above largestMeasured mass and size are tied by a constant density instead.
struct FlakeFallLaw {
  double speedFactor = 0.8;
  double speedExponent = 0.16;
  double massFactor = 0.073;
  double massExponent = 1.4;
  double largestMeasured = 10e-3;  ///< m

  /// Terminal speed in still air, m/s; diameter in m, >= 0.
  SPIN_HD double terminalSpeed(double diameter) const {
    return speedFactor * std::pow(diameter * 1e3, speedExponent);
  }
  /// Mass in kg; diameter in m, >= 0.
  SPIN_HD double mass(double diameter) const {
    const double measured = std::fmin(diameter, largestMeasured);
    const double growth = diameter / std::fmax(measured, 1e-12);
    return 1e-6 * massFactor * std::pow(measured * 1e3, massExponent) *
           (diameter > largestMeasured ? growth * growth * growth : 1.0);
  }
  /// Largest dimension in m of a flake of this mass in kg; the inverse of mass().
  SPIN_HD double diameterOfMass(double kilograms) const {
    const double largest = mass(largestMeasured);
    if (kilograms > largest) return largestMeasured * std::cbrt(kilograms / largest);
    return 1e-3 * std::pow(kilograms * 1e6 / massFactor, 1.0 / massExponent);
  }
};

/// "Aggregates of unrimed radiating assemblages of dendrites or dendrites".
inline constexpr FlakeFallLaw kUnrimedDendriteAggregate{0.8, 0.16, 0.073, 1.4, 10e-3};
/// "Aggregates of densely rimed radiating assemblages of dendrites or dendrites".
inline constexpr FlakeFallLaw kRimedDendriteAggregate{0.79, 0.27, 0.037, 1.9, 12e-3};
/// "Graupel-like snow of hexagonal type".
inline constexpr FlakeFallLaw kHexagonalGraupel{0.86, 0.25, 0.021, 2.4, 2.8e-3};

/// Diameter in m of the drop that a mass in kg melts to, and back.
SPIN_HD inline double meltedDiameterOfMass(double kilograms) {
  return std::cbrt(6.0 * kilograms / (kPi * kWaterDensity));
}
SPIN_HD inline double massOfMeltedDiameter(double diameter) {
  return kPi / 6.0 * kWaterDensity * diameter * diameter * diameter;
}

}  // namespace spin
