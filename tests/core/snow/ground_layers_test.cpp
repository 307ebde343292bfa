// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/ground_layers.h"

#include <gtest/gtest.h>

#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// 9 x 9 points, 2 m apart.
SceneSnapshot flatScene() {
  return test::TestScene().land(9, 9, 2.0, [](double, double) { return 0.0; }).build();
}

TiledRaster<float> layerOf(float fill, int side = 9) {
  return {side, side, fill};
}

template <class T>
SceneNode painted(const NodeType& type, const T& data, PaintedLayer layer, const std::string& id) {
  SceneNode made = test::node(type, id, data);
  made.painted = std::move(layer);
  return made;
}

TEST(GroundLayers, AreUnpaintedWithoutNodes) {
  const SceneSnapshot scene = flatScene();
  const GroundLayers layers = groundLayersOn(scene, scene.terrain->heights);
  ASSERT_EQ(layers.type.size(), 81u);
  EXPECT_EQ(layers.type[40], GroundTypeLayerNode{}.base);
  EXPECT_TRUE(std::isnan(layers.temperature[40]));
  EXPECT_TRUE(std::isnan(layers.startDepth[40]));
  EXPECT_TRUE(layers.keepClear.empty());
  EXPECT_TRUE(clearedShares(scene, layers, 0.0).empty());
}

TEST(GroundLayers, GiveWhatIsPaintedAtThePointsOfTheTerrain) {
  SceneSnapshot scene = flatScene();
  TiledRaster<std::uint8_t> types(9, 9, kUnpaintedGround);
  types.set(3, 4, static_cast<std::uint8_t>(GroundType::Asphalt));
  GroundTypeLayerNode base;
  base.base = GroundType::Sand;
  scene.nodes.push_back(painted(kGroundTypeLayerType, base, types, "types"));
  TiledRaster<float> kelvin = layerOf(kNone);
  kelvin.set(3, 4, 281.0f);
  scene.nodes.push_back(painted(kGroundTemperatureLayerType, GroundTemperatureLayerNode{}, kelvin, "warm"));
  TiledRaster<float> depth = layerOf(kNone);
  depth.set(5, 1, 0.75f);
  SnowDepthLayerNode snow;
  snow.density = 320.0;
  snow.use = SnowDepthUse::Add;
  scene.nodes.push_back(painted(kSnowDepthLayerType, snow, depth, "depth"));

  const Raster<float>& grid = scene.terrain->heights;
  const GroundLayers layers = groundLayersOn(scene, grid);
  EXPECT_EQ(layers.type[grid.index(3, 4)], GroundType::Asphalt);
  EXPECT_EQ(layers.type[grid.index(4, 4)], GroundType::Sand);
  EXPECT_FLOAT_EQ(layers.temperature[grid.index(3, 4)], 281.0f);
  EXPECT_TRUE(std::isnan(layers.temperature[grid.index(2, 4)]));
  EXPECT_FLOAT_EQ(layers.startDepth[grid.index(5, 1)], 0.75f);
  EXPECT_TRUE(std::isnan(layers.startDepth[grid.index(1, 5)]));
  EXPECT_EQ(layers.startDensity, 320.0);
  EXPECT_TRUE(layers.startAdds);
}

TEST(GroundLayers, InterpolateOnFineGridsAmongPaintedPointsOnly) {
  SceneSnapshot scene = flatScene();
  TiledRaster<float> depth = layerOf(kNone);
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i <= 4; ++i) depth.set(i, j, 0.1f * static_cast<float>(i));
  scene.nodes.push_back(painted(kSnowDepthLayerType, SnowDepthLayerNode{}, depth, "depth"));
  const Raster<float> fine(40, 8, 0.25, 3.25, 0.5);
  const GroundLayers layers = groundLayersOn(scene, fine);
  for (int i = 0; i < fine.width; ++i) {
    const double x = fine.x(i);
    const float got = layers.startDepth[fine.index(i, 3)];
    if (x < 8.0)
      EXPECT_NEAR(got, 0.05 * x, 1e-6) << x;  // 0.1 m a point, points 2 m apart
    else if (x < 9.0)
      EXPECT_NEAR(got, 0.4, 1e-6)
          << x;  // up to half way to the first unpainted point, at the last one's depth
    else
      EXPECT_TRUE(std::isnan(got)) << x;
  }
}

