// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "core/air/brick_solids.h"
#include "core/cloud/cloud_estimate.h"
#include "core/cloud/cloud_process.h"
#include "core/cloud/cloud_scene.h"
#include "core/nodes/weather_nodes.h"
#include "core/snow/snow_processes.h"
#include "core/snow/wind_field.h"
#include "tests/core/cloud/fake_air.h"
#include "tests/core/flow/flow_test_scene.h"
#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

using test::FlowTestScene;

constexpr int kLast = 9;

AirNode lively() {
  AirNode air;
  air.impactAcceleration = 30.0;
  air.mistSpeed = 2.0, air.mistRate = 0.2;
  air.powderSpeed = 2.0, air.powderRate = 0.5;
  air.sprayRate = 5.0, air.trappedLow = 0.2, air.trappedHigh = 2.0;
  air.energyLow = 1.0, air.energyHigh = 20.0;
  air.waterTemperature = 280.0;
  air.margin = 5.0, air.headroom = 5.0;
  air.coupling = 0.04;
  return air;
}

/// A source that lets water fall 4 m on to a slope with a slab of snow, a moved crate and frost.
FlowTestScene fallScene() {
  FlowTestScene scene;
  test::slopeScene(scene);
  scene.settings.spacing = 0.2;
  scene.settings.headroom = 6.0;
  WaterSourceNode source;
  source.position = {4.0, 8.0, 4.0}, source.end = {4.0, 10.0, 4.0};
  source.velocity = {2.0, 0.0, -3.0};
  source.flowPerMetre = 1.0;
  WeatherNode weather;
  weather.airTemperature = 268.15, weather.windSpeed = 4.0, weather.precipitationRate = 0.0;
  SnowfallNode snowfall;
  snowfall.flakeCount = 0;
  test::addCube(scene, "crate", 0.8f, {8.5, 3.0, 0.5}, RigidMotion::Dynamic);
  scene.add(kAvalancheReleaseType, "slab", test::squareRelease(2.0, 4.0, 0.6));
  scene.add(kWaterSourceType, "source", source).add(kWeatherType, "weather", weather);
  scene.add(kSnowfallType, "snowfall", snowfall);
  return scene;
}
SceneSnapshot cloudScene() {
  return fallScene().add(kAirType, "air", lively()).build();
}

RunOptions cloudOptions(int last, int threads = 2) {
  RunOptions options;
  options.lastFrame = last;
  options.threads = threads;
  options.types = {exposureProcessType(), coverProcessType(), flowProcessType(), cloudProcessType()};
  options.makeAirSolver = [](const AirConfig& config) -> Result<std::unique_ptr<AirSolver>> {
    return std::unique_ptr<AirSolver>(std::make_unique<test::FakeAir>(config));
  };
  return options;
}

