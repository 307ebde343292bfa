// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/sim/snapshot.h"
#include "editor/viewport/orbit_camera.h"

namespace spin {

/// What a ray from the eye meets first.
struct PickHit {
  std::string node;
  Vec3d point{};  ///< local m
};

/// The nearest model triangle or terrain point under a ray; nothing where the ray meets neither.
std::optional<PickHit> pickScene(const SceneSnapshot& scene, double filmTime, const ViewRay& ray);
/// Where a ray meets the terrain; nothing without terrain or beside it.
std::optional<Vec3d> pickTerrain(const SceneSnapshot& scene, const ViewRay& ray);
/// Bounding box of one node in local metres; empty for nodes without a place (weather, settings).
Box3d nodeBounds(const SceneSnapshot& scene, const std::string& id, double filmTime);
/// Neither terrain nor model is there, nor what flows without them; cheap.
bool showsNothing(const SceneSnapshot& scene);
/// Keeps the eye off the terrain; beyond the rim its height goes on, holes and scenes without terrain have no
/// floor. Null without terrain.
EyeFloor eyeFloor(const SceneSnapshot& scene);
/// Bounding box of all that stands in the scene; without terrain also of what flows.
Box3d sceneBounds(const SceneSnapshot& scene, double filmTime);

}  // namespace spin
