// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/physics/drop_laws.h"

namespace spin {

/// The air round the cloud, as laws need it.
struct SurroundingAir {
  double temperature = 273.15;  ///< K
  double pressure = 101325.0;   ///< Pa
  double humidity = 0.8;        ///< over water, share
  CarrierAir carrier;
  double conductivity = 0.024;  ///< W/(m K)
  double vapour = 0.0;          ///< kg/m3

  static SurroundingAir of(double kelvin, double pascal, double relativeHumidity);
  /// kg/m3 of vapour over water of a temperature, more than there is in this air.
  double excessOver(double kelvin) const;
};

}  // namespace spin
