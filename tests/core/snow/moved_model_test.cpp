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
SceneSnapshot sledgeScene(double speed, bool maps, double wind = 0.6) {
  TestScene test;
  test.snowfall.fallSpreadDegrees = 12.0;
  test.weather.windSpeed = wind;
  test.simulation.exposureNoise = 0.2;
  test.simulation.exposureMethod = maps ? ExposureMethod::Maps : ExposureMethod::Rays;
  test.simulation.exposureMapSize = 256;
  test.terrain.coverDetailCell = 0.5;
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

bool same(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

void expectTheBitsOfAskingAll(bool maps, double wind) {
  const SceneSnapshot scene = sledgeScene(3.0, maps, wind);
  const SnowGroundPointer ground = makeSnowGround(scene);
  CpuBackend backend(2);
  const CancelToken cancel;
  const Workshop workshop{backend, cancel, {}};
  SnowSceneMaker scenes(makeBvhRayScene);
  GatheredCover kept;
  std::vector<StandingModel> models;
  std::size_t changed = 0;
  for (const double time : {0.0, 2.0 / 24.0, 7.0 / 24.0}) {
    const ExposureSettings settings = exposureSettings(scene, time);
    const SnowScene standing = *scenes.at(scene, *ground, time);
    const SnowScene afresh = *makeSnowScene(scene, *ground, time, makeBvhRayScene);
    const SkyChange change =
        models.empty() ? SkyChange::everywhere() : SkyChange(settings.cone, models, standing.models);
    const GatheredCover before = kept;
    GatheredCover all;
    ASSERT_TRUE(gatherCover(scene, *ground, afresh, settings, SkyChange::everywhere(), workshop, all).ok());
    ASSERT_TRUE(gatherCover(scene, *ground, standing, settings, change, workshop, kept).ok());
    for (std::size_t g = 0; g < all.grids.size(); ++g) {
      const GatheredCover::Cells &a = all.grids[g], &b = kept.grids[g];
      ASSERT_TRUE(same(a.exposure, b.exposure) && same(a.held, b.held) && same(a.shed, b.shed) &&
                  same(a.halves, b.halves))
          << time << " " << g;
      for (std::size_t c = 0; !models.empty() && c < b.exposure.size(); ++c)
        changed += before.grids[g].exposure[c] != b.exposure[c] ? 1 : 0;
    }
    const auto roof = std::find_if(ground->layout->grids.begin(), ground->layout->grids.end(),
                                   [](const CoverGrid& grid) { return grid.node == "hut"; });
    ASSERT_NE(roof, ground->layout->grids.end());
    if (!models.empty() && wind < 1.0) {
      EXPECT_FALSE(kept.grids[std::size_t(roof - ground->layout->grids.begin())].asked)
          << "the sledge does not pass the hut";
    }
    models = standing.models;
  }
  EXPECT_GT(changed, 10u) << "its shadow went along";
}

TEST_P(MovedModel, AskingOnlyWhatSeesItGivesTheSameBits) {
  expectTheBitsOfAskingAll(GetParam(), 0.6);
}

/// Maps compare with texels beside and below a point: what is just downwind of it counts too.
TEST_P(MovedModel, SoItDoesInStrongWind) {
  expectTheBitsOfAskingAll(GetParam(), 7.0);
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
/// is lost. The run goes on alike from a saved state, and can publish it without a step, as a pause does.
TEST_P(MovedModel, FasterThanACellAStepLosesNothing) {
  const SceneSnapshot scene = sledgeScene(9.0, GetParam());
  SnowRun run(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(run.run(2).ok());
  SnowRun loaded(scene, makeBvhRayScene, 3);
  ASSERT_TRUE(loaded.load(2, run.save()).ok());
  const Frame saved = run.frame(), again = loaded.frame();
  EXPECT_EQ(saved.info.figures, again.info.figures);
  ASSERT_TRUE(test::coverOf(again).exposure);
  for (std::size_t g = 0; g < test::coverOf(saved).values.size(); ++g) {
    EXPECT_EQ(test::coverOf(saved).exposure->grids[g], test::coverOf(again).exposure->grids[g]);
    EXPECT_EQ(test::coverOf(saved).values[g].swe, test::coverOf(again).values[g].swe);
  }
  ASSERT_TRUE(run.step().ok() && loaded.step().ok());
  EXPECT_EQ(loaded.save(), run.save());

  const Frame frame = run.frame();
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
  const std::size_t top = test::gridOf(cover, "sledge/0");
  const double open = 3.0 * 0.2;  // kg/m2 that fell
  EXPECT_NEAR(test::massOn(cover, top) / test::areaOf(cover, top), open, 0.1 * open);
  // Ground that it passed over in one step of three lost at most what that step brought.
  const SnowGroundPointer ground = makeSnowGround(scene);
  for (const TerrainGrid& terrain : ground->terrain) {
    if (terrain.refinement > 0) continue;
    const Raster<float>& base = cover.layout->grids[terrain.grid].base;
    for (double k = 1.0; k <= 2.5; k += 0.5) {
      const int i = int(std::lround((20.0 + 9.0 * k) / 2.0)), j = int(std::lround((30.0 + 2.7 * k) / 2.0));
      const float swe = cover.values[terrain.grid].swe[base.index(i, j)];
      EXPECT_GT(swe, 0.55 * open) << k;
      EXPECT_LT(swe, 1.3 * open) << k;
    }
  }
}

}  // namespace
}  // namespace spin
