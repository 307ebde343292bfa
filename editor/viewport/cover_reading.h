// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <array>
#include <optional>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/sim/frame.h"
#include "editor/viewport/view_frame.h"

namespace spin {

/// What lies under the pointer.
struct CoverReading {
  std::string node;                ///< of the terrain or the model
  Vec3d point{};                   ///< on the bare surface below the snow, local m
  bool covered = false;            ///< the frame has a cover here; else there are no values
  std::array<float, 7> values{};   ///< by SnowDisplay, in the units of coverUnit(); NaN = none
  std::optional<GroundType> type;  ///< of the ground, or of the model's surface

  float value(SnowDisplay of) const { return values[static_cast<std::size_t>(of)]; }
};

/// Reads the cover where a ray meets the drawn snow, or the bare surface; nothing where it meets neither.
/// `frame` may be null. Of the terrain's grids the finest counts, of a model's patches the nearest.
std::optional<CoverReading> readCover(const SceneSnapshot& scene, const Frame* frame, double filmTime,
                                      const ViewRay& ray);

/// The reading in one line.
QString readingText(const CoverReading& reading);

}  // namespace spin
