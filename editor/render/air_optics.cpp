// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/air_optics.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr double kExtinctionEfficiency = 2.0;
constexpr float kMostExtinction = 6e4f;  // 1/m; what a half holds

double draine(double g, double alpha, double cosine) {
  const double d = 1.0 + g * g - 2.0 * g * cosine;
  const double norm = 1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0;
  return (1.0 - g * g) * (1.0 + alpha * cosine * cosine) / (4.0 * kPi * norm * d * std::sqrt(d));
}

/// Adds a field's share; returns what it takes from the beam in all.
double addField(const AirPart& air, const char* name, double perMass, std::vector<float>& extinction) {
  const AirField* field = air.find(name);
  if (!field || field->components != 1 || field->halves.size() != air.cells()) return 0.0;
  if (extinction.empty()) extinction.assign(air.cells(), 0.0f);
  const auto scale = static_cast<float>(perMass) * field->scale;
  double sum = 0.0;
  for (std::size_t k = 0; k < extinction.size(); ++k) {
    const float raw = scale * floatFromHalf(field->halves[k]);
    if (!(raw > 0.0f)) continue;
    const float own = std::min(raw, kMostExtinction);
    extinction[k] = std::min(extinction[k] + own, kMostExtinction);
    sum += static_cast<double>(own);
  }
  return sum;
}

AirPhase blend(const AirPhase& a, const AirPhase& b, double t) {
  const auto mix = [t](double x, double y) { return x + t * (y - x); };
  return {mix(a.peak, b.peak), mix(a.broad, b.broad), mix(a.alpha, b.alpha), mix(a.broadShare, b.broadShare)};
}

}  // namespace

double AirPhase::at(double cosine) const {
  return (1.0 - broadShare) * draine(peak, 0.0, cosine) + broadShare * draine(broad, alpha, cosine);
}

double AirPhase::meanCosine() const {
  const double square = broad * broad;
  const double ofBroad =
      broad * (1.0 + 0.2 * alpha * (3.0 + 2.0 * square)) / (1.0 + alpha * (1.0 + 2.0 * square) / 3.0);
  return (1.0 - broadShare) * peak + broadShare * ofBroad;
}

AirPhase dropPhase(double diameter) {
  const double d = std::clamp(diameter * 1e6, 5.0, 50.0);
  return {std::exp(-0.0990567 / (d - 1.67154)), std::exp(-2.20679 / (d + 3.91029) - 0.428934),
          std::exp(3.62489 - 8.29288 / (d + 5.52825)), std::exp(-0.599085 / (d - 0.641583) - 0.665888)};
}

AirPhase grainPhase() {
  constexpr double kPeak = 0.998, kMean = 0.75;
  return {kPeak, 2.0 * kMean - kPeak, 0.0, 0.5};
}

double extinctionPerMass(double density, double diameter) {
  return 1.5 * kExtinctionEfficiency / (density * diameter);
}

AirOptics airOptics(const AirPart& air) {
  AirOptics optics;
  const double mist =
      addField(air, "mist", extinctionPerMass(kWaterDensity, air.dropDiameter), optics.extinction);
  const double snow =
      addField(air, "snow", extinctionPerMass(kIceDensity, air.snowDiameter), optics.extinction);
  if (!(mist + snow > 0.0)) return {};
  optics.phase = blend(dropPhase(air.dropDiameter), grainPhase(), snow / (mist + snow));
  return optics;
}

}  // namespace spin
