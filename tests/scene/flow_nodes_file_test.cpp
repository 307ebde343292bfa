// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/nodes/flow_nodes.h"
#include "core/scene/asset_library.h"
#include "core/scene/scene_file.h"

namespace spin {
namespace {

Result<LoadedScene> readRelease(const std::string& properties) {
  return readSceneText(
      "{\"format\": \"spindrift-scene\", \"schema\": 2, \"min_reader\": 2, \"nodes\": [{\"id\": \"slab\", "
      "\"type\": \"avalanche_release\", \"properties\": {" +
          properties + "}}]}",
      "test");
}

std::string errorOf(const std::string& properties) {
  const Result<LoadedScene> loaded = readRelease(properties);
  return loaded ? std::string("no error") : loaded.error().text();
}

TEST(FlowNodesFile, AnOutlineIsAnArrayOfPoints) {
  const Result<LoadedScene> loaded =
      readRelease("\"outline_m\": [[1, 2.5], [30, -4], [0.125, 9]], \"material\": \"wet_snow\"");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const SceneNode* node = loaded->scene.find("slab");
  ASSERT_TRUE(node);
  const auto* release = node->as<AvalancheReleaseNode>();
  ASSERT_TRUE(release);
  EXPECT_EQ(release->outline, (PlanPoints{{1, 2.5}, {30, -4}, {0.125, 9}}));
  EXPECT_EQ(release->material, FlowMaterialKind::WetSnow);
  const std::string text = writeSceneText(loaded->scene, {});
  const Result<LoadedScene> again = readSceneText(text, "again");
  ASSERT_TRUE(again.ok()) << again.error().text();
  EXPECT_EQ(writeSceneText(again->scene, {}), text);
}

TEST(FlowNodesFile, OutlinesThatAreNoneAreRefusedByPlace) {
  for (const char* bad : {"\"outline_m\": 3", "\"outline_m\": [1, 2]", "\"outline_m\": [[1, 2, 3]]",
                          "\"outline_m\": [[1, \"2\"]]", "\"outline_m\": \"1 2; 3 4\""})
    EXPECT_NE(errorOf(bad).find("an array of points"), std::string::npos) << errorOf(bad);
  EXPECT_NE(errorOf("\"outline_m\": [[1, 2e9]]").find("allowed is -1000000 to 1000000"), std::string::npos);
  EXPECT_NE(errorOf("\"outline\": []").find("Did you mean \"outline_m\"?"), std::string::npos);
}

TEST(FlowNodesFile, APaintedReleaseHoldsItsTwoValuesOnly) {
  const SceneNode node = makeNode(kAvalancheReleaseType, "slab", "Slab");
  TiledRaster<std::uint8_t> area(3, 2, kReleaseUnpainted);
  area.set(1, 1, kReleasePainted);
  EXPECT_TRUE(checkLayer(node, area).ok());
  area.set(0, 0, 7);
  EXPECT_FALSE(checkLayer(node, area).ok());
  EXPECT_FALSE(checkLayer(node, TiledRaster<float>(3, 2, 1.0f)).ok());
}

}  // namespace
}  // namespace spin
