// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/units.h"
#include "core/flow/flow_estimate.h"
#include "core/flow/flow_materials.h"
#include "core/flow/flow_reach.h"
#include "core/flow/flow_scene.h"
#include "core/flow/inflow.h"
#include "core/flow/scene_bodies.h"
#include "core/sph/flow_setup.h"
#include "tests/core/flow/flow_test_scene.h"

namespace spin {
namespace {

using test::FlowTestScene;

std::string issuesOf(const FlowScene& flow, bool fatal) {
  std::string text;
  for (const FlowIssue& issue : flow.issues)
    if (issue.fatal == fatal) text += issue.node + ": " + issue.text + "\n";
  return text;
}

FlowScene flowOf(FlowTestScene& scene) {
  static SceneSnapshot kept;
  kept = scene.build();
  return makeFlowScene(kept, 0.0);
}

TEST(FlowMaterials, EveryPresetIsValidAndHasASource) {
  for (int k = 0; k + 1 < kFlowMaterialKinds; ++k) {
    const FlowMaterialPreset preset = flowMaterialPreset(static_cast<FlowMaterialKind>(k));
    EXPECT_NE(*preset.source, '\0');
    FlowConfig config;
    config.domainMax = {1, 1, 1};
    config.materials = {preset.material};
    EXPECT_TRUE(checkFlowConfig(config).ok()) << k;
  }
  const Rheology snow = flowMaterialPreset(FlowMaterialKind::DrySnow).material.rheology;
  EXPECT_GT(snow.frictionTangent, 0.0f) << "snow is frictional";
  EXPECT_GT(flowMaterialPreset(FlowMaterialKind::WetSnow).material.rheology.cohesion, snow.cohesion);
  EXPECT_GT(flowMaterialPreset(FlowMaterialKind::WetSnow).material.tensileStrength, 0.0)
      << "wet snow coheres";
  const Rheology thinning = flowMaterialPreset(FlowMaterialKind::CrossThinning).material.rheology;
  EXPECT_GT(apparentViscosity(thinning, 0.001f, 0.0f), 90.0f);
  EXPECT_LT(apparentViscosity(thinning, 10.0f, 0.0f), 1.1f);
  const Rheology thickening = flowMaterialPreset(FlowMaterialKind::CrossThickening).material.rheology;
  EXPECT_GT(apparentViscosity(thickening, 10.0f, 0.0f), apparentViscosity(thickening, 0.001f, 0.0f));
}

TEST(FlowMaterials, CustomTakesWhatItsLawNeeds) {
  FlowMaterialNode node;
  node.law = FlowLaw::Newtonian;
  node.viscosity = 7.0;
  EXPECT_EQ(customFlowMaterial(node).rheology.law, RheologyLaw::Newtonian);
  node.law = FlowLaw::PowerLaw;
  node.exponent = 0.5;
  EXPECT_EQ(customFlowMaterial(node).rheology.cohesion, 0.0f) << "a power law has no yield stress";
  EXPECT_EQ(customFlowMaterial(node).rheology.exponent, 0.5f);
  node.law = FlowLaw::Bingham;
  EXPECT_EQ(customFlowMaterial(node).rheology.exponent, 1.0f);
  EXPECT_EQ(customFlowMaterial(node).rheology.cohesion, 100.0f);
  EXPECT_EQ(customFlowMaterial(node).rheology.frictionTangent, 0.0f);
  node.law = FlowLaw::Frictional;
  EXPECT_NEAR(customFlowMaterial(node).rheology.frictionTangent, 0.4663f, 1e-4f);
  node.law = FlowLaw::Cross;
  EXPECT_EQ(customFlowMaterial(node).rheology.law, RheologyLaw::Cross);
}

TEST(FlowMaterials, ThoseThatDifferInStrengthAloneAreTwo) {
  FlowTestScene scene;
  FlowMaterialNode weak, strong;
  strong.tensileStrength = 500.0;
  AvalancheReleaseNode left = test::squareRelease(2.0, 4.0, 0.5), right = test::squareRelease(5.0, 7.0, 0.5);
  left.material = right.material = FlowMaterialKind::Custom;
  left.customMaterial = "weak", right.customMaterial = "strong";
  test::slopeScene(scene).add(kFlowMaterialType, "weak", weak).add(kFlowMaterialType, "strong", strong);
  scene.add(kAvalancheReleaseType, "left", left).add(kAvalancheReleaseType, "right", right);
  const FlowScene flow = flowOf(scene);
  ASSERT_EQ(flow.config.materials.size(), 2u) << issuesOf(flow, true);
  EXPECT_EQ(flow.config.materials[flow.releases[0].material].tensileStrength, 0.0);
  EXPECT_EQ(flow.config.materials[flow.releases[1].material].tensileStrength, 500.0);
}

TEST(FlowBodies, KeysTurnThemTheShorterWay) {
  for (const double sign : {1.0, -1.0})
    for (int axis = 0; axis < 3; ++axis) {
      FlowTestScene scene;
      test::slopeScene(scene);
      test::addCube(scene, "wheel", 0.5f, {5.0, 5.0, 2.0}, RigidMotion::Kinematic);
      SceneSnapshot snapshot = scene.build();
      const Vec3d about = Vec3d{axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0} * sign;
      for (SceneNode& node : snapshot.nodes) {
        if (node.id != "wheel") continue;
        node.curves["rotation_deg"].setKey({0.0, Vec3d{}, Interpolation::Linear});
        node.curves["rotation_deg"].setKey({2.0, about * 720.0, Interpolation::Linear});
      }
      const FlowScene flow = makeFlowScene(snapshot, 0.0);
      ASSERT_EQ(flow.bodies.size(), 1u) << issuesOf(flow, true);
      for (int k = 0; k < 20; ++k) {
        const auto states =
            followKeys(snapshot, flow.bodies, std::vector<RigidState>(1), 0.1 * k, 0.1 * k + 0.1);
        EXPECT_LT(length(states[0].angularVelocity - about * (2.0 * kPi)), 1e-6)
            << axis << " " << sign << " " << k;
      }
    }
}

TEST(FlowReach, GoesDownAndAsFarUpAsTheEnergyAllows) {
  // A valley across x: down to x = 50, up again, with a wall of 3 m at x = 80.
  Raster<float> land(121, 11, 0.0, 0.0, 1.0);
  for (int j = 0; j < 11; ++j)
    for (int i = 0; i < 121; ++i)
      land.at(i, j) = static_cast<float>(i < 50 ? 25.0 - 0.5 * i : i < 80 ? 0.0 : 3.0 + 0.5 * (i - 80));
  const std::vector<FlowStart> starts{{0.0, 5.0, 26.0}};
  const FlowReach free = findReach(land, starts, 0.0), slow = findReach(land, starts, 0.45);
  EXPECT_NEAR(free.box.max.x, 125.0, 6.0) << "to the height where it began";
  EXPECT_NEAR(slow.box.max.x, 57.0, 2.0) << "where the energy line meets the ground";
  EXPECT_NEAR(free.speedHead, 26.0, 0.01);
  EXPECT_LT(slow.speedHead, 4.0);
  EXPECT_TRUE(findReach(land, {{0.0, 5.0, 20.0}}, 0.0).box.empty()) << "it begins below the ground";
}

TEST(FlowSceneIssues, AGoodSceneHasNone) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  const FlowScene flow = flowOf(scene);
  EXPECT_EQ(issuesOf(flow, true) + issuesOf(flow, false), "");
  EXPECT_TRUE(checkFlowConfig(flow.config).ok());
  EXPECT_EQ(flow.releases[0].layers, 5);
}

TEST(FlowSceneIssues, TwoReleasesInOnePlace) {
  const auto told = [](double from, double to, double time) {
    FlowTestScene scene;
    AvalancheReleaseNode second = test::squareRelease(from, to, 0.5);
    second.releaseTime = time;
    test::slopeScene(scene).add(kAvalancheReleaseType, "first", test::squareRelease(2.0, 4.0, 0.5));
    scene.add(kAvalancheReleaseType, "second", second);
    return issuesOf(flowOf(scene), false);
  };
  const std::string half = told(3.0, 5.0, 0.0);
  EXPECT_NE(half.find("second: 25 % of its area lies within that of \"first\""), std::string::npos) << half;
  EXPECT_EQ(told(4.5, 6.5, 0.0), "") << "beside each other";
  EXPECT_EQ(told(3.0, 5.0, 1.0), "") << "the first is gone when the second comes";
}

TEST(FlowSceneIssues, ReleaseOutsideTheTerrain) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(200.0, 210.0, 0.5));
  EXPECT_NE(issuesOf(flowOf(scene), true).find("release: no part of the release area lies on the terrain"),
            std::string::npos);
  FlowTestScene half;
  test::slopeScene(half).add(kAvalancheReleaseType, "release", test::squareRelease(-2.0, 2.0, 0.5));
  EXPECT_NE(issuesOf(flowOf(half), false).find("75 % of the area"), std::string::npos);
}

