// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/cover_graph.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/snow/snow_slides.h"
#include "core/snow/snow_smoothing.h"
#include "tests/core/snow/cover_land.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

struct Made {
  SnowGroundPointer ground;
  CoverGraph graph;
};

Made madeOf(const SceneSnapshot& scene) {
  Made made{makeSnowGround(scene), {}};
  const auto standing = makeSnowScene(scene, *made.ground, 0.0, makeBvhRayScene);
  made.graph = makeCoverGraph(*made.ground, &*standing);
  return made;
}

std::size_t gridNamed(const Made& made, const std::string& id) {
  const auto& grids = made.ground->layout->grids;
  for (std::size_t g = 0; g < grids.size(); ++g)
    if (grids[g].id == id) return g;
  ADD_FAILURE() << "no grid " << id;
  return 0;
}

double flat(double, double) {
  return 0.0;
}

/// A box of 4 x 4 m, 3 m high, on level ground of 60 x 60 m.
TestScene hutOnPlain() {
  TestScene scene;
  scene.land(13, 13, 5.0, flat);
  scene.terrain.coverDetailCell = 0.5;
  scene.terrain.coverDetailMargin = 4.0;
  ModelNode hut;
  hut.position = {30.0, 30.0, 0.0};
  hut.coverCell = 0.5;
  scene.model("hut", test::modelOf(test::boxMesh({-2, -2, 0}, {2, 2, 3})), hut);
  return scene;
}

TEST(CoverGraph, SeamsJoinFineAndCoarseCellsBothWays) {
  const Made made = madeOf(hutOnPlain().build());
  const CoverGraph& graph = made.graph;
  const CoverGraph::Grid& coarse = graph.grids()[gridNamed(made, "terrain")];
  const CoverGraph::Grid& fine = graph.grids()[gridNamed(made, "terrain/fine0")];
  const auto isIn = [](const CoverGraph::Grid& grid, std::uint32_t c) {
    return c >= grid.first && c < grid.first + static_cast<std::uint32_t>(grid.width * grid.height);
  };
  double border = 0.0, back = 0.0;
  for (std::uint32_t c = 0; c < graph.size(); ++c)
    for (const CoverLink& link : graph.links(c)) {
      if (!link.leads() || link.falls) continue;
      EXPECT_TRUE(graph.area(c) > 0.0f && graph.area(link.target) > 0.0f);
      EXPECT_GT(link.distance, 0.0f);
      EXPECT_LT(link.distance, 4.0f);
      if (isIn(fine, c) && isIn(coarse, link.target)) border += static_cast<double>(link.width);
      if (isIn(coarse, c) && isIn(fine, link.target)) back += static_cast<double>(link.width);
    }
  EXPECT_NEAR(border, 2.0 * (fine.width + fine.height) * fine.cellSize, 1e-6);
  EXPECT_NEAR(back, border, 1e-6);
  // The area of all terrain cells is that of the terrain.
  double area = 0.0;
  for (std::uint32_t c = 0; c < graph.size(); ++c)
    if (isIn(fine, c) || isIn(coarse, c)) area += static_cast<double>(graph.area(c));
  EXPECT_NEAR(area, 3600.0, 1e-3);
}

TEST(CoverGraph, RimsOfARoofLeadToTheGroundBelow) {
  const Made made = madeOf(hutOnPlain().build());
  const CoverGraph::Grid& roof = made.graph.grids()[gridNamed(made, "hut/0")];
  EXPECT_TRUE(roof.onModel);
  int rims = 0;
  for (std::uint32_t c = roof.first; c < roof.first + static_cast<std::uint32_t>(roof.width * roof.height);
       ++c)
    for (const CoverLink& link : made.graph.links(c)) {
      ++rims;
      EXPECT_TRUE(link.falls && link.leads());
      EXPECT_FLOAT_EQ(link.sill, 3.0f);
      EXPECT_FLOAT_EQ(made.graph.bed(link.target), 0.0f);
      EXPECT_EQ(made.graph.gridOf(link.target), gridNamed(made, "terrain/fine0"));
    }
  EXPECT_EQ(rims, 4 * 8);
}

