// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/math/scalar_ops.h"

/// Apparent viscosity as a function of the shear rate, sqrt(2 D:D) with D the symmetric velocity gradient.
/// (One published listing takes |trace D|, which is zero in any flow that keeps its volume and so never
/// thins.)
namespace spin {

enum class RheologyLaw : std::uint8_t {
  Newtonian,  ///< mu
  Yield,  ///< Herschel-Bulkley with a Mohr-Coulomb yield stress: power law, Bingham and frictional are cases
          ///< of it
  Cross,  ///< thinning between two plateaus
};

/// A flowing material's law, SI. With Yield:
///   mu = K gd^(n-1) + (c + max(p, 0) tan phi) (1 - exp(-m gd)) / gd
/// Newtonian K = mu, n = 1; power law (Ostwald-de Waele) c = phi = 0; Bingham n = 1; frictional c = 0. The
/// bracket is Papanastasiou's 1987 regularisation: the yield stress is exact as m grows. With Cross (1965):
/// mu = mu_inf + (mu_0 - mu_inf) / (1 + (K gd^n)).
struct Rheology {
  RheologyLaw law = RheologyLaw::Newtonian;
  float viscosity = 1e-3f;        ///< Pa s: mu, or the consistency K [Pa s^n], or Cross' mu_0
  float exponent = 1.0f;          ///< n
  float cohesion = 0.0f;          ///< c, Pa
  float frictionTangent = 0.0f;   ///< tan phi
  float regularisation = 100.0f;  ///< m, s
  float viscosityAtSpeed = 0.0f;  ///< Cross' mu_inf, Pa s
  float crossFactor = 0.0f;       ///< Cross' K, s^n
  float least = 0.0f;             ///< Pa s; the result is held within [least, most]
  float most = 1e9f;              ///< Pa s

  friend bool operator==(const Rheology&, const Rheology&) = default;

  /// Needs the shear rate; a Newtonian fluid does not.
  SPIN_HD_INLINE bool needsShearRate() const { return law != RheologyLaw::Newtonian; }
};

/// Shear rate below which laws take this value, 1/s: powers and quotients stay finite.
inline constexpr float kLeastShearRate = 1e-6f;

SPIN_HD_INLINE float apparentViscosity(const Rheology& r, float shearRate, float pressure) {
  const float rate = maximum(shearRate, kLeastShearRate);
  float viscosity = r.viscosity;
  if (r.law == RheologyLaw::Yield) {
    const float yieldStress = r.cohesion + maximum(pressure, 0.0f) * r.frictionTangent;
    viscosity =
        r.viscosity * powf(rate, r.exponent - 1.0f) - yieldStress * expm1f(-r.regularisation * rate) / rate;
  } else if (r.law == RheologyLaw::Cross) {
    viscosity = r.viscosityAtSpeed +
                (r.viscosity - r.viscosityAtSpeed) / (1.0f + r.crossFactor * powf(rate, r.exponent));
  }
  return minimum(maximum(viscosity, r.least), r.most);
}

/// sqrt(2 D:D) from the nine components of the velocity gradient g[3 a + b] = d v_a / d x_b.
SPIN_HD_INLINE float shearRateOf(const float* g) {
  const float xy = g[1] + g[3], xz = g[2] + g[6], yz = g[5] + g[7];
  const float diagonal = g[0] * g[0] + g[4] * g[4] + g[8] * g[8];
  return squareRoot(2.0f * diagonal + xy * xy + xz * xz + yz * yz);
}

}  // namespace spin