TEST(FlowSceneIssues, OutlineThatCrossesItself) {
  FlowTestScene scene;
  AvalancheReleaseNode release;
  release.outline = {{2, 2}, {4, 4}, {4, 2}, {2, 4}};
  test::slopeScene(scene).add(kAvalancheReleaseType, "bow", release);
  EXPECT_NE(issuesOf(flowOf(scene), true)
                .find("bow: the outline crosses itself: the edge from corner 1 meets "
                      "that from corner 3"),
            std::string::npos);
}

TEST(FlowSceneIssues, SpacingTooLargeForTheSlab) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "thin", test::squareRelease(2.0, 4.0, 0.1));
  EXPECT_NE(issuesOf(flowOf(scene), false).find("thin: the slab of 0.10 m is 1.0 spacings deep: 1 layer"),
            std::string::npos);
}

TEST(FlowSceneIssues, DomainTooLargeForTheSpacing) {
  FlowTestScene scene;
  scene.settings.spacing = 0.01;
  scene.settings.margin = 200.0;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  const std::string text = issuesOf(flowOf(scene), true);
  EXPECT_NE(text.find("flow_settings: the domain of"), std::string::npos) << text;
  EXPECT_NE(text.find("at most 4096 fit"), std::string::npos) << text;
}

TEST(FlowSceneIssues, StartsOutsideAGivenDomain) {
  FlowTestScene scene;
  scene.settings.domainMin = {8, 0, -1};
  scene.settings.domainMax = {16, 12, 6};
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  EXPECT_NE(issuesOf(flowOf(scene), true).find("release: flow begins outside"), std::string::npos);
}

