// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/bench/air_bench_scene.h"

/// Known flows of the cases, without divergence on the lattice to rounding.
namespace spin {

/// Four vortices of Taylor and Green in a square of 1 m in x and z with at most `speed` m/s:
/// u = -speed sin 2 pi x cos 2 pi z, w = speed cos 2 pi x sin 2 pi z. The walls of a box in which air slides
/// are their planes of symmetry, so that the box is one period of the endless pattern.
void setVortices(AirBox& box, double speed);

/// Once round the middle of a square of 1 m in a second, in x and z, `across` cells a metre; farther than
/// 0.47 m from the middle it stands still, so that none goes through the sides.
void setTurning(AirBox& box, int across);

/// LeVeque (1996) in a cube of 1 m: speed (2 sin^2 x sin 2y sin 2z, -sin 2x sin^2 y sin 2z,
/// -sin 2x sin 2y sin^2 z), angles times pi, m/s.
void setDeformation(AirBox& box, double speed);

/// One mode of the lattice's Laplacian in a box whose walls the air slides along, as many half waves in x as
/// in z, at most 1 m/s; backward Euler steps take it to 1 / (1 + nu dt / h^2 * 8 sin^2(pi waves / (2 N))).
void setDiffusionMode(AirBox& box, int waves);

}  // namespace spin
