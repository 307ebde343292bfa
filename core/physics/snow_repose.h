// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"

namespace spin {

/// The steepest slope that loose snow keeps. Natural dry snow poured into heaps keeps 37 to 53 degrees, the
/// less the larger and rounder its grains and the colder it is (Willibald et al. 2020); wetting leaves it as
/// it is up to some 3 % of liquid water by volume, and slush, above 15 % (classes of Fierz et al. 2009), runs
/// off gentle slopes. In between the tangent goes over in proportion.
struct SnowRepose {
  double dry = degreesToRadians(38.0);  ///< rad
  double wet = degreesToRadians(20.0);  ///< rad, of slush
  double moist = 0.03;                  ///< liquid water by volume from which it loses hold
  double slush = 0.15;                  ///< and at which it is slush

  /// Tangent of the angle; liquid water in kg/m2, depth in m.
  SPIN_HD double tangent(double liquid, double depth) const {
    const double volume = depth > 0.0 ? liquid / (1000.0 * depth) : 0.0;
    const double s = std::fmin(std::fmax((volume - moist) / (slush - moist), 0.0), 1.0);
    return std::tan(dry) + s * (std::tan(wet) - std::tan(dry));
  }
};

}  // namespace spin
