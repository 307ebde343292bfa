// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"
#include "core/physics/flake_fall.h"

namespace spin {

/// Slope of the size spectrum in melted diameter, 1/m: Lambda = 2.29 R^-0.45 1/mm, R in mm/h
/// (Sekhon and Srivastava 1970). precipitation in kg/(m2 s), > 0.
SPIN_HD inline double spectrumSlope(double precipitation) {
  return 2.29e3 * std::pow(siToMillimetresPerHour(precipitation), -0.45);
}

/// Intercept as published, 1/m4: N0 = 2500 R^-0.94 1/(m3 mm) (Sekhon and Srivastava 1970).
SPIN_HD inline double publishedSpectrumIntercept(double precipitation) {
  return 2.5e6 * std::pow(siToMillimetresPerHour(precipitation), -0.94);
}

/// Numbers of falling flakes by melted diameter x: N(x) = intercept exp(-slope x), 1/m4, with the published
/// shape and the intercept scaled so that the mass flux, integral of N m v_t, is the precipitation rate.
struct SizeSpectrum {
  FlakeFallLaw law;
  double slope = 0.0;              ///< 1/m
  double intercept = 0.0;          ///< 1/m4; 0 = nothing falls
  double numberDensity = 0.0;      ///< flakes per m3
  double massConcentration = 0.0;  ///< kg of snow per m3 of air
  double meanFallSpeed = 1.0;      ///< m/s, weighted by mass flux; what lands falls at it on average

  /// Melted diameter in m below which a share u in [0, 1) of the flakes lies.
  double meltedDiameter(double u) const { return -std::log1p(-u) / slope; }
};

/// Spectrum for a precipitation rate in kg/(m2 s); <= 0 gives an empty one, with the fall speed of the
/// lightest snowfall. Integrals to a relative 1e-9.
SizeSpectrum makeSizeSpectrum(const FlakeFallLaw& law, double precipitation);

}  // namespace spin
