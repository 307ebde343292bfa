// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/snapshot.h"

#include <gtest/gtest.h>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/terrain_node.h"
#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

using test::setProperty;

Hash128 hashOf(const SceneSnapshot& scene, const SceneNode& node, double filmTime = 0.0) {
  Hasher hasher;
  scene.hashNode(node, filmTime, hasher);
  return hasher.digest();
}

TEST(Snapshot, TimesFollowFrameRateAndTimeScale) {
  SceneSnapshot scene = test::testScene();
  setProperty(scene.nodes[2], "time_scale", 2880.0);
  const FrameTime time = scene.timeOf(25);
  EXPECT_EQ(time.frame, 25);
  EXPECT_DOUBLE_EQ(time.film, 2.5);
  EXPECT_DOUBLE_EQ(time.weather, 7200.0);
}

TEST(Snapshot, ModelsStandOnTheGround) {
  SceneSnapshot scene;
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(4, 4, 0, 0, 10, 7.0f);
  scene.terrain = terrain;
  SceneNode hut = makeNode(kModelType, "hut", "Hut");
  setProperty(hut, "position_m", Vec3d{12, 13, 1});
  setProperty(hut, "rotation_deg", Vec3d{0, 0, 90});
  setProperty(hut, "scale", Vec3d{2, 2, 2});
  const Vec3d corner = scene.modelTransform(hut, 0.0).point({1, 0, 0});
  EXPECT_NEAR(corner.x, 12.0, 1e-12);
  EXPECT_NEAR(corner.y, 15.0, 1e-12);
  EXPECT_NEAR(corner.z, 8.0, 1e-12);
  setProperty(hut, "on_ground", false);
  EXPECT_NEAR(scene.modelTransform(hut, 0.0).translation.z, 1.0, 1e-12);
  setProperty(hut, "on_ground", true);
  setProperty(hut, "position_m", Vec3d{-500, 13, 1});
  EXPECT_NEAR(scene.modelTransform(hut, 0.0).translation.z, 8.0, 1e-12)
      << "outside the terrain, on the height of its rim";
}

TEST(Snapshot, HashCountsWhatTheSimulationUses) {
  const SceneSnapshot scene = test::testScene();
  const SceneNode weather = scene.nodes[0];
  SceneNode other = weather;
  setProperty(other, "wind_speed_m_s", 9.0);
  EXPECT_NE(hashOf(scene, weather), hashOf(scene, other));
  other = weather;
  setProperty(other, "sun_azimuth_deg", 10.0);
  EXPECT_EQ(hashOf(scene, weather), hashOf(scene, other)) << "the sun only lights the picture";
  other = weather;
  other.name = "Storm";
  EXPECT_EQ(hashOf(scene, weather), hashOf(scene, other));
  other.enabled = false;
  EXPECT_NE(hashOf(scene, weather), hashOf(scene, other));
}

TEST(Snapshot, HashFollowsCurvesAtTheTimeAsked) {
  const SceneSnapshot scene = test::testScene();
  const SceneNode plain = scene.nodes[0];
  SceneNode animated = plain;
  AnimationCurve& curve = animated.curves["wind_speed_m_s"];
  curve.setKey({0.0, 2.0, Interpolation::Step});
  curve.setKey({1.0, 5.0, Interpolation::Step});
  EXPECT_EQ(hashOf(scene, plain, 0.5), hashOf(scene, animated, 0.5));
  EXPECT_NE(hashOf(scene, plain, 1.0), hashOf(scene, animated, 1.0));
}

TEST(Snapshot, HashTakesFilesByContentAndNotByName) {
  SceneSnapshot scene;
  SceneNode hut = makeNode(kModelType, "hut", "Hut");
  scene.assetHashes["hut"] = {1, 2};
  const Hash128 before = hashOf(scene, hut);
  setProperty(hut, "source", std::string("other/hut.glb"));
  EXPECT_EQ(hashOf(scene, hut), before);
  scene.assetHashes["hut"] = {1, 3};
  EXPECT_NE(hashOf(scene, hut), before);
}

TEST(Snapshot, HashSeesDataWithoutAFile) {
  SceneSnapshot scene;
  const SceneNode node = makeNode(kTerrainType, "terrain", "Terrain");
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(4, 4, 0, 0, 10, 7.0f);
  scene.terrain = terrain;
  const Hash128 before = hashOf(scene, node);
  terrain->heights.values[5] = 8.0f;
  EXPECT_NE(hashOf(scene, node), before);

  const SceneNode hut = makeNode(kModelType, "hut", "Hut");
  auto model = std::make_shared<ModelData>();
  model->meshes.push_back({"m", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}, {}, {0, 1, 2}, 0});
  model->instances.push_back({0, {}});
  scene.models["hut"] = model;
  const Hash128 modelBefore = hashOf(scene, hut);
  model->instances[0].transform.translation.x = 1.0;
  EXPECT_NE(hashOf(scene, hut), modelBefore);
}

TEST(Snapshot, HashSeesOnePaintedCell) {
  const SceneSnapshot scene;
  SceneNode ground = makeNode(kGroundTypeLayerType, "ground", "Ground");
  const Hash128 bare = hashOf(scene, ground);
  TiledRaster<std::uint8_t> layer(200, 130, 3);
  ground.painted = layer;
  const Hash128 filled = hashOf(scene, ground);
  EXPECT_NE(filled, bare);
  layer.set(150, 100, 4);
  ground.painted = layer;
  EXPECT_NE(hashOf(scene, ground), filled);
  layer.set(150, 100, 3);
  ground.painted = layer;
  EXPECT_EQ(hashOf(scene, ground), filled) << "a tile of its own with the old content";
}

}  // namespace
}  // namespace spin
