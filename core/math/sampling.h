// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/units.h"
#include "core/math/vec.h"

namespace spin {

/// First `count` points of the four-dimensional Sobol sequence as 32-bit fractions, with the direction
/// numbers of Joe and Kuo 2008. Blocks of a power of two are nets: evenly spread in every pair of dimensions.
std::vector<std::array<std::uint32_t, 4>> sobolPoints(std::size_t count);

/// Fraction in [0, 1) of a scrambled word: digital shift, which keeps the net.
inline double shifted(std::uint32_t word, std::uint32_t shift) {
  return (word ^ shift) * 0x1p-32;
}

/// Area-preserving map of the unit square to the unit disc that keeps neighbours together
/// (Shirley and Chiu 1997).
inline Vec2d squareToDisc(double u, double v) {
  const double a = 2.0 * u - 1.0, b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0) return {};
  const bool wide = std::abs(a) > std::abs(b);
  const double r = wide ? a : b;
  const double angle = wide ? kPi / 4.0 * (b / a) : kPi / 2.0 - kPi / 4.0 * (a / b);
  return {r * std::cos(angle), r * std::sin(angle)};
}

/// Two unit vectors that with the unit vector n form a right-handed frame.
struct Frame3d {
  Vec3d s, t, n;
  friend bool operator==(const Frame3d&, const Frame3d&) = default;
};
inline Frame3d frameAround(Vec3d n) {
  const Vec3d helper = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d s = normalized(cross(helper, n));
  return {s, cross(n, s), n};
}

/// Direction uniform in solid angle within a cone round frame.n: the disc maps to the cap by equal areas
/// (Lambert). oneMinusCos = 1 - cos(half angle); u, v in [0, 1).
inline Vec3d coneDirection(const Frame3d& frame, double oneMinusCos, double u, double v) {
  const Vec2d disc = squareToDisc(u, v);
  const double r2 = disc.x * disc.x + disc.y * disc.y;
  const double drop = r2 * oneMinusCos;  // 1 - cos of the angle to the axis
  // sin^2 = drop (2 - drop), and the disc vector has length sqrt(r2).
  const double scale = std::sqrt(oneMinusCos * (2.0 - drop));
  return frame.s * (disc.x * scale) + frame.t * (disc.y * scale) + frame.n * (1.0 - drop);
}

}  // namespace spin