TEST(FlowSceneIssues, MaterialsThatAreNotThereOrTooMany) {
  FlowTestScene scene;
  AvalancheReleaseNode release = test::squareRelease(2.0, 4.0, 0.5);
  release.material = FlowMaterialKind::Custom;
  release.customMaterial = "goo";
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", release);
  EXPECT_NE(issuesOf(flowOf(scene), true).find("custom_material is \"goo\""), std::string::npos);
  scene.add(kFlowMaterialType, "goo", FlowMaterialNode{});
  EXPECT_EQ(issuesOf(flowOf(scene), true), "");
  release.material = FlowMaterialKind::DrySnow;
  for (int k = 0; k < 4; ++k) {
    release.density = 200.0 + k;
    scene.add(kAvalancheReleaseType, "more" + std::to_string(k), release);
  }
  EXPECT_NE(issuesOf(flowOf(scene), true).find("more3: more than 4 different materials"), std::string::npos);
}

TEST(FlowSceneIssues, MoreParticlesThanTheMemoryHolds) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  const SceneSnapshot built = scene.build();
  const FlowEstimate need = estimateFlow(built);
  EXPECT_FALSE(memoryIssue(need, 1e9));
  const auto issue = memoryIssue(need, 1e5);
  ASSERT_TRUE(issue);
  EXPECT_TRUE(issue->fatal);
  EXPECT_EQ(issue->node, "flow_settings");
  EXPECT_TRUE(findFlowIssues(built).empty());
  // 90 m3 in particles of 5 mm.
  scene.settings.spacing = 0.005;
  scene.settings.domainMin = {1.5, 1.5, 2.0};
  scene.settings.domainMax = {5.0, 5.0, 25.0};
  scene.add(kAvalancheReleaseType, "deep", test::squareRelease(2.0, 4.0, 20.0));
  const SceneSnapshot huge = scene.build();
  EXPECT_GT(estimateFlow(huge).particles, 5e8);
  // That both slabs begin in one place is a warning.
  const std::vector<FlowIssue> issues = findFlowIssues(huge);
  const auto fatal =
      std::count_if(issues.begin(), issues.end(), [](const FlowIssue& found) { return found.fatal; });
  EXPECT_EQ(fatal, memoryIssue(estimateFlow(huge)) ? 1 : 0);
}

