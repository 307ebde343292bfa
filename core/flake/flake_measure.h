// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/math/vec.h"

namespace spin {

/// Root mean square distance of the first `count` points from their common centre; 0 of none.
double gyrationRadius(const std::vector<Vec2d>& centres, std::size_t count);

/// Fractal dimension of a cluster by its growth: N ~ R_g^D, least squares of log R_g over log N from a
/// hundredth of the particles (at least 50) to all. 0 where there are fewer than 500.
double gyrationDimension(const std::vector<Vec2d>& centres);

/// How mass lies round the nucleus: N(R) = prefactor R^dimension particles within R particle diameters.
struct MassRadiusLaw {
  double prefactor = 0.0;
  double dimension = 0.0;
  double number(double radius) const { return prefactor * std::pow(radius, dimension); }
  /// Mean density within R, rho(R) = N(R)/R^2 ~ R^(D - 2), particles per square of a diameter.
  double density(double radius) const { return prefactor * std::pow(radius, dimension - 2.0); }
};
/// Fitted between 4 particle diameters and half of the reach, where later particles change nothing any more;
/// zeros where the cluster reaches less than 16.
MassRadiusLaw massRadiusLaw(const std::vector<Vec2d>& centres);

}  // namespace spin
