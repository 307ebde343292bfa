// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/fields/raster.h"
#include "core/math/vec.h"

namespace spin {

/// The cell with data nearest to a place given in columns and rows; nothing if none has data.
std::optional<Vec3d> groundNear(const Raster<float>& heights, double column, double row);

struct FirstView {
  Vec3d position{};  ///< of the camera, m, local; above the ground
  Vec3d target{};    ///< a point of the ground near the terrain's middle
};
/// m; from farther away a hut would be a dot, and a snowfall would hide it in pictures.
inline constexpr double kFarthestFirstView = 250.0;

/// A camera for a terrain that nobody has looked at yet: towards the ground nearest to the middle of what has
/// data, from 0.8 of the terrain's extent away (10 m to kFarthestFirstView), from the side on which the
/// skyline stands best in the picture, at three quarters of its height. Nothing if there is no ground.
std::optional<FirstView> firstViewOf(const Raster<float>& heights);
/// A view of the whole terrain with the horizon above it, from the side to which it falls. The target is the
/// middle of its box. Nothing if there is no ground.
std::optional<FirstView> wholeViewOf(const Raster<float>& heights);

}  // namespace spin