TEST(GroundLayers, EndWithTheCellsOfTheTerrain) {
  SceneSnapshot scene = flatScene();
  scene.nodes.push_back(painted(kSnowDepthLayerType, SnowDepthLayerNode{}, layerOf(1.0f), "depth"));
  const Raster<float> wide(3, 1, -1.5, 4.0, 0.75);  // x = -1.5, -0.75, 0
  const std::vector<float> depth = groundLayersOn(scene, wide).startDepth;
  EXPECT_TRUE(std::isnan(depth[0]));
  EXPECT_FLOAT_EQ(depth[1], 1.0f);
  EXPECT_FLOAT_EQ(depth[2], 1.0f);
}

TEST(GroundLayers, IgnoreALayerOfAnotherSizeAndAOneCellTerrainWorks) {
  SceneSnapshot scene = flatScene();
  scene.nodes.push_back(painted(kSnowDepthLayerType, SnowDepthLayerNode{}, layerOf(1.0f, 8), "depth"));
  EXPECT_TRUE(std::isnan(groundLayersOn(scene, scene.terrain->heights).startDepth[0]));

  SceneSnapshot tiny = test::TestScene().land(1, 1, 2.0, [](double, double) { return 0.0; }).build();
  tiny.nodes.push_back(painted(kSnowDepthLayerType, SnowDepthLayerNode{}, layerOf(1.0f, 1), "depth"));
  EXPECT_FLOAT_EQ(groundLayersOn(tiny, tiny.terrain->heights).startDepth[0], 1.0f);
}

TEST(GroundLayers, MasksClearWhileTheyWorkAndLeaveTheProduct) {
  SceneSnapshot scene = flatScene();
  KeepClearLayerNode road;
  road.strength = 0.5;
  road.start = 2.0;
  road.stop = 4.0;
  scene.nodes.push_back(painted(kKeepClearLayerType, road, layerOf(0.8f), "road"));
  scene.nodes.push_back(painted(kKeepClearLayerType, KeepClearLayerNode{}, layerOf(0.25f), "yard"));
  const GroundLayers layers = groundLayersOn(scene, scene.terrain->heights);
  ASSERT_EQ(layers.keepClear.size(), 2u);
  EXPECT_NEAR(clearedShares(scene, layers, 1.0)[7], 0.25, 1e-6);
  EXPECT_NEAR(clearedShares(scene, layers, 2.0)[7], 1.0 - 0.6 * 0.75, 1e-6);
  EXPECT_NEAR(clearedShares(scene, layers, 4.0)[7], 0.25, 1e-6);
  scene.nodes.back().enabled = false;
  EXPECT_TRUE(clearedShares(scene, groundLayersOn(scene, scene.terrain->heights), 5.0).empty());
}

TEST(GroundLayers, StrengthMayBeAnimated) {
  SceneSnapshot scene = flatScene();
  SceneNode yard = painted(kKeepClearLayerType, KeepClearLayerNode{}, layerOf(1.0f), "yard");
  yard.curves["strength"].setKey({0.0, 0.0, Interpolation::Linear});
  yard.curves["strength"].setKey({10.0, 1.0, Interpolation::Linear});
  scene.nodes.push_back(yard);
  const GroundLayers layers = groundLayersOn(scene, scene.terrain->heights);
  EXPECT_NEAR(clearedShares(scene, layers, 4.0)[0], 0.4, 1e-6);
  EXPECT_TRUE(clearedShares(scene, layers, 0.0).empty());
}

Hash128 keyOf(const SceneSnapshot& scene) {
  Hasher hasher;
  const StepInput input{scene, scene.timeOf(3), scene.timeOf(4)};
  hashGroundLayers(input, hasher);
  hashKeepClear(input, hasher);
  return hasher.digest();
}

TEST(GroundLayers, CountInTheKeysByWhatIsPainted) {
  SceneSnapshot scene = flatScene();
  TiledRaster<float> layer = layerOf(0.5f);
  const std::vector<const NodeType*> types = {&kGroundTemperatureLayerType, &kSnowDepthLayerType,
                                              &kKeepClearLayerType};
  for (const NodeType* type : types) {
    scene.nodes.push_back(makeNode(*type, type->id, type->label));
    scene.nodes.back().painted = layer;
  }
  const Hash128 before = keyOf(scene);
  EXPECT_EQ(keyOf(scene), before);
  layer.set(4, 4, 0.625f);
  for (std::size_t k = 0; k < types.size(); ++k) {
    SceneSnapshot edited = scene;
    edited.nodes[scene.nodes.size() - 1 - k].painted = layer;
    EXPECT_NE(keyOf(edited), before) << types[types.size() - 1 - k]->id;
  }
}

}  // namespace
}  // namespace spin
