// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace spin {

/// Extinction of falling snow, 1/m, by the mass of snow in the air, kg/m3: 10.36 C^0.7776 1/km, C in g/m3.
/// Source: Stoelinga and Warner 1999, from measurements of Stallabrass 1985.
inline double snowExtinction(double massConcentration) {
  const double grams = 1000.0 * massConcentration;
  return grams > 0.0 ? 1e-3 * 10.36 * std::pow(grams, 0.7776) : 0.0;
}

/// Distance in m at which a black object keeps 2 % of its contrast (Koschmieder 1924): 3.912 / extinction.
inline double visibilityOf(double extinction) {
  return 3.912 / extinction;
}

/// Height of a sprite on the screen, pixels: S_final = h S sqrt(1/(A + B D + C D^2)) for a thing of size S,
/// m, at the eye distance D, m, in a viewport of h pixels. C = 4 tan^2(fov/2) alone is the pinhole's law; A >
/// 0 keeps near things from growing without bound, B > 0 shrinks them more slowly on the way.
struct SpriteSizeLaw {
  double a = 0.0, b = 0.0, c = 1.0;
  double pixels(double viewportHeight, double size, double distance) const {
    return viewportHeight * size / std::sqrt(a + b * distance + c * distance * distance);
  }
};
inline SpriteSizeLaw pinholeSizeLaw(double verticalFovRadians) {
  const double t = std::tan(0.5 * verticalFovRadians);
  return {0.0, 0.0, 4.0 * t * t};
}

}  // namespace spin
