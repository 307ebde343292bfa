// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/result.h"

namespace spin {

/// Arms of a flake that grows by aggregation. Six and Eight grow one sector of 30 or 22.5 degrees, which is
/// mirrored and turned.
enum class FlakeSymmetry : std::uint8_t { Free = 1, Six = 6, Eight = 8 };

/// Radii between which new snow lies, m (Tang and Zhang).
inline constexpr double kSmallestFlake = 0.05e-3, kLargestFlake = 4.6e-3;

/// A flake that grows by diffusion-limited aggregation. It is grown when it has its radius or its particles,
/// whichever comes first.
struct FlakeSettings {
  FlakeSymmetry symmetry = FlakeSymmetry::Six;
  std::uint64_t seed = 1;
  double radius = 2e-3;             ///< m
  double particleDiameter = 15e-6;  ///< m; the finer, the more branches in a flake of a size
  int particles = 100000;           ///< at most, symmetric ones counted
  /// How far a particle is turned round the one it touches towards the nearest of the crystal's own
  /// directions, 0..1; without effect on free flakes. At 0 arms are corals, at 1 they branch at 60
  /// degrees, as ice does.
  double alignment = 1.0;
  /// Walkers that must land at a place before a particle stays there, of symmetric flakes. One gives the
  /// ragged branches of pure chance; the more, the straighter the arms (noise reduction, with which Nittmann
  /// and Stanley 1987 drew the shapes of real snow crystals).
  int landings = 20;
};

inline constexpr int kMostFlakeParticles = 1000000, kMostLandings = 200;
/// Radius in particle diameters; a larger map would need gigabytes.
inline constexpr double kLargestReach = 2000.0;

/// Fails with what is wrong where the settings make no flake.
Status checkFlakeSettings(const FlakeSettings& settings);

}  // namespace spin
