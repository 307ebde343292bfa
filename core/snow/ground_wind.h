// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/snow/wind_shelter.h"

namespace spin {

/// The wind at all cells of a cover's graph, for one wind over the land.
struct GroundWind {
  std::vector<Vec2f> direction;  ///< where it blows to, unit; zero in calm air
  std::vector<float> friction;   ///< m/s, in the open: without the lee's shelter
  std::vector<UpwindSlope> shelter;

  /// Friction velocities that the cells' snow feels, m/s, where it lies so deep.
  void sheltered(const double* depth, const ShelterSettings& settings, CpuBackend& backend,
                 std::vector<float>& friction) const;
};

/// wind10: m/s, 10 m above level ground. Friction is that of the log profile times the field's speed-up 2 m
/// above a cell, on models at their height above the ground.
GroundWind groundWind(const CoverGraph& graph, const WindField& field, const WindObstacles& obstacles,
                      Vec2d wind10, double roughness, const ShelterSettings& settings, CpuBackend& backend);

}  // namespace spin
