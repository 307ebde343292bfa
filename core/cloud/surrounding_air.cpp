// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/surrounding_air.h"

#include "core/physics/humid_air.h"

namespace spin {

SurroundingAir SurroundingAir::of(double kelvin, double pascal, double relativeHumidity) {
  SurroundingAir air;
  air.temperature = kelvin, air.pressure = pascal, air.humidity = relativeHumidity;
  const double t = kelvin - kZeroCelsius, e = relativeHumidity * saturationPressureWater(t);
  air.carrier = {humidAirDensity(pascal, e, t), airViscosity(kelvin)};
  air.conductivity = airConductivity(kelvin);
  air.vapour = vapourDensity(e, t);
  return air;
}

double SurroundingAir::excessOver(double kelvin) const {
  const double t = kelvin - kZeroCelsius;
  return vapourDensity(saturationPressureWater(t), t) - vapour;
}

}  // namespace spin
