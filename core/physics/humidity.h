// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/bounded_math.h"

/// Moist air. Temperatures t are in K above 273.15 K; Magnus' formula holds from about -100 to +100.
namespace spin {

inline constexpr double kDryAirGasConstant = 287.05;  ///< J/(kg K)
inline constexpr double kDryAirHeat = 1005.0;         ///< J/(kg K) at constant pressure
inline constexpr double kVapourMassRatio = 0.622;     ///< of water vapour to dry air

template <class V>
struct Saturation {
  V humidity;  ///< kg/kg
  V slope;     ///< d humidity / d t, 1/K
};

/// Specific humidity at saturation, over ice below 0 and over water above.
template <class V>
SPIN_HD_INLINE Saturation<V> saturation(V t, V pressure) {
  const V zero = lit<V>(0.0);
  const V held = clampBetween(t, lit<V>(-100.0), lit<V>(100.0));
  const V a = selectLess(held, zero, lit<V>(22.46), lit<V>(17.62));
  const V b = selectLess(held, zero, lit<V>(272.62), lit<V>(243.12));
  const V over = lit<V>(1.0) / (b + held);
  const V humidity = lit<V>(kVapourMassRatio * 611.2) * boundedExp(a * held * over) / pressure;
  return {humidity, humidity * a * b * over * over};
}

/// Specific humidity of air whose relative humidity (share) is over water at all temperatures, as weather
/// stations give it.
template <class V>
SPIN_HD_INLINE V airHumidity(V t, V relative, V pressure) {
  const V held = clampBetween(t, lit<V>(-100.0), lit<V>(100.0));
  const V magnus = boundedExp(lit<V>(17.62) * held / (lit<V>(243.12) + held));
  return lit<V>(kVapourMassRatio * 611.2) * relative * magnus / pressure;
}

/// Share of precipitation that falls as snow: Jennings et al. 2018 (17.8 million observations of the northern
/// hemisphere), by air temperature and relative humidity (share).
template <class V>
SPIN_HD_INLINE V snowShare(V t, V relative) {
  const V x = mulAdd(lit<V>(1.41), t, mulAdd(lit<V>(9.0), relative, lit<V>(-10.04)));
  return lit<V>(1.0) / (lit<V>(1.0) + boundedExp(x));
}

}  // namespace spin
