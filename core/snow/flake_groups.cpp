// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/flake_groups.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kNearestBox = 3.0;  // m
/// Of half a box: a border ends where the box does.
constexpr double kBorder = 1.0 / (1.0 + kGroupBlend);

}  // namespace

std::vector<FlakeGroup> flakeGroups(const SnowfallNode& snowfall, double numberDensity) {
  std::vector<FlakeGroup> groups;
  const int count = std::clamp(snowfall.groups, 1, 32);
  if (snowfall.flakeCount <= 0 || !(snowfall.boxSize > 0.0)) return groups;
  const double first = count == 1 ? snowfall.boxSize : std::min(kNearestBox, 0.25 * snowfall.boxSize);
  const double ratio = count == 1 ? 1.0 : std::pow(snowfall.boxSize / first, 1.0 / (count - 1));
  double edges = 0.0;
  for (int g = 0; g < count; ++g) edges += first * std::pow(ratio, g);
  double nearest = 0.0;
  for (int g = 0; g < count; ++g) {
    FlakeGroup group;
    group.box = g == count - 1 ? snowfall.boxSize : first * std::pow(ratio, g);
    const double blocks = static_cast<double>(snowfall.flakeCount) / kFlakeBlock * group.box / edges;
    group.blocks = static_cast<std::uint32_t>(std::max(std::round(blocks), 1.0));
    group.weight = numberDensity * group.box * group.box * group.box / group.flakes();
    group.nearest = nearest;
    group.farthest = nearest = 0.5 * group.box * kBorder;
    groups.push_back(group);
  }
  return groups;
}

std::size_t flakeCountOf(const std::vector<FlakeGroup>& groups) {
  std::size_t sum = 0;
  for (const FlakeGroup& group : groups) sum += group.flakes();
  return sum;
}

}  // namespace spin
