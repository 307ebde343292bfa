// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/snow/model_parts.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::boxMesh;
using test::modelOf;
using test::sheetMesh;
using test::TestScene;

Frame framesOf(const SceneSnapshot& scene, int frames) {
  SnowRun run(scene, makeBvhRayScene, 2);
  EXPECT_TRUE(run.run(frames).ok());
  return run.frame();
}

double flat(double, double) {
  return 0.0;
}

TEST(ModelCover, RoofOfABoxCatchesWhatFallsOnItAndSheltersTheGround) {
  TestScene test;
  ModelNode placed;
  placed.position = {20, 20, 0};
  const SceneSnapshot scene =
      test.land(21, 21, 2.0, flat).model("box", modelOf(boxMesh({-2, -3, 0}, {2, 3, 5})), placed).build();
  const Frame frame = framesOf(scene, 1);
  const CoverPart& cover = test::coverOf(frame);
  const std::size_t roof = test::gridOf(cover, "box/0");
  EXPECT_NEAR(test::areaOf(cover, roof), 24.0, 1e-4);
  EXPECT_NEAR(test::massOn(cover, roof), 24.0 * 0.2, 1e-4);
  EXPECT_NEAR(frame.info.budget.get("deposited"), 0.2 * 40 * 40, 0.2 * 1.5) << "roof and ground together";
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
  EXPECT_LT(std::abs(frame.info.budget.get("sampling_residual") / frame.info.budget.get("emitted")), 0.005);
  // Only the top faces up: one patch, at the roof's height.
  std::size_t patches = 0;
  for (const CoverGrid& grid : cover.layout->grids) patches += grid.node == "box" ? 1 : 0;
  EXPECT_EQ(patches, 1u);
  for (const float z : cover.layout->grids[roof].base.values)
    EXPECT_TRUE(std::isnan(z) || std::abs(z - 5.0f) < 1e-5f);
}

TEST(ModelCover, TerrainAndFineGridsShareTheAreaExactly) {
  TestScene test;
  ModelNode a, b;
  a.position = {13.2, 17.9, 0};
  b.position = {40, 22, 0};
  const SceneSnapshot scene =
      test.land(30, 20, 2.0,
                [](double x, double y) {
                  return std::hypot(x - 16, y - 24) < 3 ? double(test::kHole) : 0.1 * x;
                })
          .model("a", modelOf(boxMesh({-1, -1, 0}, {1, 1, 2})), a)
          .model("b", modelOf(boxMesh({-1, -1, 0}, {1, 1, 2})), b)
          .build();
  const SnowGroundPointer ground = makeSnowGround(scene);
  double cover = 0.0, surface = 0.0;
  std::size_t fine = 0;
  for (const TerrainGrid& grid : ground->terrain) {
    fine += grid.refinement > 0 ? 1 : 0;
    for (const float v : ground->layout->grids[grid.grid].area.values) cover += static_cast<double>(v);
  }
  const TerrainSurface land(scene.terrain->heights);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 30; ++i) surface += land.cellArea(i, j);
  EXPECT_EQ(fine, 2u);
  EXPECT_NEAR(cover, surface, 1e-6 * surface);
}

TEST(ModelCover, NeighboursShareOneFineGrid) {
  TestScene test;
  ModelNode a, b;
  a.position = {20, 20, 0};
  b.position = {28, 22, 0};
  const auto box = modelOf(boxMesh({-1, -1, 0}, {1, 1, 2}));
  const SceneSnapshot scene = test.land(30, 20, 2.0, flat).model("a", box, a).model("b", box, b).build();
  EXPECT_EQ(makeSnowGround(scene)->terrain.size(), 2u);
}

