// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/import_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/nodes/camera_node.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "tests/support/node_data.h"

namespace spin {
namespace {

TEST(ImportScene, ANodeIsNamedAfterItsFileAndKeepsItsOptions) {
  Scene scene;
  ImportOptions options;
  options.epsg = 31287;
  options.noDataValue = -9999.0;
  const SceneNode terrain = importedNode(scene, kTerrainType, "/a/Valley (2).asc", {}, options);
  EXPECT_EQ(terrain.id, "terrain");
  EXPECT_EQ(terrain.name, "Valley (2)");
  EXPECT_EQ(test::dataOf<TerrainNode>(&terrain).epsg, 31287);
  EXPECT_TRUE(test::dataOf<TerrainNode>(&terrain).hasNoData);
  EXPECT_EQ(test::dataOf<TerrainNode>(&terrain).noData, -9999.0);
  options.upAxis = 2;
  const SceneNode model = importedNode(scene, kModelType, "/a/Hut (2).glb", "Shed", options);
  EXPECT_EQ(model.id, "hut_2");
  EXPECT_EQ(model.name, "Shed");
  EXPECT_EQ(test::dataOf<ModelNode>(&model).upAxis, ModelUpAxis::Z);
}

TEST(ImportScene, SnowIsSetUpOnceOnly) {
  Scene scene = makeDefaultScene();
  applySetUp(snowSetUp(scene), scene);
  EXPECT_TRUE(scene.firstOf(kSnowfallType));
  EXPECT_EQ(test::dataOf<SimulationNode>(scene.find("simulation")).timeScale, 2880.0);
  EXPECT_TRUE(snowSetUp(scene).changes.empty());
  EXPECT_TRUE(snowSetUp(scene).added.empty());
  Scene slow = makeDefaultScene();
  ASSERT_TRUE(slow.setFromText("simulation.time_scale", "10").ok());
  EXPECT_TRUE(snowSetUp(slow).added.empty());
}

TEST(ImportScene, OnlyAnUntouchedCameraIsTurned) {
  Scene scene = makeDefaultScene();
  const FirstView view{{1, 2, 3}, {4, 5, 6}};
  EXPECT_FALSE(cameraTarget(scene)) << "there is no ground to look at";
  applySetUp(cameraSetUp(scene, view), scene);
  EXPECT_EQ(test::dataOf<CameraNode>(scene.find("camera")).position, view.position);
  EXPECT_TRUE(cameraSetUp(scene, view).changes.empty());
  ASSERT_TRUE(scene.append(makeNode(kTerrainType, "terrain", "Terrain")).ok());
  EXPECT_EQ(cameraTarget(scene), view.target);
}

TEST(ImportScene, ModelsStandOnGroundAndNotInHoles) {
  EXPECT_EQ(standingPlace({10.4, 20.6, 99.0}, nullptr), (Vec3d{10, 21, 0}));
  Raster<float> heights(20, 20, 0.0, 0.0, 1.0, 5.0f);
  EXPECT_EQ(standingPlace({10.4, 12.6, 5.0}, &heights), (Vec3d{10, 13, 0}));
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 10; ++i) heights.at(i, j) = std::nanf("");
  EXPECT_EQ(standingPlace({3.0, 4.0, 0.0}, &heights), (Vec3d{10, 4, 0}));
  EXPECT_EQ(standingPlace({100.0, 4.0, 0.0}, &heights), (Vec3d{19, 4, 0})) << "beside the terrain";
}

}  // namespace
}  // namespace spin
