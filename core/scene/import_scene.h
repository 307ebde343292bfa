// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/asset_library.h"
#include "core/scene/first_view.h"

/// What an import makes of a scene. The command line and the editor share it, so that both give the same.
namespace spin {

/// A terrain or model node for a file that was read with these options, with a free id. It is named after the
/// file unless a name is given; its `source` is left to the caller, who may copy the file first.
SceneNode importedNode(const Scene& scene, const NodeType& type, const std::string& file,
                       const std::string& name, const ImportOptions& options);
/// Sets a property that the node's type has.
void setProperty(SceneNode& node, const std::string& property, const Value& value);
/// Checks all properties of a node against their ranges.
Status checkProperties(const SceneNode& node);

/// What a scene needs besides what was imported.
struct SceneSetUp {
  struct Change {
    std::string node;
    std::string property;
    Value value;
  };
  std::vector<Change> changes;   ///< of nodes that are there
  std::vector<SceneNode> added;  ///< with free ids; named after their types
};
/// Lets it snow, and so fast that the cover is seen to grow, in a scene that nobody has set up: one without
/// terrain and snowfall and in real time. Nothing for others.
SceneSetUp snowSetUp(const Scene& scene);
/// Turns the camera to a new terrain unless somebody has moved it.
SceneSetUp cameraSetUp(const Scene& scene, const FirstView& view);
void applySetUp(const SceneSetUp& setUp, Scene& scene);

/// What the scene's camera looks at; nothing without camera or terrain.
std::optional<Vec3d> cameraTarget(const Scene& scene);
/// `position_m` of a model that is to stand on the ground at a point that is looked at: in whole metres, and
/// beside a hole rather than in it where the heights are known.
Vec3d standingPlace(Vec3d lookedAt, const Raster<float>* heights);

}  // namespace spin