TEST(ModelCover, PatchAreasAddUpForATurnedAndTiltedRoof) {
  TestScene test;
  ModelNode placed;
  placed.rotationDegrees = {20, 0, 37};
  placed.scale = {1.5, 0.7, 1.0};
  placed.coverCell = 0.23;
  const auto sheet = modelOf(sheetMesh({0, 0, 3}, {4, 0, 3}, {0, 5, 3}));
  const SceneSnapshot scene = test.model("roof", sheet, placed).build();
  const SnowGroundPointer ground = makeSnowGround(scene);
  ASSERT_EQ(ground->layout->grids.size(), 1u);
  double area = 0.0;
  for (const float v : ground->layout->grids[0].area.values) area += static_cast<double>(v);
  EXPECT_NEAR(area, 4 * 1.5 * 5 * 0.7 * std::cos(degreesToRadians(20)), 1e-4);
}

TEST(ModelCover, SheetsCountWithEitherWindingAndBoxesOnlyOutside) {
  const auto trianglesOf = [](const Mesh& mesh) { return placedTriangles(*modelOf(mesh), Transform{}); };
  Mesh sheet = sheetMesh({0, 0, 0}, {0, 1, 0}, {1, 0, 0});  // wound downwards
  EXPECT_EQ(upFacingParts(trianglesOf(sheet), 0.5).size(), 1u);
  Mesh box = boxMesh({0, 0, 0}, {2, 2, 2});
  ASSERT_EQ(upFacingParts(trianglesOf(box), 0.5).size(), 1u);
  EXPECT_NEAR(upFacingParts(trianglesOf(box), 0.5)[0].planArea, 4.0, 1e-9);
  for (std::size_t k = 0; k < box.indices.size(); k += 3) std::swap(box.indices[k], box.indices[k + 1]);
  const auto inverted = upFacingParts(trianglesOf(box), 0.5);
  ASSERT_EQ(inverted.size(), 1u) << "a box turned inside out still has one top";
  EXPECT_NEAR(trianglesOf(box)[inverted[0].triangles[0]].corners[0].z, 2.0f, 1e-6f);
}

TEST(ModelCover, WindingsOfSingleFacesDoNotMatter) {
  const Mesh box = boxMesh({-2, -3, 0}, {2, 3, 5});
  // Each pair of triangles (a face of the box) turned inside out in its turn.
  for (std::size_t face = 0; face + 6 <= box.indices.size(); face += 6) {
    Mesh mixed = box;
    std::swap(mixed.indices[face], mixed.indices[face + 1]);
    std::swap(mixed.indices[face + 3], mixed.indices[face + 4]);
    const auto triangles = placedTriangles(*modelOf(mixed), Transform{});
    const ModelSurface surface = modelSurface(triangles, 0.5);
    ASSERT_EQ(surface.parts.size(), 1u) << face;
    EXPECT_NEAR(surface.parts[0].planArea, 24.0, 1e-6);
    EXPECT_NEAR(triangles[surface.parts[0].triangles[0]].corners[0].z, 5.0f, 1e-6f)
        << "the roof, not the floor";
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Vec3d outward = triangles[t].normal() * double(surface.outward[t]);
      const Vec3d middle =
          (triangles[t].corners[0] + triangles[t].corners[1] + triangles[t].corners[2]).to<double>() / 3.0;
      EXPECT_GT(dot(outward, middle - Vec3d{0, 0, 2.5}), 0.0) << t;
    }
  }
}

TEST(ModelCover, TwoSidedSheetsCountOnce) {
  Mesh card = sheetMesh({0, 0, 1}, {3, 0, 1}, {0, 3, 1});
  const std::size_t n = card.indices.size();
  for (std::size_t k = 0; k < n; k += 3) {
    card.indices.push_back(card.indices[k + 1]);
    card.indices.push_back(card.indices[k]);
    card.indices.push_back(card.indices[k + 2]);
  }
  TestScene test;
  const Frame frame =
      framesOf(test.land(21, 21, 2.0, flat).model("card", modelOf(card), ModelNode{}).build(), 1);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_NEAR(test::areaOf(cover, test::gridOf(cover, "card/0")), 9.0, 1e-4);
  EXPECT_NEAR(test::massOn(cover, test::gridOf(cover, "card/0")), 9.0 * 0.2, 1e-4);
  EXPECT_LT(std::abs(frame.info.figures.at("residual_models_share")), 1e-3);
}

