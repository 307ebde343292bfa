// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/base/units.h"

namespace spin {

/// Share of the arriving snow that stays on a slope: 1 below one angle, 0 above another, a smooth step
/// (3 s^2 - 2 s^3) of the angle between them. The rest is shed.
struct SlopeHold {
  double holdsBelow = degreesToRadians(30.0);  ///< rad
  double shedsAbove = degreesToRadians(60.0);  ///< rad

  /// upwardNormal: z of the unit normal, 1 on level ground.
  SPIN_HD double share(double upwardNormal) const {
    const double clamped = upwardNormal < -1.0 ? -1.0 : (upwardNormal > 1.0 ? 1.0 : upwardNormal);
    const double slope = std::acos(clamped);
    if (slope <= holdsBelow) return 1.0;
    if (slope >= shedsAbove) return 0.0;
    const double s = (shedsAbove - slope) / (shedsAbove - holdsBelow);
    return s * s * (3.0 - 2.0 * s);
  }

  friend bool operator==(const SlopeHold&, const SlopeHold&) = default;
};

}  // namespace spin
