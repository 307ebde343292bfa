// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spin {

/// What a stroke does to the layer under it.
enum class BrushMode : std::uint8_t { Paint, Smooth, Erase, Pick };

inline constexpr double kLeastBrushRadius = 0.5, kMostBrushRadius = 500.0;  // m

/// A round brush.
struct BrushTip {
  double radius = 12.0;   ///< m, in plan
  double hardness = 0.5;  ///< share of the radius that has full strength
  double strength = 1.0;  ///< 0..1

  /// Share of the strength at a distance from the middle, m: 1 within the hard core, smoothly to 0 at the
  /// radius.
  double weight(double distance) const {
    if (distance >= radius) return 0.0;
    const double core = hardness * radius;
    if (distance <= core) return 1.0;
    const double t = (radius - distance) / (radius - core);
    return t * t * (3.0 - 2.0 * t);
  }
};

/// Next brush radius for the keys [ and ]: a quarter smaller or larger.
inline double steppedBrushRadius(double radius, int steps) {
  return std::clamp(radius * std::pow(1.25, steps), kLeastBrushRadius, kMostBrushRadius);
}

/// What the pressure of a pen leaves of strength and radius; 1 for a mouse.
struct BrushPress {
  double strength = 1.0;
  double radius = 1.0;
};

}  // namespace spin