/// Double-walled roofs and thin plates far from the scene's middle: the lower layer gets nothing, nothing is
/// shed twice.
TEST(ModelCover, ThinLayersShelterWhatIsBelowThem) {
  for (const float gap : {0.002f, 0.003f, 0.02f}) {
    Mesh roof = sheetMesh({0, 0, 2}, {5, 0, 2}, {0, 5, 2});
    const Mesh lower = sheetMesh({0, 0, 2.0f - gap}, {5, 0, 2.0f - gap}, {0, 5, 2.0f - gap});
    for (const std::uint32_t i : lower.indices) roof.indices.push_back(i + 4);
    roof.positions.insert(roof.positions.end(), lower.positions.begin(), lower.positions.end());
    TestScene test;
    ModelNode placed, plate;
    placed.position = {2500, 2480, 0};
    plate.position = {60, 2500, 3};
    const SceneSnapshot scene = test.land(517, 517, 5.0, flat)
                                    .model("roof", modelOf(roof), placed)
                                    .model("plate", modelOf(boxMesh({-5, -5, 0}, {5, 5, gap})), plate)
                                    .build();
    const Frame frame = framesOf(scene, 1);
    const CoverPart& cover = test::coverOf(frame);
    double onRoof = 0.0;
    for (std::size_t g = 0; g < cover.layout->grids.size(); ++g)
      if (cover.layout->grids[g].node == "roof") onRoof += test::massOn(cover, g);
    EXPECT_NEAR(onRoof, 25 * 0.2, 0.01) << gap;
    EXPECT_NEAR(test::massOn(cover, test::gridOf(cover, "plate/0")), 100 * 0.2, 0.01) << gap;
    EXPECT_LT(frame.info.budget.get("shed"), 0.01) << gap;
  }
}

TEST(ModelCover, LevelRoofsHoldWhatLevelGroundHolds) {
  TestScene test;
  test.simulation.holdsBelowDegrees = test.simulation.shedsAboveDegrees = 0.0;
  const Frame frame = framesOf(test.land(21, 21, 2.0, flat)
                                   .model("box", modelOf(boxMesh({-2, -3, 0}, {2, 3, 5})), ModelNode{})
                                   .build(),
                               1);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_EQ(test::massOn(cover, test::gridOf(cover, "box/0")) > 0.0, test::massOn(cover, 0) > 0.0);
}

/// On a rough slope the fine cells near a model show no facets: neighbours differ little although the
/// triangles they lie on differ much; what lies there together stays, and the model's shelter too.
TEST(ModelCover, FineCellsShowNoFacetsOfTheGround) {
  const CounterRandom random{3, 1};
  const auto rough = [&](double x, double y) {
    const auto n = static_cast<std::uint64_t>(std::lround(x / 5) + 100 * std::lround(y / 5));
    return 0.65 * x + 1.2 * random.uniformDouble(n);
  };
  const auto run = [&](bool house) {
    TestScene test;
    test.weather.windSpeed = 2.0;
    test.simulation.holdsBelowDegrees = 25.0;
    test.simulation.shedsAboveDegrees = 60.0;
    test.simulation.exposureRays = 64;
    ModelNode placed;
    placed.position = {60, 60, 0};
    const float top = house ? 8.0f : 0.02f;
    return framesOf(test.land(24, 24, 5.0, rough)
                        .model("box", modelOf(boxMesh({-3, -3, 0}, {3, 3, top})), placed)
                        .build(),
                    1);
  };
  const auto fineOf = [](const Frame& frame) { return test::gridOf(test::coverOf(frame), "terrain/fine0"); };
  const Frame open = run(false);
  const CoverPart& cover = test::coverOf(open);
  const std::size_t g = fineOf(open);
  const Raster<float>& base = cover.layout->grids[g].base;
  double largest = 0.0, mean = 0.0;
  for (int j = 2; j + 2 < base.height; ++j)
    for (int i = 2; i + 3 < base.width; ++i) {
      const double a = double(cover.values[g].swe[base.index(i, j)]),
                   b = double(cover.values[g].swe[base.index(i + 1, j)]);
      mean += a;
      if (std::hypot(base.x(i) - 60, base.y(j) - 60) > 8.0) largest = std::max(largest, std::abs(a - b));
    }
  mean /= double((base.width - 5) * (base.height - 4));
  EXPECT_LT(largest, 0.35 * mean);
  EXPECT_LT(std::abs(open.info.budget.relativeImbalance()), 1e-6);
  EXPECT_LT(std::abs(open.info.budget.get("sampling_residual") / open.info.budget.get("emitted")), 0.005);
  const Frame sheltered = run(true);
  EXPECT_LT(test::massOn(test::coverOf(sheltered), fineOf(sheltered)), 0.995 * test::massOn(cover, g));
}

