// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/physics/size_spectrum.h"

#include <algorithm>
#include <array>

namespace spin {
namespace {

/// Nodes and weights of Gauss-Legendre quadrature with 8 points on [-1, 1] (Abramowitz and Stegun 25.4.29).
constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};

template <class F>
double integrate(const F& f, double from, double to, int pieces) {
  double sum = 0.0;
  const double half = 0.5 * (to - from) / pieces;
  for (int p = 0; p < pieces; ++p) {
    const double middle = from + (2 * p + 1) * half;
    for (std::size_t k = 0; k < kNodes.size(); ++k)
      sum += kWeights[k] * (f(middle - half * kNodes[k]) + f(middle + half * kNodes[k]));
  }
  return sum * half;
}

struct Moments {
  double mass = 0.0;       ///< integral of exp(-slope x) m
  double flux = 0.0;       ///< ... m v
  double fluxSpeed = 0.0;  ///< ... m v^2
};

/// The law has a kink at its largest measured size, so the range is cut there; 60/slope holds all but 1e-20.
Moments momentsOf(const FlakeFallLaw& law, double slope) {
  const double end = 60.0 / slope;
  const double kink = std::min(meltedDiameterOfMass(law.mass(law.largestMeasured)), end);
  const auto moment = [&](int power) {
    const auto f = [&](double x) {
      const double m = massOfMeltedDiameter(x);
      return std::exp(-slope * x) * m * std::pow(law.terminalSpeed(law.diameterOfMass(m)), power);
    };
    return integrate(f, 0.0, kink, 32) + integrate(f, kink, end, 32);
  };
  return {moment(0), moment(1), moment(2)};
}

}  // namespace

SizeSpectrum makeSizeSpectrum(const FlakeFallLaw& law, double precipitation) {
  // Below a drizzle of flakes the published slope would shrink them to nothing.
  constexpr double kLightest = millimetresPerHourToSi(0.01);
  SizeSpectrum spectrum;
  spectrum.law = law;
  spectrum.slope = spectrumSlope(std::max(precipitation, kLightest));
  const Moments moments = momentsOf(law, spectrum.slope);
  spectrum.intercept = std::max(precipitation, 0.0) / moments.flux;
  spectrum.numberDensity = spectrum.intercept / spectrum.slope;
  spectrum.massConcentration = spectrum.intercept * moments.mass;
  spectrum.meanFallSpeed = moments.fluxSpeed / moments.flux;
  return spectrum;
}

}  // namespace spin