TEST(CoverGraph, RimsLeadOverOverhangsToLowerRoofsAndNotThroughWalls) {
  TestScene scene = hutOnPlain();
  // A balcony below one eave, a tower wall at the opposite side, a sheet in the air beyond a third.
  ModelNode at;
  at.position = {30.0, 30.0, 0.0};
  at.coverCell = 0.5;
  scene.model("balcony", test::modelOf(test::boxMesh({2.05f, -2, 1}, {3.5f, 2, 1.2f})), at);
  scene.model("tower", test::modelOf(test::boxMesh({-3.5f, -2, 0}, {-2.05f, 2, 9})), at);
  const Made made = madeOf(scene.build());
  const CoverGraph::Grid& roof = made.graph.grids()[gridNamed(made, "hut/0")];
  const std::size_t balcony = gridNamed(made, "balcony/0");
  int onBalcony = 0, towardsTower = 0;
  for (std::uint32_t c = roof.first; c < roof.first + static_cast<std::uint32_t>(roof.width * roof.height);
       ++c)
    for (const CoverLink& link : made.graph.links(c)) {
      if (link.side == 0) onBalcony += made.graph.gridOf(link.target) == balcony;
      towardsTower += link.side == 4;
    }
  EXPECT_EQ(onBalcony, 8);
  EXPECT_EQ(towardsTower, 0);
}

TEST(CoverGraph, WithoutTerrainRimsLeadIntoNothing) {
  TestScene scene;
  ModelNode hut;
  scene.model("hut", test::modelOf(test::boxMesh({-2, -2, 0}, {2, 2, 3})), hut);
  const Made made = madeOf(scene.build());
  ASSERT_GT(made.graph.linkCount(), 0u);
  for (std::uint32_t c = 0; c < made.graph.size(); ++c)
    for (const CoverLink& link : made.graph.links(c)) EXPECT_EQ(link.target, CoverLink::kFalls);
}

TEST(CoverGraph, HolesAndSinglePointsHaveBordersOnly) {
  const auto land = [](double x, double y) {
    return x > 2.5 && x < 5.5 && y > 2.5 && y < 5.5 ? std::nan("") : 0.1 * x;
  };
  const auto graph = test::landGraph(9, 9, 1.0, land);
  double border = 0.0;
  for (std::uint32_t c = 0; c < graph->size(); ++c)
    for (const CoverLink& link : graph->links(c)) {
      EXPECT_EQ(link.target, CoverLink::kBeyond);
      border += static_cast<double>(link.width);
    }
  EXPECT_NEAR(border, 4 * 9 + 4 * 3, 1e-9);
  EXPECT_EQ(graph->neighbours(4 * 9 + 4), 0);
  EXPECT_EQ(graph->neighbours(4 * 9 + 2) & 1u, 0u);
  TestScene point;
  point.land(1, 1, 5.0, flat);
  const Made made = madeOf(point.build());
  EXPECT_EQ(made.graph.size(), 1u);
  EXPECT_EQ(made.graph.area(0), 0.0f);
}

TEST(CoverGraph, MemoryStaysSmall) {
  const auto graph = test::landGraph(400, 400, 1.0, flat);
  EXPECT_LT(graph->memoryBytes(), 12 * graph->size());
}

TEST(CoverGraph, SnowSlidesOffASteepRoofOntoTheGroundBeside) {
  TestScene scene;
  scene.land(13, 13, 5.0, flat);
  scene.terrain.coverDetailCell = 0.5;
  ModelNode house;
  house.position = {30.0, 30.0, 0.0};
  Mesh gable;  // 51 degrees, eaves 3 m up
  gable.positions = {{-4, -5, 3}, {0, -5, 8}, {0, 5, 8}, {-4, 5, 3}, {4, -5, 3}, {4, 5, 3}};
  gable.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
  scene.model("house", test::modelOf(gable), house);
  const Made made = madeOf(scene.build());
  const auto graph = std::make_shared<const CoverGraph>(made.graph);
  std::vector<double> depth(graph->size(), 0.0), swe = depth;
  const CoverGraph::Grid& roof = graph->grids()[gridNamed(made, "house/0")];
  double onRoof = 0.0;
  const auto roofCells = static_cast<std::uint32_t>(roof.width * roof.height);
  for (std::uint32_t c = roof.first; c < roof.first + roofCells; ++c) {
    if (!(graph->area(c) > 0.0f)) continue;
    depth[c] = 0.4, swe[c] = 40.0;
    onRoof += 40.0 * static_cast<double>(graph->area(c));
  }
  SnowSlides slides(graph);
  CpuBackend backend(2);
  const std::vector<float> tangents(graph->size(), static_cast<float>(std::tan(degreesToRadians(38.0))));
  const SlideTotals totals = slides.settle({depth.data(), swe.data()}, tangents.data(), {}, backend);
  EXPECT_EQ(totals.unsettled, 0u);
  EXPECT_NEAR(totals.shed[1], onRoof, 0.02 * onRoof);
  EXPECT_EQ(totals.left[1], 0.0);
  EXPECT_NEAR(test::sumOver(*graph, swe), onRoof, 1e-9 * onRoof);
}

