// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace spin {

/// Colours lie in textures as square roots and shaders square them: nearly as even to the eye as sRGB, and
/// software drivers filter plain bytes several times faster than sRGB ones.
inline std::uint8_t encodeRoot(double linear) {
  return static_cast<std::uint8_t>(std::lround(255.0 * std::sqrt(std::clamp(linear, 0.0, 1.0))));
}

/// Linear value of an sRGB byte (IEC 61966-2-1).
inline double srgbToLinear(std::uint8_t byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

}  // namespace spin