TEST(ModelCover, TheEstimateCountsFineGridsAndPatches) {
  TestScene test;
  ModelNode placed;
  placed.position = {60, 60, 0};
  const SceneSnapshot scene =
      test.land(24, 24, 5.0, flat).model("box", modelOf(boxMesh({-5, -5, 0}, {5, 5, 4})), placed).build();
  double state = 0.0, frame = 0.0;
  const Pipeline pipeline = Pipeline::compile(scene);
  for (const auto& process : pipeline.processes()) {
    if (std::string_view(process->id()) != "cover") continue;
    process->estimate(scene, state, frame);
  }
  SnowRun run(scene, makeBvhRayScene, 1);
  ASSERT_TRUE(run.run(1).ok());
  std::size_t values = 0;
  const Frame made = run.frame();
  for (const auto& grid : test::coverOf(made).values) values += grid.swe.size() + grid.depth.size();
  EXPECT_NEAR(frame, static_cast<double>(values) * 1.5 * sizeof(float), 1.0) << "depth, water and exposure";
  const auto saved = static_cast<double>(run.save().size());
  EXPECT_GT(state, saved);
  EXPECT_LT(state, saved + 200.0 * static_cast<double>(values / 2));
}

TEST(ModelCover, StackedShelvesHaveSeparatePatchesAndTheLowerStaysBare) {
  Mesh shelves = sheetMesh({0, 0, 1}, {3, 0, 1}, {0, 3, 1});
  const Mesh upper = sheetMesh({0, 0, 2}, {3, 0, 2}, {0, 3, 2});
  for (const std::uint32_t i : upper.indices) shelves.indices.push_back(i + 4);
  shelves.positions.insert(shelves.positions.end(), upper.positions.begin(), upper.positions.end());
  TestScene test;
  const Frame frame = framesOf(test.model("shelf", modelOf(shelves), ModelNode{}).build(), 1);
  const CoverPart& cover = test::coverOf(frame);
  ASSERT_EQ(cover.layout->grids.size(), 2u);
  for (std::size_t g = 0; g < 2; ++g) {
    const bool top = cover.layout->grids[g].base.values[0] > 1.5f;
    EXPECT_NEAR(test::massOn(cover, g), top ? 9 * 0.2 : 0.0, 1e-4);
  }
}

TEST(ModelCover, WithoutTerrainTheAccountsCloseToo) {
  TestScene test;
  test.weather.windSpeed = 1.5;
  test.snowfall.fallSpreadDegrees = 15.0;
  test.simulation.exposureRays = 64;
  const Frame frame =
      framesOf(test.model("box", modelOf(boxMesh({-2, -3, 0}, {2, 3, 5})), ModelNode{}).build(), 2);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
  EXPECT_LT(std::abs(frame.info.budget.get("sampling_residual") / frame.info.budget.get("emitted")), 0.005);
  EXPECT_LT(std::abs(frame.info.figures.at("residual_models_share")), 0.005);
  // An open level roof gets the rate; the windward wall sheds what hits it.
  EXPECT_NEAR(frame.info.budget.get("deposited"), 0.4 * 24, 1e-3);
  EXPECT_GT(frame.info.budget.get("shed"), 1.0);
}

