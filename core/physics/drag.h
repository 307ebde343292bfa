// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace spin {

/// Acceleration of a falling body by gravity and quadratic drag that balances it at terminal speed:
/// dv/dt = g - |g| |v - w| (v - w)/v_t^2, w the wind, m/s2.
SPIN_HD inline Vec3d dragAcceleration(Vec3d velocity, Vec3d wind, double terminalSpeed, Vec3d gravity) {
  const Vec3d u = velocity - wind;
  return gravity - u * (length(gravity) * length(u) / (terminalSpeed * terminalSpeed));
}

/// Velocity after a step h [s] of the same law by backward Euler. The implicit equation
/// u (1 + h |g| |u|/v_t^2) = u_old + h g has the closed solution |u| = (sqrt(1 + 4 k |b|) - 1)/(2 k), so any
/// step is stable and monotone and the terminal state is exact.
SPIN_HD inline Vec3d dragStep(Vec3d velocity, Vec3d wind, double terminalSpeed, Vec3d gravity, double h) {
  const Vec3d b = velocity - wind + gravity * h;
  const double size = length(b);
  if (size == 0.0) return wind;  // a NaN goes on and is found
  const double k = h * length(gravity) / (terminalSpeed * terminalSpeed);
  // The second form of the root keeps its digits where 4 k |b| is tiny.
  const double speed = 2.0 * size / (1.0 + std::sqrt(1.0 + 4.0 * k * size));
  return wind + b * (speed / size);
}

/// Time in which a body reaches terminal speed, V/g, s.
SPIN_HD inline double relaxationTime(double terminalSpeed, double gravity) {
  return terminalSpeed / gravity;
}

/// Advances the velocity over h [s] in sub-steps of a quarter of the relaxation time, so that the path is
/// followed, and returns the way gone, m. At most 64 sub-steps: the scheme is stable at any, so a longer step
/// loses only the path's first moments.
inline Vec3d dragAdvance(Vec3d& velocity, Vec3d wind, double terminalSpeed, Vec3d gravity, double h) {
  const double relaxation = relaxationTime(terminalSpeed, length(gravity));
  const int steps = static_cast<int>(std::fmin(std::fmax(std::ceil(4.0 * h / relaxation), 1.0), 64.0));
  const double sub = h / steps;
  Vec3d way{};
  for (int s = 0; s < steps; ++s) {
    const Vec3d next = dragStep(velocity, wind, terminalSpeed, gravity, sub);
    way += (velocity + next) * (0.5 * sub);
    velocity = next;
  }
  return way;
}

}  // namespace spin
