// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/tank.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

std::shared_ptr<SceneSnapshot> flowScene(bool closed) {
  auto settings = std::make_shared<FlowSettingsNode>();
  settings->closed = closed;
  settings->domainMin = {1.0, 2.0, -1.0};
  settings->domainMax = {5.0, 4.0, 3.0};
  SceneNode node = makeNode(kFlowSettingsType, "flow_settings", "Flow");
  node.data = settings;
  auto scene = std::make_shared<SceneSnapshot>();
  scene->nodes.push_back(std::move(node));
  return scene;
}

TEST(Tank, StandsRoundAClosedDomain) {
  const auto scene = flowScene(true);
  const SnapshotPointer shown = withTank(scene);
  ASSERT_NE(shown, scene);
  EXPECT_EQ(scene->nodes.size(), 1u) << "the scene itself stays as it is";
  const std::vector<const SceneNode*> models = shown->all<ModelNode>();
  ASSERT_EQ(models.size(), 1u);
  const ModelData& tank = *shown->models.at(models[0]->id);
  const Transform place = shown->modelTransform(*models[0], 0.0);
  Box3d box;
  for (const Mesh& mesh : tank.meshes) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
      const Vec3d a = mesh.positions[mesh.indices[k]].to<double>(),
                  b = mesh.positions[mesh.indices[k + 1]].to<double>(),
                  c = mesh.positions[mesh.indices[k + 2]].to<double>();
      const Vec3d n = mesh.normals[mesh.indices[k]].to<double>();
      EXPECT_GT(dot(cross(b - a, c - a), n), 0.0) << "seen from outside";
    }
    for (const Vec3f& p : mesh.positions) {
      const Vec3d at = place.point(p.to<double>());
      box.extend(at);
      const bool inside =
          at.x > 1.001 && at.x < 4.999 && at.y > 2.001 && at.y < 3.999 && at.z > -0.999 && at.z < 2.999;
      EXPECT_FALSE(inside) << "flow has the room for itself";
    }
  }
  EXPECT_LT(box.min.z, -1.0);
  EXPECT_NEAR(box.max.z, 1.0, 0.1) << "half as high as it is long";
  EXPECT_NEAR(box.min.x, 1.0, 0.2);
  EXPECT_NEAR(box.max.y, 4.0, 0.2);
}

TEST(Tank, IsOnlyWhereThereIsOne) {
  const auto open = flowScene(false);
  EXPECT_EQ(withTank(open), open);
  const auto land = flowScene(true);
  land->terrain = std::make_shared<TerrainData>();
  EXPECT_EQ(withTank(land), land);
  const auto empty = std::make_shared<SceneSnapshot>();
  EXPECT_EQ(withTank(empty), empty);
  EXPECT_EQ(withTank(nullptr), nullptr);
}

}  // namespace
}  // namespace spin
