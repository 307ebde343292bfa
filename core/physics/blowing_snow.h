// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"

/// Snow that the wind carries along the ground.
namespace spin {

/// What a unit of friction velocity makes of wind 10 m up, or the other way round: u10 = u* ln(10/z0)/0.4.
SPIN_HD inline double windOfFriction(double friction, double roughness) {
  return friction * std::log(10.0 / roughness) / 0.4;
}

/// Wind 10 m up from which dry snow drifts, m/s, by air temperature in degC: 9.43 + 0.18 T + 0.0033 T^2 (Li
/// and Pomeroy 1997, mean of 16 prairie stations; single events stray by 2 m/s). Its least is 6.98 m/s at
/// -27.3; above 0 degC it stays at 9.43.
SPIN_HD inline double driftThresholdWind(double celsius) {
  const double t = std::fmin(std::fmax(celsius, -27.3), 0.0);
  return 9.43 + 0.18 * t + 0.0033 * t * t;
}

/// Wind 10 m up from which wet snow drifts, m/s (Li and Pomeroy 1997, mean).
inline constexpr double kWetDriftThresholdWind = 9.9;

/// Friction velocity from which snow of a density drifts, m/s (Liston et al. 2007, after Kotlyakov): 0.10
/// exp(0.003 rho) up to 300 kg/m3, 0.005 exp(0.013 rho) above.
SPIN_HD inline double driftThresholdFriction(double density) {
  const double rho = std::fmin(std::fmax(density, 50.0), 600.0);
  return rho <= 300.0 ? 0.10 * std::exp(0.003 * rho) : 0.005 * std::exp(0.013 * rho);
}

/// Friction velocity from which a cell's snow drifts, m/s: by the air's temperature in degC, dry or, with
/// more than 1 % of liquid water by mass, wet; snow denser than 300 kg/m3 is held as much better as the law
/// by density says.
SPIN_HD inline double driftThreshold(double celsius, double density, double liquidShare, double roughness) {
  const double wind = liquidShare > 0.01 ? kWetDriftThresholdWind : driftThresholdWind(celsius);
  const double hardness = driftThresholdFriction(std::fmax(density, 300.0)) / driftThresholdFriction(300.0);
  return 0.4 * wind / std::log(10.0 / roughness) * hardness;
}

/// What hops along the ground in steady wind, kg/(m s) (Pomeroy and Gray 1990): (0.68 m/s) rho_air/g
/// (u*t/u*) (u*^2 - u*t^2); 0 below the threshold.
SPIN_HD inline double saltationRate(double friction, double threshold, double airDensity = 1.2) {
  if (!(friction > threshold) || !(threshold > 0.0)) return 0.0;
  return 0.68 * airDensity / 9.80665 * threshold / friction * (friction * friction - threshold * threshold);
}

/// All that drifts below 5 m in steady wind over unlimited snow, kg/(m s): saltation, and what Tabler's
/// u10^3.8/233847 (Tabler 1994) has beyond it, which sets in with 1 - (u*t/u*)^2.
SPIN_HD inline double driftRate(double friction, double threshold, double roughness) {
  const double saltation = saltationRate(friction, threshold);
  if (!(saltation > 0.0)) return 0.0;
  const double total = std::pow(windOfFriction(friction, roughness), 3.8) / 233847.0;
  const double ratio = threshold / friction;
  return saltation + std::fmax(total - saltation, 0.0) * (1.0 - ratio * ratio);
}

}  // namespace spin
