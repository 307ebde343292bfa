// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/nodes/weather_nodes.h"

namespace spin {

inline constexpr std::uint32_t kFlakeBlock = 16;  ///< flakes of one size that follow each other

/// Flakes are drawn in groups by distance. A group's flakes fill a periodic box of their own; of each flake
/// the copy nearest to the eye counts, and it shows where its distance lies between two borders. The farther
/// a group, the fewer flakes to a volume, each standing for more real ones.
struct FlakeGroup {
  double box = 0.0;          ///< edge of the period, m
  std::uint32_t blocks = 0;  ///< of kFlakeBlock flakes
  double weight = 0.0;       ///< real flakes that one stands for
  double nearest = 0.0;      ///< middle of the border towards the eye, m; 0 = none
  double farthest = 0.0;     ///< middle of the border away from the eye, m

  std::uint32_t flakes() const { return blocks * kFlakeBlock; }
  bool operator==(const FlakeGroup&) const = default;
};
/// Half width of a border, share of its distance: over it one group goes out as the next comes in, and the
/// last one before its flakes go round.
inline constexpr double kGroupBlend = 0.15;

/// Groups of a snowfall, nearest first. Boxes grow from 3 m (or a quarter of the whole one) in equal ratios;
/// the number of flakes goes with the edge, so that flakes are about equally large on the screen in all
/// groups. `numberDensity`: real flakes per m3. None where no flakes are asked for.
std::vector<FlakeGroup> flakeGroups(const SnowfallNode& snowfall, double numberDensity);

std::size_t flakeCountOf(const std::vector<FlakeGroup>& groups);

}  // namespace spin
