// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/air/air_solver.h"
#include "core/air/air_window.h"

namespace spin {

/// A face between the domain and what lies beyond one of its walls.
inline constexpr float kWallFace = -1.0f;
/// Volumes of cut cells count as at least this share, so that they do not rule the step.
inline constexpr float kLeastVolume = 0.25f;

/// How solids cut the cells of a brick.
struct BrickSolids {
  std::array<std::array<float, kBrickCells>, 3> area;  ///< open share of lower faces, or kWallFace
  std::array<float, kBrickCells> volume;               ///< open share of cells: 0, or kLeastVolume to 1
  std::array<float, kBrickCells> flux;  ///< net outflow by the solids' own motion, of a cell's face times m/s
  bool open = true;                     ///< all shares are 1
  bool moves = false;                   ///< a moving solid may be in it

  friend bool operator==(const BrickSolids&, const BrickSolids&) = default;
};

/// Shares of faces from the distances at their corners, of cells from those of their faces.
BrickSolids cutBrick(const AirConfig& config, const BrickKey& key);

/// Velocity of the solid that is nearest to a place; 0 where it stands.
Vec3d nearestSolidVelocity(const AirConfig& config, Vec3d place);

/// Share of a square in which a field is positive, from its values at the corners, in order round it: four
/// triangles with the mean in the middle, each cut exactly.
double positiveShare(const std::array<double, 4>& corners);

}  // namespace spin
