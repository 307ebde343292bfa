// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

/// Where water is thrown up: potentials of trapped air, wave crests and kinetic energy (Ihmsen, Akinci,
/// Akinci and Teschner 2012, "Unified spray, foam and air bubbles for particle-based fluids"). Their sums
/// over neighbours are made means here, weighted with W = 1 - |x|/h as theirs, and the energy is that of a
/// kilogram: so thresholds do not depend on spacing and support.
namespace spin {

/// Eq. 1: 0 up to `low`, 1 from `high` on, linear between.
SPIN_HD inline double clampedPotential(double value, double low, double high) {
  if (!(high > low)) return value >= low ? 1.0 : 0.0;
  return (std::fmin(value, high) - std::fmin(value, low)) / (high - low);
}

/// Weight of a neighbour at a distance, eq. 3.
SPIN_HD inline double birthWeight(double distance, double support) {
  return distance < support ? 1.0 - distance / support : 0.0;
}

/// What a neighbour adds to the trapped air, m/s, eq. 2: |v_ij| (1 - cos(v_ij, x_ij)), both from j to i:
/// twice the relative speed where they meet, 0 where they part.
SPIN_HD inline double trappedAir(Vec3d relativeVelocity, Vec3d offset) {
  const double speed = length(relativeVelocity), distance = length(offset);
  if (!(speed > 0.0) || !(distance > 0.0)) return 0.0;
  return speed - dot(relativeVelocity, offset) / distance;
}

/// What a neighbour at `offset` (from i to j) adds to the bend of the surface, eq. 4: 1 - n_i . n_j where it
/// lies below the tangent plane, which is so where the surface is convex.
SPIN_HD inline double crestBend(Vec3d normal, Vec3d otherNormal, Vec3d offset) {
  return dot(offset, normal) < 0.0 ? 1.0 - dot(normal, otherNormal) : 0.0;
}

/// Eq. 6: a bent surface is a crest only where it goes forward.
SPIN_HD inline bool goesForward(Vec3d velocity, Vec3d normal) {
  return dot(normalized(velocity), normal) >= 0.6;
}

/// Share of a particle that is thrown up in a time: 1 - exp(-rate time), whatever the step.
SPIN_HD inline double shareOfRate(double rate, double seconds) {
  return -std::expm1(-rate * seconds);
}

}  // namespace spin