TEST(ModelCover, WallShedsTheClosedFormUnderSlantingSnow) {
  // One fall direction: flux through a vertical wall that faces the wind is rate x wind/fall speed x area.
  TestScene test;
  test.weather.windSpeed = 1.0;
  test.weather.windFromDegrees = 270.0;
  const auto wall = modelOf(sheetMesh({0, 0, 0}, {0, 4, 0}, {0, 0, 3}));
  const Frame frame = framesOf(test.model("wall", wall, ModelNode{}).build(), 1);
  const double speed = makeSizeSpectrum(kUnrimedDendriteAggregate, 0.002).meanFallSpeed;
  const double drift = 0.002 * std::round(1.0 / speed / 0.002);
  EXPECT_NEAR(frame.info.budget.get("shed"), 0.2 * drift * 12.0, 1e-3);
}

TEST(ModelCover, ModelThatCatchesNothingOnlyShelters) {
  TestScene test;
  ModelNode placed;
  placed.position = {10, 10, 0};
  placed.catchesSnow = false;
  const SceneSnapshot scene =
      test.land(11, 11, 2.0, flat).model("box", modelOf(boxMesh({-2, -2, 1}, {2, 2, 3})), placed).build();
  const Frame frame = framesOf(scene, 1);
  for (const CoverGrid& grid : test::coverOf(frame).layout->grids) EXPECT_EQ(grid.node, "terrain");
  EXPECT_NEAR(frame.info.budget.get("shed"), 16 * 0.2, 0.05);
  EXPECT_NEAR(frame.info.budget.get("deposited"), (400 - 16) * 0.2, 0.05);
}