std::vector<std::vector<char>> uninterrupted(const SceneSnapshot& scene, int last, int threads = 2) {
  FrameStore store;
  const Status done = runSimulation(scene, store, cloudOptions(last, threads), {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return test::resultsOf(store, last);
}

FramePointer frameOf(const SceneSnapshot& scene, int last) {
  FrameStore store;
  const Status done = runSimulation(scene, store, cloudOptions(last), {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return store.get(last);
}

TEST(CloudProcess, IsThereOnlyWithAnAirNodeAndFlow) {
  EXPECT_FALSE(sceneHasCloud(fallScene().build()));
  EXPECT_TRUE(sceneHasCloud(cloudScene()));
  FlowTestScene still;
  EXPECT_FALSE(sceneHasCloud(test::slopeScene(still).add(kAirType, "air", AirNode{}).build()));
}

TEST(CloudProcess, WhatFallsGivesMistPowderSprayAndCover) {
  const FramePointer frame = frameOf(cloudScene(), 15);
  const auto* air = frame->part<AirPart>("air");
  const auto* spray = frame->part<ParticlePart>("spray");
  ASSERT_TRUE(air && spray);
  EXPECT_GT(air->bricks.size(), 0u);
  EXPECT_EQ(air->temperature, 268.15);
  const auto& figures = frame->info.figures;
  EXPECT_GT(figures.at("air_mist_kg"), 0.0);
  EXPECT_GT(figures.at("air_settled_kg"), 0.0);
  EXPECT_GT(figures.at("spray_parcels"), 0.0);
  for (const char* name : {"velocity", "diameter", "mass", "age", "material"})
    ASSERT_TRUE(spray->particles.find(name)) << name;
}

TEST(CloudProcess, EveryTermOfTheMassBudgetIsCountedWhereItHappens) {
  const FramePointer frame = frameOf(cloudScene(), 15);
  const MassBudget& budget = frame->info.budget;
  EXPECT_GT(budget.get("flow_inflow"), 0.0);
  EXPECT_GT(budget.get("air_present"), 0.0);
  EXPECT_GT(budget.get("deposited"), 0.0) << "rime and dust lie on the slope";
  // The grid of this test keeps floats.
  EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-7);
  EXPECT_GT(budget.get("air_present") + budget.get("spray_present"), 1e-4 * budget.get("flow_inflow"));
}

TEST(CloudProcess, ThreadsDoNotChangeABit) {
  const auto one = uninterrupted(cloudScene(), kLast, 1);
  EXPECT_EQ(uninterrupted(cloudScene(), kLast, 3), one);
}

TEST(CloudProcess, ContinuingAfterCancelGivesTheSameBytes) {
  const SceneSnapshot scene = cloudScene();
  const auto expected = uninterrupted(scene, kLast);
  test::TemporaryFolder folder;
  for (const int stopAt : {0, 4, 7}) {
    FrameStore store({folder.path("cache" + std::to_string(stopAt))});
    CancelToken cancel;
    RunCallbacks callbacks;
    callbacks.frameReady = [&](const FramePointer& frame) {
      if (frame->info.time.frame == stopAt) cancel.cancel();
    };
    const Status stopped = runSimulation(scene, store, cloudOptions(kLast), callbacks, cancel);
    ASSERT_FALSE(stopped.ok());
    ASSERT_TRUE(runSimulation(scene, store, cloudOptions(kLast), {}, CancelToken()));
    EXPECT_EQ(test::resultsOf(store, kLast), expected) << "stopped at " << stopAt;
  }
}

TEST(CloudProcess, KilledAtAnyMomentItResumesToTheSameBytes) {
  const SceneSnapshot scene = cloudScene();
  test::TemporaryFolder folder;
  const auto expected = uninterrupted(scene, kLast);
  for (const int milliseconds : {60, 400, 1200}) {
    const std::string cache = folder.path("cache" + std::to_string(milliseconds));
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      FrameStore store({cache});
      const Status done = runSimulation(scene, store, cloudOptions(kLast, 1), {}, CancelToken());
      ::_exit(done.ok() ? 0 : 1);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    FrameStore store({cache});
    ASSERT_TRUE(runSimulation(scene, store, cloudOptions(kLast), {}, CancelToken()));
    EXPECT_EQ(test::resultsOf(store, kLast), expected) << "killed after " << milliseconds << " ms";
  }
}

TEST(CloudProcess, HeldAirStandsAndHeldFlowLetsItGoOn) {
  FlowTestScene scene = fallScene();
  scene.add(kAirType, "air", lively());
  const FramePointer free = frameOf(scene.build(), 6);
  FlowTestScene heldAir = scene, heldFlow = scene;
  const auto hold = [](FlowTestScene& s, const char* property) {
    s.simulation.lastFrame = 20;
    SceneSnapshot built = s.build();
    for (SceneNode& node : built.nodes)
      if (node.as<SimulationNode>()) {
        auto data = std::make_shared<SimulationNode>(*node.as<SimulationNode>());
        (std::string(property) == "pause_air" ? data->pauseAir : data->pauseFlow) = true;
        node.data = data;
      }
    return built;
  };
  const FramePointer air = frameOf(hold(heldAir, "pause_air"), 6);
  EXPECT_EQ(air->info.figures.at("air_mist_kg"), 0.0);
  EXPECT_EQ(air->info.figures.at("air_steps"), 0.0);
  EXPECT_GT(air->info.figures.at("flow_particles"), free->info.figures.at("flow_particles") - 1.0);
  const FramePointer flow = frameOf(hold(heldFlow, "pause_flow"), 6);
  EXPECT_GT(flow->info.figures.at("air_steps"), 0.0);
  EXPECT_LT(std::abs(flow->info.budget.relativeImbalance()), 1e-7);
}

TEST(CloudProcess, AStateThatWasCutOrChangedIsRefusedOrHarmless) {
  const SceneSnapshot scene = cloudScene();
  Pipeline pipeline = Pipeline::compile(scene, {flowProcessType(), cloudProcessType()});
  CpuBackend backend(1);
  const RaySceneFactory rays = makeBvhRayScene;
  const CancelToken cancel;
  ProcessContext context{backend, rays, cancel, pipeline.exchange(), {}};
  context.makeAirSolver = cloudOptions(1).makeAirSolver;
  Process &flow = *pipeline.processes()[0], &air = *pipeline.processes()[1];
  ASSERT_TRUE(flow.begin(scene, context) && air.begin(scene, context));
  for (int frame = 0; frame < 4; ++frame) {
    const StepInput input{scene, scene.timeOf(frame), scene.timeOf(frame + 1)};
    ASSERT_TRUE(flow.step(input, context) && air.step(input, context));
  }
  ByteWriter out;
  air.saveState(out);
  const std::vector<char> good = out.take();
  const auto loads = [&](const std::vector<char>& bytes) {
    ByteReader in(bytes.data(), bytes.size());
    return air.loadState(scene, context, in).ok() && in.ok();
  };
  EXPECT_TRUE(loads(good));
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 11)
    EXPECT_FALSE(loads({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 13) {
    std::vector<char> bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    (void)loads(bytes);
  }
  EXPECT_TRUE(loads(good));
}

TEST(CloudProcess, LongFramesAreCutIntoParts) {
  FlowTestScene scene = fallScene();
  scene.simulation.frameRate = 5.0;
  AirNode air = lively();
  air.coupling = 0.05;
  scene.add(kAirType, "air", air);
  EXPECT_EQ(frameOf(scene.build(), 3)->info.figures.at("air_steps"), 4.0);
}

/// A plateau of a height beside low ground, in a wind of 4 m/s.
Result<CloudScene> windyLand(double height) {
  FlowTestScene scene = fallScene();
  scene.land(51, 31, 2.0, [=](double x, double) { return x <= 30.0 ? height : 0.0; });
  WeatherNode weather;
  weather.windSpeed = 4.0;
  scene.add(kWeatherType, "weather", weather).add(kAirType, "air", AirNode{});
  return makeCloudScene(scene.build(), {});
}

TEST(CloudScene, WindIsTheWeathersTenMetresAboveLevelGround) {
  const Result<CloudScene> made = windyLand(0.0);
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_NEAR(length(made->air.wind({50, 30, 10})), 4.0, 0.01);
}

TEST(CloudScene, WindOverACliffIsNoFasterThanTwiceTheOneOverLevelGround) {
  const Result<CloudScene> made = windyLand(55.0);
  ASSERT_TRUE(made.ok()) << made.error().text();
  for (double z = 1.0; z < 120.0; z += 1.7)
    for (double x = 10.0; x < 60.0; x += 0.7)
      EXPECT_LT(length(made->air.wind({x, 30, z})), 2.0 * 4.0 * logProfile(300.0, 0.01) + 1e-6)
          << x << ' ' << z;
}

/// Land of a height, with water that flows over it, and the air over all of it.
FlowTestScene airyLand(double spacing, double margin, const std::function<double(double)>& height) {
  FlowTestScene scene;
  scene.land(51, 31, 2.0, [=](double x, double) { return height(x); });
  scene.settings.spacing = spacing, scene.settings.margin = 4.0, scene.settings.headroom = 6.0;
  WaterSourceNode source;
  source.position = {26.0, 22.0, 0.1}, source.end = {26.0, 38.0, 0.1};
  source.velocity = {4.0, 0.0, 0.0}, source.flowPerMetre = 3.5;
  AirNode air;
  air.margin = margin, air.headroom = 40.0;
  return scene.add(kWaterSourceType, "crest", source).add(kAirType, "air", air);
}

TEST(CloudScene, CellsThatDoNotFitIntoMemoryAreTold) {
  const SceneSnapshot fits = airyLand(0.5, 10.0, [](double) { return 0.0; }).build();
  EXPECT_TRUE(findCloudIssues(fits).empty());
  const Result<CloudScene> made = makeCloudScene(fits, {}, false);
  ASSERT_TRUE(made.ok());
  const double bytes = filledCells(*made) * kCloudWorkBytes;
  EXPECT_FALSE(memoryIssue(*made, "air", 1.01 * bytes));
  const auto issue = memoryIssue(*made, "air", 0.99 * bytes);
  ASSERT_TRUE(issue);
  EXPECT_TRUE(issue->fatal);
  EXPECT_NE(issue->text.find("million cells of 2 m"), std::string::npos) << issue->text;
}

TEST(CloudScene, CliffsHaveNoHoles) {
  const auto height = [](double x) { return std::clamp(27.5 * (32.0 - x), 0.0, 55.0); };
  for (const auto& [spacing, margin] : {std::pair{0.4, 20.0}, {0.3, 12.0}}) {
    const Result<CloudScene> made = makeCloudScene(airyLand(spacing, margin, height).build(), {});
    ASSERT_TRUE(made.ok()) << made.error().text();
    const AirConfig& c = made->air;
    int rock = 0, holes = 0;
    for (std::int32_t z = 0; z < c.highBrick[2]; ++z)
      for (std::int32_t x = 0; x < c.highBrick[0]; ++x) {
        const BrickSolids solids = cutBrick(c, {x, c.highBrick[1] / 2, z});
        for (int k = 0; k < static_cast<int>(kBrickCells); ++k) {
          const double right = c.origin.x + c.cell * (x * kBrickX + k % kBrickX + 1.0);
          const double top = c.origin.z + c.cell * (z * kBrickZ + k / (kBrickX * kBrickY) + 1.0);
          if (top >= height(right)) continue;
          ++rock;
          holes += solids.volume[static_cast<std::size_t>(k)] > 0.0f;
        }
      }
    EXPECT_GT(rock, 500);
    EXPECT_EQ(holes, 0) << "of " << rock << " at " << spacing;
  }
}

TEST(CloudScene, ModelsAreSolidWhereverTheyStand) {
  for (const RigidMotion motion : {RigidMotion::Static, RigidMotion::Dynamic})
    for (const double at : {24.0, 26.0, 28.0}) {
      FlowTestScene scene = airyLand(0.2, 10.0, [](double) { return 0.0; });
      scene.settings.headroom = 46.0;
      test::addCube(scene, "crate", 5.0f, {at, 30.0, 30.0}, motion);
      const Result<CloudScene> made = makeCloudScene(scene.build(), {});
      ASSERT_TRUE(made.ok()) << made.error().text();
      const AirConfig& c = made->air;
      double solid = 0.0;
      for (std::int32_t z = 0; z < c.highBrick[2]; ++z)
        for (std::int32_t y = 0; y < c.highBrick[1]; ++y)
          for (std::int32_t x = 0; x < c.highBrick[0]; ++x) {
            if (c.origin.z + c.cell * kBrickZ * z < 20.0) continue;
            for (const float volume : cutBrick(c, {x, y, z}).volume)
              solid += 1.0 - static_cast<double>(volume);
          }
      EXPECT_NEAR(solid * c.cell * c.cell * c.cell, 125.0, 8.0) << "at " << at;
    }
}

TEST(CloudScene, HasTheFlowsSolidsTheWeathersAirAndItsOwnBox) {
  const Result<CloudScene> made = makeCloudScene(cloudScene(), {});
  ASSERT_TRUE(made.ok()) << made.error().text();
  EXPECT_EQ(made->air.cell, 4.0 * 0.2);
  EXPECT_EQ(made->air.temperature, 268.15);
  EXPECT_EQ(made->air.solids.size(), 2u) << "ground and crate";
  EXPECT_NEAR(made->solids.groundDistance({12, 6, 1}), 1.0, 1e-6);
  // On the slope, 0.75 m high there.
  EXPECT_LT(made->solids.distance({8.5, 3.0, 1.25}), -0.2) << "within the crate";
  EXPECT_LT(made->air.solids[1].distance({8.5, 3.0, 1.25}), -0.2);
  EXPECT_GT(made->solids.distance({8.5, 6.0, 2.0}), 0.5);
  EXPECT_LT(length(made->air.wind({12, 6, 1})), 3.0);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(made->cells() * 1.0, made->box.size()[axis] / made->air.cell);
  EXPECT_GT(made->air.settling[0], 0.02);
  EXPECT_LT(made->air.settling[0], 0.03);
}

}  // namespace
}  // namespace spin
