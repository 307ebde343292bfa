// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/fields/ray_scene.h"
#include "core/fields/terrain_surface.h"
#include "core/snow/snow_ground.h"

namespace spin {

/// A vertical face under the edge of the terrain's surface, down to the domain's floor. The ground is solid:
/// snow that comes in below an edge ends there.
struct SkirtEdge {
  Vec3d from, to;         ///< along the terrain's edge, local m
  Vec3d outward;          ///< unit, away from the ground, horizontal
  bool onBorder = false;  ///< coincides with a side of the domain: no air outside it
};

/// A model where it stands at one time.
struct StandingModel {
  Transform placement;
  std::vector<PlacedTriangle> triangles;  ///< relative to the placement's translation
  std::uint32_t geometry = 0;             ///< in the ray scene
};

/// Where the models stand at film time 0, for what does not depend on when it is asked for first.
std::vector<StandingModel> modelsAtStart(const SceneSnapshot& snapshot, const SnowGround& ground);

/// Everything that snow can hit at one time, and the box of air it falls through.
struct SnowScene {
  std::shared_ptr<RayScene> rays;  ///< coordinates less `centre`, to keep float's digits
  Vec3d centre{};
  Box3d domain;            ///< local m; empty if there is nothing to land on
  double tolerance = 0.0;  ///< m, within which a packet's end counts as on the ground
  bool hasTerrain = false;
  std::uint32_t terrainGeometry = 0, skirtGeometry = 0;
  std::vector<SkirtEdge> skirts;
  std::vector<StandingModel> models;  ///< in the order of SnowGround::models
  double airVolume = 0.0;             ///< m3 in the domain above the terrain
  double level = 0.0;                 ///< height of the domain's floor

  /// How far a ray's origin stands off its surface, m: a few times the spacing of floats there, so that it
  /// lies on the right side of its own triangle and yet jumps through no sheet that is thicker.
  static double standOff(Vec3d p) {
    return 1e-6 + 6e-7 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }

  /// Ray that asks whether snow falling along `fall` (unit) reaches a point of a surface whose unit normal on
  /// the side in question is `side`.
  Ray towardsSky(Vec3d point, Vec3d side, Vec3d fall) const {
    const Vec3d p = point - centre;
    const Vec3d from = p + side * standOff(p);
    return {from.to<float>(), (-fall).to<float>(), 0.0f, std::numeric_limits<float>::infinity()};
  }
};

/// Makes the snow scenes of a run one after the other. The land and the models that stand still are put into
/// the ray scene once, and only what moves anew; a scene is the same as one that is made afresh.
class SnowSceneMaker {
 public:
  explicit SnowSceneMaker(RaySceneFactory makeRayScene) : m_makeRayScene(std::move(makeRayScene)) {}

  /// Nothing when cancelled. The ground must be of the same run each time.
  std::optional<SnowScene> at(const SceneSnapshot& scene, const SnowGround& ground, double filmTime,
                              const CancelToken& cancel = {});

 private:
  struct Still {
    Box3d domain;
    std::shared_ptr<RayScene> rays;
    std::uint32_t geometries = 0;
    std::vector<SkirtEdge> skirts;
    double groundVolume = 0.0;
    std::vector<std::optional<Transform>> placement;  ///< by model; none if it may move
    std::vector<std::uint32_t> geometry;              ///< by model
    bool hasTerrain = false;
    std::uint32_t terrainGeometry = 0, skirtGeometry = 0;
  };
  bool buildStill(const SceneSnapshot& snapshot, const SnowGround& ground, const SnowScene& scene,
                  const CancelToken& cancel);
  bool fits(const SnowScene& scene) const;

  RaySceneFactory m_makeRayScene;
  std::optional<Still> m_still;
};

/// One snow scene; nothing when cancelled.
std::optional<SnowScene> makeSnowScene(const SceneSnapshot& scene, const SnowGround& ground, double filmTime,
                                       const RaySceneFactory& makeRayScene, const CancelToken& cancel = {});

}  // namespace spin