TEST(ModelCover, PatchTravelsWithAMovingModelAndItsShelterMoves) {
  TestScene test;
  ModelNode placed;
  placed.position = {10, 10, 0};
  SceneSnapshot scene =
      test.land(21, 11, 2.0, flat).model("car", modelOf(boxMesh({-1, -1, 0.5}, {1, 1, 2})), placed).build();
  for (SceneNode& n : scene.nodes) {
    if (n.id != "car") continue;
    n.curves["position_m"].setKey({0.0, Vec3d{10, 10, 0}, Interpolation::Step});
    n.curves["position_m"].setKey({1.0 / 24, Vec3d{30, 10, 0}, Interpolation::Step});
  }
  SnowRun run(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(run.run(1).ok());
  const Frame first = run.frame();
  ASSERT_TRUE(run.step().ok());
  const Frame second = run.frame();
  const CoverPart &a = test::coverOf(first), &b = test::coverOf(second);
  EXPECT_EQ(a.layout, b.layout) << "the layout is shared while nothing about it changes";
  const std::size_t roof = test::gridOf(b, "car/0");
  EXPECT_NEAR(test::massOn(b, roof), 4 * 0.4, 1e-3);
  // The ground under the first place: sheltered in the first step, open in the second.
  const std::size_t fine = test::gridOf(b, "terrain/fine0");
  const Raster<float>& base = b.layout->grids[fine].base;
  const std::size_t under = base.index(base.column(10.1), base.row(10.1));
  EXPECT_EQ(a.values[fine].swe[under], 0.0f);
  EXPECT_NEAR(b.values[fine].swe[under], 0.2f, 1e-5f);
  EXPECT_LT(std::abs(second.info.budget.relativeImbalance()), 1e-6);
  EXPECT_LT(std::abs(second.info.budget.get("sampling_residual") / second.info.budget.get("emitted")), 0.005);
}

TEST(ModelCover, ModelThatTurnsKeepsNoSnow) {
  TestScene test;
  SceneSnapshot scene =
      test.model("sign", modelOf(sheetMesh({0, 0, 3}, {4, 0, 3}, {0, 5, 3})), ModelNode{}).build();
  for (SceneNode& n : scene.nodes)
    if (n.id == "sign") n.curves["rotation_deg"].setKey({0.0, Vec3d{}, Interpolation::Linear});
  EXPECT_EQ(test::coverOf(framesOf(scene, 1)).layout->grids.size(), 1u) << "one key turns nothing";
  for (SceneNode& n : scene.nodes)
    if (n.id == "sign") n.curves["rotation_deg"].setKey({50.0, Vec3d{0, 0, 90}, Interpolation::Step});
  const Frame frame = framesOf(scene, 1);
  EXPECT_TRUE(test::coverOf(frame).layout->grids.empty());
  EXPECT_NEAR(frame.info.budget.get("shed"), 0.2 * 20, 0.02);
}

TEST(ModelCover, ALaterTurnChangesTheKeysAsItChangesTheFrames) {
  TestScene test;
  const SceneSnapshot still =
      test.model("sign", modelOf(sheetMesh({0, 0, 3}, {4, 0, 3}, {0, 5, 3})), ModelNode{}).build();
  SceneSnapshot turning = still;
  for (SceneNode& n : turning.nodes) {
    if (n.id != "sign") continue;
    n.curves["rotation_deg"].setKey({0.0, Vec3d{}, Interpolation::Step});
    n.curves["rotation_deg"].setKey({50.0, Vec3d{0, 0, 90}, Interpolation::Step});
  }
  const auto keyOf = [](const SceneSnapshot& scene) {
    return frameKeys(scene, Pipeline::compile(scene), "cpu", 0)[0];
  };
  ASSERT_NE(test::coverOf(framesOf(still, 0)).layout->grids.size(),
            test::coverOf(framesOf(turning, 0)).layout->grids.size());
  EXPECT_NE(keyOf(still), keyOf(turning));
}

TEST(ModelCover, SlopesThatHoldSnowHoldItOnModelsToo) {
  // The holding angle above the shedding one: all that is below it is held, on terrain and models alike.
  TestScene test;
  test.simulation.holdsBelowDegrees = 80.0;
  test.simulation.shedsAboveDegrees = 30.0;
  const SceneSnapshot scene =
      test.model("roof", modelOf(sheetMesh({0, 0, 3}, {4, 0, 7}, {0, 5, 3})), ModelNode{}).build();
  EXPECT_EQ(test::coverOf(framesOf(scene, 0)).layout->grids.size(), 1u);
}

TEST(ModelCover, AnEnormousModelStaysWithinTheCapOfCells) {
  TestScene test;
  ModelNode placed;
  placed.scale = {1e3, 1e3, 1};
  placed.coverCell = 0.02;
  const float far = 5e5f;
  const SceneSnapshot scene =
      test.model("plain", modelOf(sheetMesh({0, 0, 0}, {far, 0, 0}, {0, far, 0})), placed).build();
  const SnowGroundPointer ground = makeSnowGround(scene);
  ASSERT_EQ(ground->layout->grids.size(), 1u);
  EXPECT_LE(static_cast<double>(ground->layout->grids[0].base.size()), kMostPatchCells);
}

TEST(ModelCover, TinyPartsAreShedAndNothingIsLost) {
  Mesh leaves;
  for (int k = 0; k < 200; ++k) {
    const float x = 0.3f * static_cast<float>(k % 20), y = 0.3f * static_cast<float>(k / 20);
    const Mesh leaf = sheetMesh({x, y, 2}, {x + 0.1f, y, 2}, {x, y + 0.1f, 2});
    const auto first = static_cast<std::uint32_t>(leaves.positions.size());
    leaves.positions.insert(leaves.positions.end(), leaf.positions.begin(), leaf.positions.end());
    for (const std::uint32_t i : leaf.indices) leaves.indices.push_back(first + i);
  }
  TestScene test;
  const Frame frame = framesOf(test.model("bush", modelOf(leaves), ModelNode{}).build(), 1);
  EXPECT_TRUE(test::coverOf(frame).layout->grids.empty());
  EXPECT_NEAR(frame.info.budget.get("shed"), 0.2 * 2.0, 0.01);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
}

}  // namespace
}  // namespace spin
