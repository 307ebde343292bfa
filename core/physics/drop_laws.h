// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"

/// Drops, grains and clumps in air. SI.
namespace spin {

/// The air that something flies in.
struct CarrierAir {
  double density = 1.29;       ///< kg/m3
  double viscosity = 1.72e-5;  ///< Pa s
};

/// Drag coefficient of a sphere: 24/Re (1 + 0.15 Re^0.687) up to Re 1000, 0.44 beyond (Schiller and Naumann
/// 1935).
SPIN_HD inline double sphereDrag(double reynolds) {
  if (reynolds >= 1000.0) return 0.44;
  const double re = std::fmax(reynolds, 1e-9);
  return 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687));
}

/// Rate r of dv/dt = r (air - v) for a sphere that goes at `speed` against the air, 1/s:
/// 3/4 C_d rho_air speed / (rho d). In still air Stokes' 18 mu / (rho d^2).
SPIN_HD inline double sphereDragRate(double diameter, double density, double speed, const CarrierAir& air) {
  const double reynolds = air.density * speed * diameter / air.viscosity;
  if (reynolds < 1e-6) return 18.0 * air.viscosity / (density * diameter * diameter);
  return 0.75 * sphereDrag(reynolds) * air.density * speed / (density * diameter);
}

/// Speed at which drag and weight less lift balance, m/s. Drops of more than 2 mm flatten and are slower than
/// the sphere that this takes them for (Gunn and Kinzer 1949: 9.1 m/s at 5 mm, this 11).
SPIN_HD inline double sphereTerminalSpeed(double diameter, double density, const CarrierAir& air,
                                          double gravity = kStandardGravity) {
  const double weight = gravity * std::fmax(1.0 - air.density / density, 0.0);
  double speed = 0.0;
  // The rate grows with the speed: from both sides the middle of guess and answer comes nearer.
  for (int k = 0; k < 60; ++k) speed = 0.5 * (speed + weight / sphereDragRate(diameter, density, speed, air));
  return speed;
}

/// Largest drop that air does not tear at a speed against it, m: We = rho_air u^2 d / sigma = 12 (Pilch and
/// Erdman 1987), sigma of water at 5 degC.
SPIN_HD inline double largestDrop(double speed, double airDensity, double surfaceTension = 0.0749) {
  return 12.0 * surfaceTension / std::fmax(airDensity * speed * speed, 1e-9);
}

/// Time in which air that goes past at a speed tears a drop or a lump of it to its smallest pieces, s: T d
/// (rho_liquid/rho_air)^(1/2) / u, with T by the Weber number (Pilch and Erdman 1987, eqs. 15 to 19; measured
/// up to We 1e5). Below We 12 nothing is torn: infinite.
SPIN_HD inline double breakUpTime(double diameter, double speed, double density, double airDensity,
                                  double surfaceTension = 0.0749) {
  const double weber = airDensity * speed * speed * diameter / surfaceTension;
  if (!(weber > 12.0)) return HUGE_VAL;
  const double over = std::pow(weber - 12.0, 0.25);
  const double time = weber < 18.0     ? 6.0 / over
                      : weber < 45.0   ? 2.45 * over
                      : weber < 351.0  ? 14.1 / over
                      : weber < 2670.0 ? 0.766 * over
                                       : 5.5;
  return time * diameter * std::sqrt(density / airDensity) / speed;
}

/// Heat that a sphere gives per kelvin over that by conduction in still air alone, times 2: Nu = 2 + 0.6
/// Re^(1/2) Pr^(1/3) (Ranz and Marshall 1952), Pr 0.71. Sherwood's number of vapour is nearly the same.
SPIN_HD inline double sphereNusselt(double reynolds) {
  return 2.0 + 0.6 * 0.8921 * std::sqrt(std::fmax(reynolds, 0.0));
}

/// Heat that a kilogram of drops gives to the air, W/(kg K): 6 Nu k / (rho d^2).
SPIN_HD inline double dropHeatRate(double diameter, double density, double speed, const CarrierAir& air,
                                   double conductivity) {
  const double reynolds = air.density * speed * diameter / air.viscosity;
  return 6.0 * sphereNusselt(reynolds) * conductivity / (density * diameter * diameter);
}

}  // namespace spin