TEST(FlowSceneIssues, SourcesThatCannotFlow) {
  FlowTestScene scene;
  WaterSourceNode source;
  source.end = source.position;
  test::slopeScene(scene).add(kWaterSourceType, "source", source);
  EXPECT_NE(issuesOf(flowOf(scene), true).find("source: the line's ends stand on the same spot"),
            std::string::npos);
}

TEST(FlowSceneIssues, ABodyWithoutItsModel) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  RigidBodyNode body;
  body.model = "rock";
  scene.add(kRigidBodyType, "body", body);
  EXPECT_NE(issuesOf(flowOf(scene), true).find("body: model is \"rock\""), std::string::npos);
}

TEST(FlowWalls, GroundTypesGiveTheirFriction) {
  FlowTestScene scene;
  test::slopeScene(scene).add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 4.0, 0.5));
  GroundTypeLayerNode ground;
  ground.base = GroundType::Ice;
  scene.add(kGroundTypeLayerType, "ground", ground);
  TiledRaster<std::uint8_t> painted(33, 25, kUnpaintedGround);
  painted.set(20, 10, static_cast<std::uint8_t>(GroundType::Rock));
  scene.snapshot.nodes.back().painted = painted;
  scene.settings.rock = 0.77;
  scene.settings.turbulence = 2000.0;
  const FlowScene flow = flowOf(scene);
  const FlowWallsConfig& walls = flow.config.walls;
  const auto surfaceAt = [&](double x, double y) {
    return walls.surfaces[walls.groundSurfaces.at(walls.ground.column(x), walls.ground.row(y))];
  };
  EXPECT_FLOAT_EQ(surfaceAt(10.0, 5.0).tangent, 0.77f);
  EXPECT_FLOAT_EQ(surfaceAt(3.0, 3.0).tangent, 0.1f);
  EXPECT_NEAR(surfaceAt(3.0, 3.0).turbulence, 9.80665f / 2000.0f, 1e-7f);
  EXPECT_FLOAT_EQ(walls.ground.at(walls.ground.column(4.0), walls.ground.row(4.0)), 3.0f);
}

TEST(Inflow, LatticesKeepTheFlowAndNeverOverlap) {
  const SceneSnapshot scene = FlowTestScene().build();
  for (const double flow : {0.05, 0.2, 0.33, 1.0, 2.7}) {
    WaterSourceNode line;
    line.velocity = {0, 3, 0};
    line.end = {2.3, 0, 0};
    line.flowPerMetre = flow;
    const InflowLattice lattice = inflowLattice(scene, line, 0.1);
    const double rate = static_cast<double>(lattice.positions.size()) * 1e-3 / lattice.interval;
    EXPECT_NEAR(rate, flow * 2.3, 1e-9);
    EXPECT_GE(length(lattice.velocity) * lattice.interval, 0.099);
    WaterSourceNode disc;
    disc.shape = WaterSourceShape::Disc;
    disc.radius = 0.4;
    disc.flow = flow;
    const InflowLattice round = inflowLattice(scene, disc, 0.1);
    EXPECT_NEAR(static_cast<double>(round.positions.size()) * 1e-3 / round.interval, flow, 1e-9);
    EXPECT_NEAR(length(round.velocity), flow / (3.14159265 * 0.16), 1e-6);
    EXPECT_GT(length(round.velocity) * round.interval, 0.07);
  }
}

TEST(Inflow, ColumnsDoNotEnterAsRows) {
  const SceneSnapshot scene = FlowTestScene().build();
  WaterSourceNode line;
  line.velocity = {0, 3, 0};
  line.end = {4.0, 0, 0};
  line.flowPerMetre = 0.3;
  const InflowLattice lattice = inflowLattice(scene, line, 0.1);
  std::vector<double> ahead;
  for (const Vec3d& p : lattice.positions) ahead.push_back(p.y / (3.0 * lattice.interval));
  std::sort(ahead.begin(), ahead.end());
  ASSERT_EQ(ahead.size(), 40u);
  EXPECT_GE(ahead.front(), 0.0);
  EXPECT_LT(ahead.back(), 1.0);
  for (std::size_t k = 1; k < ahead.size(); ++k) EXPECT_LT(ahead[k] - ahead[k - 1], 2.0 / 40.0);
}

}  // namespace
}  // namespace spin
