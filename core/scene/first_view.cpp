// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/first_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"

namespace spin {

std::optional<Vec3d> groundNear(const Raster<float>& heights, double column, double row) {
  std::optional<Vec3d> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i) {
      const double distance = (i - column) * (i - column) + (j - row) * (j - row);
      if (distance >= least || std::isnan(heights.at(i, j))) continue;
      least = distance;
      nearest = Vec3d{heights.x(i), heights.y(j), static_cast<double>(heights.at(i, j))};
    }
  return nearest;
}

std::optional<FirstView> firstViewOf(const Raster<float>& heights) {
  const std::optional<Vec3d> target = groundNear(heights, 0.5 * heights.width, 0.5 * heights.height);
  if (!target) return {};
  constexpr int kSides = 8;
  const double distance =
      std::clamp(0.03 * heights.cellSize * std::min(heights.width, heights.height), 30.0, 300.0);
  const TerrainSurface surface(heights);
  FirstView view{*target, *target};
  double lowest = std::numeric_limits<double>::infinity();
  for (int side = 0; side < kSides; ++side) {
    const double turn = 2.0 * kPi * side / kSides;
    const Vec3d eye = *target + Vec3d{-std::sin(turn), -std::cos(turn), 0.0} * distance;
    const double ground = surface.heightAt(eye.x, eye.y).value_or(target->z);
    if (ground >= lowest) continue;
    lowest = ground;
    view.position = {eye.x, eye.y, std::max(ground + 0.15 * distance, target->z + 0.3 * distance)};
  }
  return view;
}

}  // namespace spin
