// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/model_copies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/base/units.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

struct Scene {
  SceneSnapshot snapshot;
  SceneNode node = makeNode(kModelType, "tree", "tree");
  std::shared_ptr<ModelData> model = std::make_shared<ModelData>();

  explicit Scene(const ModelNode& data) {
    auto terrain = std::make_shared<TerrainData>();
    terrain->heights = Raster<float>(11, 11, 0.0, 0.0, 10.0);
    for (int j = 0; j < 11; ++j)
      for (int i = 0; i < 11; ++i) terrain->heights.at(i, j) = static_cast<float>(i);
    snapshot.terrain = terrain;
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 2}};
    mesh.indices = {0, 1, 2};
    model->meshes = {mesh};
    model->instances = {{0, translationOf({0.5, 0, 0})}, {0, Transform{}}};
    node.data = std::make_shared<ModelNode>(data);
    snapshot.nodes = {node};
  }
  /// Where a point of the model's instance k stands.
  Vec3d at(const ModelData& made, std::size_t k, Vec3d p) const {
    return (snapshot.modelTransform(node, 0.0) * made.instances[k].transform).point(p);
  }
};

ModelNode withPlaces() {
  ModelNode data;
  data.position = {20.0, 50.0, 0.25};
  data.rotationDegrees = {0.0, 0.0, 30.0};
  data.scale = {2.0, 2.0, 2.0};
  data.copies = {{50.0, 10.0}, {95.0, 90.0}};
  data.copyTurnDegrees = 0.0;
  data.copyScale = 0.0;
  return data;
}

TEST(ModelCopies, StandOnTheGroundAtTheirPlacesAsTheNodeDoesAtItsOwn) {
  const Scene scene(withPlaces());
  const auto made = withCopies(scene.model, scene.snapshot, scene.node);
  ASSERT_EQ(made->instances.size(), 6u);
  EXPECT_EQ(instancesOfACopy(scene.node, *made), 2u);
  EXPECT_EQ(made->meshes.size(), 1u) << "meshes are shared";
  const Vec3d first = scene.at(*made, 3, {}), second = scene.at(*made, 5, {});
  EXPECT_NEAR(first.x, 50.0, 1e-9);
  EXPECT_NEAR(first.y, 10.0, 1e-9);
  EXPECT_NEAR(first.z, 5.25, 1e-6) << "a quarter of a metre above the ground, as the node";
  EXPECT_NEAR(second.z, 9.75, 1e-6);
  // The same size and turn as the node's own.
  const Vec3d own = scene.at(*made, 1, {1, 0, 2}) - scene.at(*made, 1, {});
  const Vec3d copy = scene.at(*made, 3, {1, 0, 2}) - first;
  EXPECT_NEAR(length(own - copy), 0.0, 1e-9);
}

TEST(ModelCopies, TurnAndSizeAreRandomWithinTheirRangesAndFollowTheSeed) {
  ModelNode data = withPlaces();
  data.copies.assign(200, {50.0, 50.0});
  data.copyTurnDegrees = 90.0;
  data.copyScale = 0.2;
  const Scene scene(data);
  const auto made = withCopies(scene.model, scene.snapshot, scene.node);
  std::set<double> sizes;
  for (std::size_t k = 1; k <= 200; ++k) {
    const Vec3d out = scene.at(*made, 2 * k + 1, {1, 0, 0}) - scene.at(*made, 2 * k + 1, {});
    EXPECT_GE(length(out), 2.0 * 0.8 - 1e-9);
    EXPECT_LE(length(out), 2.0 * 1.2 + 1e-9);
    EXPECT_LE(std::abs(std::atan2(out.y, out.x) - kPi / 6.0), kPi / 4.0 + 1e-9);
    sizes.insert(length(out));
  }
  EXPECT_GT(sizes.size(), 190u);
  data.copySeed = 2;
  const Scene other(data);
  const auto again = withCopies(other.model, other.snapshot, other.node);
  EXPECT_FALSE(again->instances[3].transform == made->instances[3].transform);
}

TEST(ModelCopies, WithoutCopiesTheModelItself) {
  ModelNode data = withPlaces();
  data.copies.clear();
  const Scene scene(data);
  EXPECT_EQ(withCopies(scene.model, scene.snapshot, scene.node), scene.model);
  EXPECT_EQ(instancesOfACopy(scene.node, *scene.model), 2u);
}

}  // namespace
}  // namespace spin
