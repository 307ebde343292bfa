// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/units.h"
#include "core/physics/bounded_math.h"

/// Melt without an energy balance: by degree-day, and as Tang and Zhang published it. Temperatures in K above
/// 273.15 K.
namespace spin {

enum class MeltLaw : std::uint8_t { EnergyBalance, DegreeDay, Published };

struct DegreeDayLaw {
  float factor = 4.0f / 86400.0f;  ///< kg/(m2 s K); 4 mm a day and degree is the middle of what is in use
  float threshold = 0.0f;          ///< air temperature above which snow melts
};

/// kg/(m2 s)
template <class V>
SPIN_HD_INLINE V degreeDayMelt(const DegreeDayLaw& law, V airTemperature) {
  return V(law.factor) * maximum(airTemperature - V(law.threshold), lit<V>(0.0));
}

/// Mean over a day of the positive part of a temperature that swings as mean + amplitude sin: what a step of
/// a day needs, since degrees below the threshold do not freeze what those above have melted.
inline double positiveDegreeMean(double mean, double amplitude) {
  const double a = std::abs(amplitude);
  if (mean >= a) return mean;
  if (mean <= -a) return 0.0;
  return (mean * std::acos(-mean / a) + std::sqrt(a * a - mean * mean)) / kPi;
}

/// S_m = lambda A t (T - T_gr) / (c d (T_gr - T_m)) of Tang and Zhang, their constants, lambda read as a
/// conductivity. It has no latent heat, a pole at T_gr = T_m, and is negative for T_gr below T_m (snow
/// would grow), and its units do not close: it stays to be compared with.
struct PublishedMeltLaw {
  float heat = 3150.0f;           ///< c, J/(kg K)
  float depth = 0.4f;             ///< d, m
  float deepTemperature = 10.0f;  ///< T, at the depth d
  float meltTemperature = 0.0f;   ///< T_m
  float leastDifference = 0.01f;  ///< K: the guard holds |T_gr - T_m| at this
};

template <class V>
struct PublishedMelt {
  V rate;      ///< kg/(m2 s), never negative
  V guarded;   ///< 1 where T_gr was so near T_m that the guard acted
  V negative;  ///< kg/(m2 s) that the law would have let the snow grow by, and that was set to 0
};

/// conductivity: of the ground, W/(m K); ground: T_gr.
template <class V>
SPIN_HD_INLINE PublishedMelt<V> publishedMelt(const PublishedMeltLaw& law, V conductivity, V ground) {
  const V zero = lit<V>(0.0), least = V(law.leastDifference);
  const V difference = ground - V(law.meltTemperature);
  const V size = maximum(difference, -difference);
  // On the pole itself the sign is that from above: much melt, not growth.
  const V held = selectLess(size, least, selectLess(difference, zero, -least, least), difference);
  const V rate = conductivity * (V(law.deepTemperature) - ground) / (V(law.heat * law.depth) * held);
  return {maximum(rate, zero), selectLess(size, least, lit<V>(1.0), zero), maximum(-rate, zero)};
}

}  // namespace spin
