// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"

namespace spin {

/// Density of freshly fallen snow by air temperature in K, kg/m3: 67.9 + 51.3 exp(T/2.59), T in degC
/// (Hedstrom and Pomeroy 1998). Above 0 degC, where the fit was not made, it stays at its value there.
SPIN_HD inline double newSnowDensity(double airTemperature) {
  const double celsius = std::fmin(kelvinToCelsius(airTemperature), 0.0);
  return 67.9 + 51.3 * std::exp(celsius / 2.59);
}

}  // namespace spin
