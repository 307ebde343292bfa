// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/math/vec.h"

namespace spin {

/// Gradient noise (Perlin 2002: quintic fade, gradients on the lattice) with gradients drawn by the counter
/// generator, so that it repeats nowhere within 2^32 cells. About -1..1, mean 0, 0 at lattice points.
double gradientNoise(Vec3d position, std::uint64_t seed);

/// Octaves of gradient noise from `wavelength` m downwards, halving, amplitudes falling by 0.6, none shorter
/// than `shortest` m; scaled to about -1..1.
double octaveNoise(Vec3d position, double wavelength, double shortest, std::uint64_t seed);

}  // namespace spin
