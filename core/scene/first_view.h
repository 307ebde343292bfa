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
/// A camera for a terrain that nobody has looked at yet: from the lowest side towards the ground nearest to
/// the middle, 3 % of the terrain's extent away (30 to 300 m). Nothing if there is no ground.
std::optional<FirstView> firstViewOf(const Raster<float>& heights);

}  // namespace spin