TEST(CoverGraph, SnowSlidesOverSeamsWithoutLoss) {
  // A slope of 45 degrees through the fine grid.
  TestScene scene = hutOnPlain();
  scene.land(25, 25, 5.0, [](double x, double) { return std::max(0.0, x - 20.0); });
  const Made made = madeOf(scene.build());
  const auto graph = std::make_shared<const CoverGraph>(made.graph);
  std::vector<double> depth(graph->size(), 0.0);
  for (std::uint32_t c = 0; c < graph->size(); ++c)
    if (graph->area(c) > 0.0f) depth[c] = 0.3;
  const double before = test::sumOver(*graph, depth);
  SnowSlides slides(graph);
  CpuBackend backend(2);
  const std::vector<float> tangents(graph->size(), static_cast<float>(std::tan(degreesToRadians(38.0))));
  const SlideTotals totals = slides.settle({depth.data()}, tangents.data(), {}, backend);
  EXPECT_EQ(totals.unsettled, 0u);
  EXPECT_NEAR(test::sumOver(*graph, depth) + totals.left[0], before, 1e-9 * before);
  const CoverGraph::Grid& fine = graph->grids()[gridNamed(made, "terrain/fine0")];
  // What lies on the fine part of the slope has gone to its foot.
  const std::uint32_t upper =
      fine.first + static_cast<std::uint32_t>(fine.height / 2 * fine.width + fine.width - 2);
  EXPECT_LT(depth[upper], 1e-4);
}

TEST(SnowSmoothing, EvensOutBumpsAndKeepsTheSnow) {
  const auto graph = test::landGraph(64, 48, 0.5, flat);
  std::vector<double> depth(graph->size()), swe(graph->size());
  for (std::uint32_t c = 0; c < graph->size(); ++c) {
    depth[c] = 1.0 + 0.3 * std::sin(2.0 * kPi * (c % 64) / 8.0);
    swe[c] = 120.0 * depth[c];
  }
  const double before = test::sumOver(*graph, swe);
  std::vector<std::vector<double>> results;
  for (const int threads : {1, 4}) {
    std::vector<double> d = depth, w = swe;
    CpuBackend backend(threads);
    SmoothingSettings settings;
    settings.spread = 0.05;
    EXPECT_NEAR(smoothSnow(*graph, {d.data(), w.data()}, settings, backend), 0.05, 1e-12);
    EXPECT_NEAR(test::sumOver(*graph, w), before, 1e-12 * before);
    // One step of the explicit scheme: a wave of 8 cells of 0.5 m.
    const double gain = 1.0 - 0.05 * 2.0 * (1.0 - std::cos(2.0 * kPi / 8.0)) / 0.25;
    EXPECT_NEAR(d[24 * 64 + 34] - 1.0, 0.3 * gain, 1e-9);
    results.push_back(d);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(SnowSmoothing, FillsHollowsAndLeavesBareGroundBare) {
  const auto graph = test::landGraph(
      40, 40, 0.5, [](double x, double y) { return std::hypot(x - 10.0, y - 10.0) < 1.2 ? -0.3 : 0.0; });
  std::vector<double> depth(graph->size(), 0.5);
  for (std::uint32_t c = 0; c < graph->size(); ++c)
    if (c % 40 < 6) depth[c] = 0.0;
  const double before = test::sumOver(*graph, depth);
  CpuBackend backend(2);
  SmoothingSettings settings;
  settings.spread = 1.0;
  smoothSnow(*graph, {depth.data()}, settings, backend);
  EXPECT_NEAR(test::sumOver(*graph, depth), before, 1e-12 * before);
  EXPECT_GT(depth[20 * 40 + 20], 0.6);
  for (std::uint32_t c = 0; c < graph->size(); ++c) EXPECT_TRUE(c % 40 >= 6 || depth[c] == 0.0);
}

}  // namespace
}  // namespace spin
