// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/physics/humidity.h"

/// Air with vapour in it. Temperatures t are in K above 273.15 K.
namespace spin {

inline constexpr double kVapourGasConstant = 461.5;  ///< J/(kg K)
inline constexpr double kWaterHeat = 4186.0;         ///< J/(kg K)
inline constexpr double kEvaporationHeat = 2.501e6;  ///< J/kg at 0 degC

/// Saturation pressure of vapour over water, Pa (Magnus).
template <class V>
SPIN_HD_INLINE V saturationPressureWater(V t) {
  const V held = clampBetween(t, lit<V>(-100.0), lit<V>(100.0));
  return lit<V>(611.2) * boundedExp(lit<V>(17.62) * held / (lit<V>(243.12) + held));
}
/// The same over ice.
template <class V>
SPIN_HD_INLINE V saturationPressureIce(V t) {
  const V held = clampBetween(t, lit<V>(-100.0), lit<V>(100.0));
  return lit<V>(611.2) * boundedExp(lit<V>(22.46) * held / (lit<V>(272.62) + held));
}

/// kg/m3 of vapour at a partial pressure, Pa.
template <class V>
SPIN_HD_INLINE V vapourDensity(V pressure, V t) {
  return pressure / (lit<V>(kVapourGasConstant) * (t + lit<V>(273.15)));
}

/// Density of humid air, kg/m3: (p - 0.378 e)/(R_d T), e the vapour's share of the pressure.
template <class V>
SPIN_HD_INLINE V humidAirDensity(V pressure, V vapourPressure, V t) {
  return (pressure - lit<V>(0.378) * vapourPressure) / (lit<V>(kDryAirGasConstant) * (t + lit<V>(273.15)));
}

/// Dynamic viscosity of air, Pa s (Sutherland 1893, with 1.716e-5 Pa s at 273.15 K and 110.4 K).
SPIN_HD inline double airViscosity(double kelvin) {
  const double ratio = kelvin / 273.15;
  return 1.716e-5 * ratio * std::sqrt(ratio) * (273.15 + 110.4) / (kelvin + 110.4);
}

/// Heat conductivity of air, W/(m K): that of viscosity with a Prandtl number of 0.71.
SPIN_HD inline double airConductivity(double kelvin) {
  return airViscosity(kelvin) * kDryAirHeat / 0.71;
}

}  // namespace spin
