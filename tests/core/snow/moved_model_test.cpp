// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::boxMesh;
using test::modelOf;
using test::TestScene;

/// A valley with a hut and a sledge that crosses it by `speed` m a frame.
SceneSnapshot sledgeScene(double speed, bool maps, int detail = 2) {
  TestScene test;
  test.snowfall.fallSpreadDegrees = 12.0;
  test.weather.windSpeed = 0.6;
  test.simulation.exposureNoise = 0.2;
  test.simulation.exposureMethod = maps ? ExposureMethod::Maps : ExposureMethod::Rays;
  test.simulation.exposureMapSize = 256;
  test.terrain.coverDetailCell = 1.0 / detail;
  test.terrain.coverDetailMargin = 4.0;
  ModelNode hut, sledge;
  hut.position = {30.0, 62.0, 0.0};
  sledge.position = {20.0, 30.0, 0.0};
  test.land(71, 61, 2.0, [](double x, double y) { return 0.08 * x + 3.0 * std::sin(y / 20.0); })
      .model("hut", modelOf(boxMesh({-4, -3, 0}, {4, 3, 6})), hut)
      .model("sledge", modelOf(boxMesh({-1, -1, 0}, {1, 1, 2})), sledge);
  SceneSnapshot scene = test.build();
  for (SceneNode& node : scene.nodes)
    if (node.id == "sledge") {
      const double frames = 10.0, seconds = frames / 24.0;
      node.curves["position_m"].setKey({0.0, Vec3d{20.0, 30.0, 0.0}, Interpolation::Linear});
      node.curves["position_m"].setKey(
          {seconds, Vec3d{20.0 + speed * frames, 30.0 + 0.3 * speed * frames, 0.0}, Interpolation::Linear});
    }
  return scene;
}

class MovedModel : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(RaysAndMaps, MovedModel, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "Maps" : "Rays"; });

TEST_P(MovedModel, AskingOnlyWhatSeesItGivesTheSameBits) {
  const SceneSnapshot scene = sledgeScene(3.0, GetParam());
  const SnowGroundPointer ground = makeSnowGround(scene);
  CpuBackend backend(2);
  const CancelToken cancel;
  ExposureMemory memory;
  SnowSceneMaker scenes(makeBvhRayScene);
  std::size_t changed = 0;
  for (const double time : {0.0, 2.0 / 24.0, 7.0 / 24.0}) {
    const SnowScene standing = *scenes.at(scene, *ground, time);
    const SnowScene afresh = *makeSnowScene(scene, *ground, time, makeBvhRayScene);
    ExposureMemory kept = memory;
    const auto all =
        makeExposureField(scene, *ground, afresh, exposureSettings(scene, time), {backend, cancel, {}});
    const auto some = makeExposureField(scene, *ground, standing, exposureSettings(scene, time),
                                        {backend, cancel, {}}, &memory);
    ASSERT_TRUE(all.ok() && some.ok());
    for (std::size_t g = 0; g < all->grids.size(); ++g) {
      const auto& a = all->grids[g];
      const auto& b = some->grids[g];
      ASSERT_EQ(0, std::memcmp(a.held.data(), b.held.data(), a.held.size() * sizeof(float))) << time << g;
      ASSERT_EQ(0, std::memcmp(a.exposure.data(), b.exposure.data(), a.held.size() * sizeof(float)));
    }
    EXPECT_EQ(all->rates.deposited, some->rates.deposited);
    EXPECT_EQ(all->rates.shed, some->rates.shed);
    EXPECT_EQ(all->samplingRmse, some->samplingRmse);
    if (!kept.standing) continue;
    for (std::size_t g = 0; g < some->grids.size(); ++g)
      for (std::size_t c = 0; c < some->grids[g].exposure.size(); ++c)
        changed += kept.gathered.grids[g].exposure[c] != memory.gathered.grids[g].exposure[c] ? 1 : 0;
    const auto roof = std::find_if(ground->layout->grids.begin(), ground->layout->grids.end(),
                                   [](const CoverGrid& grid) { return grid.node == "hut"; });
    ASSERT_NE(roof, ground->layout->grids.end());
    EXPECT_FALSE(memory.gathered.grids[std::size_t(roof - ground->layout->grids.begin())].asked)
        << "the sledge does not pass the hut";
  }
  EXPECT_GT(changed, 10u) << "its shadow went along";
}

TEST_P(MovedModel, OtherDirectionsOfFallAskEverything) {
  const SceneSnapshot scene = sledgeScene(0.0, GetParam());
  const SnowGroundPointer ground = makeSnowGround(scene);
  CpuBackend backend(2);
  const CancelToken cancel;
  ExposureMemory memory;
  const SnowScene standing = *makeSnowScene(scene, *ground, 0.0, makeBvhRayScene);
  ExposureSettings settings = exposureSettings(scene, 0.0);
  ASSERT_TRUE(makeExposureField(scene, *ground, standing, settings, {backend, cancel, {}}, &memory).ok());
  ASSERT_TRUE(makeExposureField(scene, *ground, standing, settings, {backend, cancel, {}}, &memory).ok());
  for (const GatheredCover::Cells& cells : memory.gathered.grids) EXPECT_FALSE(cells.asked);
  settings.cone = fallCone({4.0, 0.0, 0.0}, 1.0, 0.1);
  ASSERT_TRUE(makeExposureField(scene, *ground, standing, settings, {backend, cancel, {}}, &memory).ok());
  for (const GatheredCover::Cells& cells : memory.gathered.grids) EXPECT_TRUE(cells.asked);
}

/// A sledge that crosses many cells a step keeps its own snow, leaves no trail of holes or heaps, and nothing
/// is lost. The run goes on alike from a saved state.
TEST_P(MovedModel, FasterThanACellAStepLosesNothing) {
  const SceneSnapshot scene = sledgeScene(9.0, GetParam());
  SnowRun run(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(run.run(5).ok());
  const Frame frame = run.frame();
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
  const std::size_t top = test::gridOf(cover, "sledge/0");
  const double open = 5.0 * 0.2;  // kg/m2 that fell
  EXPECT_NEAR(test::massOn(cover, top) / test::areaOf(cover, top), open, 0.1 * open);
  // Ground that it passed over in one step of five lost at most what that step brought.
  for (const TerrainGrid& terrain : makeSnowGround(scene)->terrain) {
    if (terrain.refinement > 0) continue;
    const Raster<float>& base = cover.layout->grids[terrain.grid].base;
    for (double k = 1.0; k <= 4.0; k += 0.5) {
      const int i = int(std::lround((20.0 + 9.0 * k) / 2.0)), j = int(std::lround((30.0 + 2.7 * k) / 2.0));
      const float swe = cover.values[terrain.grid].swe[base.index(i, j)];
      EXPECT_GT(swe, 0.6 * open) << k;
      EXPECT_LT(swe, 1.3 * open) << k;
    }
  }
  SnowRun half(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(half.run(3).ok());
  SnowRun loaded(scene, makeBvhRayScene, 3);
  ASSERT_TRUE(loaded.load(3, half.save()).ok());
  for (int f = 3; f < 5; ++f) ASSERT_TRUE(loaded.step().ok());
  EXPECT_EQ(loaded.save(), run.save());
}

}  // namespace
}  // namespace spin
