// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/fields/raster.h"
#include "core/sim/snapshot.h"
#include "editor/commands/edits.h"

namespace spin {

class Viewport;

/// What the middle of the view shows of the terrain.
struct ViewSight {
  std::optional<Vec3d> place;  ///< local m; nothing beside the terrain
  std::shared_ptr<const TerrainData> terrain;
  double distance = 50.0;  ///< from the eye to the place, m
  Vec3d eye{};
  Vec3d target{};  ///< what the view's camera looks at
  double fovDegrees = 45.0;
};
ViewSight sightOf(const Viewport& viewport);

/// First values of a new node that has a place: where the view looks, as large as a good part of what it
/// shows; what flows is turned downhill. A camera takes the view, a rigid body the selected model. Empty for
/// other types.
edit::PropertyValues placedDefaults(const NodeType& type, const ViewSight& sight,
                                    const std::string& selected);

}  // namespace spin
