// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "core/flow/flow_estimate.h"
#include "core/flow/flow_scene.h"
#include "core/sim/bodies_part.h"
#include "tests/core/flow/flow_test_scene.h"
#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

using test::busyScene;
using test::flowOf;
using test::flowOptions;
using test::FlowTestScene;

constexpr int kLast = 12;

std::vector<std::vector<char>> uninterrupted(const SceneSnapshot& scene, int last, int threads = 2) {
  FrameStore store;
  const Status done = runSimulation(scene, store, flowOptions(last, threads), {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return test::resultsOf(store, last);
}

FramePointer lastFrame(const SceneSnapshot& scene, int last) {
  FrameStore store;
  const Status done = runSimulation(scene, store, flowOptions(last), {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return store.get(last);
}

double meanX(const ParticleSet& set) {
  double sum = 0.0;
  for (const Vec3f& p : set.positions) sum += static_cast<double>(p.x);
  return sum / static_cast<double>(set.size());
}

TEST(FlowProcess, IsThereOnlyWhereFlowIs) {
  FlowTestScene scene;
  EXPECT_FALSE(sceneHasFlow(test::slopeScene(scene).build()));
  EXPECT_TRUE(sceneHasFlow(busyScene()));
}

TEST(FlowProcess, ThreadsDoNotChangeABit) {
  const auto one = uninterrupted(busyScene(), kLast, 1);
  EXPECT_EQ(uninterrupted(busyScene(), kLast, 2), one);
  EXPECT_EQ(uninterrupted(busyScene(), kLast, 4), one);
}

TEST(FlowProcess, EveryTermOfTheMassBudgetIsCountedWhereItHappens) {
  const FramePointer frame = lastFrame(busyScene(), 15);
  const MassBudget& budget = frame->info.budget;
  EXPECT_GT(budget.get("flow_released"), 0.0);
  EXPECT_GT(budget.get("flow_inflow"), 0.0);
  EXPECT_GT(budget.get("flow_present"), 0.0);
  EXPECT_GT(budget.get("flow_sunk"), 0.0) << "the slab has reached the sink";
  EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-12);
}

TEST(FlowProcess, WhatRunsOffTheTerrainIsCountedAsLeft) {
  FlowTestScene scene;
  scene.land(21, 21, 0.5, [](double x, double) { return -1.0 * x; });
  scene.settings.spacing = 0.25;
  scene.settings.vegetation = 0.1;
  scene.settings.margin = 1.0;
  scene.add(kAvalancheReleaseType, "release", test::squareRelease(6.0, 8.0, 0.5));
  const FramePointer frame = lastFrame(scene.build(), 30);
  EXPECT_GT(frame->info.budget.get("flow_left"), 0.5 * frame->info.budget.get("flow_released"));
  EXPECT_LT(std::abs(frame->info.budget.relativeImbalance()), 1e-12);
}

TEST(FlowProcess, ContinuingAfterCancelGivesTheSameBytes) {
  const SceneSnapshot scene = busyScene();
  const auto expected = uninterrupted(scene, kLast);
  test::TemporaryFolder folder;
  for (const int stopAt : {0, 2, 5, 9}) {
    FrameStore store({folder.path("cache" + std::to_string(stopAt))});
    CancelToken cancel;
    RunCallbacks callbacks;
    callbacks.frameReady = [&](const FramePointer& frame) {
      if (frame->info.time.frame == stopAt) cancel.cancel();
    };
    const Status stopped = runSimulation(scene, store, flowOptions(kLast), callbacks, cancel);
    ASSERT_FALSE(stopped.ok());
    EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
    ASSERT_TRUE(runSimulation(scene, store, flowOptions(kLast), {}, CancelToken()));
    EXPECT_EQ(test::resultsOf(store, kLast), expected) << "stopped at " << stopAt;
  }
}

/// A run in a process of its own that is killed after a while.
void runAndKill(const SceneSnapshot& scene, const std::string& cache, int milliseconds) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    FrameStore store({cache});
    // One thread: those of the parent are not there in its copy.
    const Status done = runSimulation(scene, store, flowOptions(kLast, 1), {}, CancelToken());
    ::_exit(done.ok() ? 0 : 1);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
}

TEST(FlowProcess, KilledAtAnyMomentItResumesToTheSameBytes) {
  const SceneSnapshot scene = busyScene();
  test::TemporaryFolder folder;
  const auto expected = uninterrupted(scene, kLast);
  for (const int milliseconds : {1, 40, 110, 230, 470, 900}) {
    const std::string cache = folder.path("cache" + std::to_string(milliseconds));
    runAndKill(scene, cache, milliseconds);
    FrameStore store({cache});
    ASSERT_TRUE(runSimulation(scene, store, flowOptions(kLast), {}, CancelToken()));
    EXPECT_EQ(test::resultsOf(store, kLast), expected) << "killed after " << milliseconds << " ms";
  }
}

TEST(FlowProcess, AStateThatWasCutOrChangedIsRefused) {
  const SceneSnapshot scene = busyScene();
  Pipeline pipeline = Pipeline::compile(scene, {flowProcessType()});
  CpuBackend backend(1);
  const RaySceneFactory rays = makeBvhRayScene;
  const CancelToken cancel;
  ProcessContext context{backend, rays, cancel, pipeline.exchange(), {}};
  Process& process = *pipeline.processes()[0];
  ASSERT_TRUE(process.begin(scene, context));
  ASSERT_TRUE(process.step({scene, scene.timeOf(0), scene.timeOf(1)}, context));
  ByteWriter out;
  process.saveState(out);
  const std::vector<char> good = out.take();
  const auto loads = [&](const std::vector<char>& bytes) {
    ByteReader in(bytes.data(), bytes.size());
    return process.loadState(scene, context, in).ok() && in.ok();
  };
  EXPECT_TRUE(loads(good));
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 97)
    EXPECT_FALSE(loads({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)})) << size;
  // A changed byte may give another valid state, but never one that brings the solver down.
  for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 211) {
    std::vector<char> bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x55);
    if (loads(bytes)) (void)process.step({scene, scene.timeOf(1), scene.timeOf(2)}, context);
  }
  EXPECT_TRUE(loads(good));
}

TEST(FlowProcess, CancelEndsAStepWithinASecond) {
  FlowTestScene scene;
  test::slopeScene(scene);
  scene.settings.spacing = 0.06;
  scene.simulation.frameRate = 1.0;
  scene.add(kAvalancheReleaseType, "release", test::squareRelease(2.0, 6.0, 1.0));
  CancelToken cancel;
  std::chrono::steady_clock::time_point asked;
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    asked = std::chrono::steady_clock::now();
    cancel.cancel();
  });
  FrameStore store;
  const Status done = runSimulation(scene.build(), store, flowOptions(20), {}, cancel);
  other.join();
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().kind, ErrorKind::Cancelled);
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(1));
}

TEST(FlowProcess, FramesCarryAttributesFiguresAndStages) {
  const FramePointer frame = lastFrame(busyScene(), 6);
  const ParticleSet& set = flowOf(*frame);
  EXPECT_EQ(set.name, "flow");
  ASSERT_GT(set.size(), 100u);
  for (const char* name : {"velocity", "density", "pressure", "acceleration", "shear_rate", "viscosity",
                           "age", "neighbours", "material", "class"}) {
    const ParticleAttribute* attribute = set.find(name);
    ASSERT_TRUE(attribute) << name;
    EXPECT_EQ(attribute->values.size(), set.size() * static_cast<std::size_t>(attribute->components));
  }
  double neighbours = 0.0, oldest = 0.0, youngest = 1e9;
  for (const float n : test::valuesOf(set, "neighbours")) neighbours += static_cast<double>(n);
  EXPECT_GT(neighbours / static_cast<double>(set.size()), 8.0);
  EXPECT_LT(neighbours / static_cast<double>(set.size()), 60.0);
  for (const float age : test::valuesOf(set, "age")) {
    oldest = std::max(oldest, static_cast<double>(age));
    youngest = std::min(youngest, static_cast<double>(age));
  }
  EXPECT_NEAR(oldest, 0.6, 1e-6) << "of the first slab";
  EXPECT_LT(youngest, 0.2) << "of the inflow, a lattice every 0.114 s";
  const auto& figures = frame->info.figures;
  EXPECT_EQ(figures.at("flow_particles"), static_cast<double>(set.size()));
  EXPECT_EQ(figures.at("flow_layers"), 2.0);
  EXPECT_GT(figures.at("flow_max_speed_m_s"), figures.at("flow_mean_speed_m_s"));
  EXPECT_GT(figures.at("flow_steps"), 1.0);
  for (const char* stage : {"sort", "pressure", "shear rate", "force", "integrate"})
    EXPECT_GT(frame->info.timings.seconds(stage), 0.0) << stage;
}

TEST(FlowProcess, SnowComesToRestWhereWaterRunsOn) {
  const auto run = [](FlowMaterialKind material) {
    FlowTestScene scene;
    // 19 degrees, less than the friction of snow and of the ground.
    scene.land(41, 21, 0.5, [](double x, double) { return 8.0 - 0.35 * x; });
    scene.settings.spacing = 0.2;
    scene.settings.vegetation = 0.5;
    AvalancheReleaseNode release = test::squareRelease(3.0, 6.0, 0.8);
    release.material = material;
    scene.add(kAvalancheReleaseType, "release", release);
    return lastFrame(scene.build(), 20);
  };
  const FramePointer snow = run(FlowMaterialKind::DrySnow), water = run(FlowMaterialKind::Water);
  const double snowSpeed = snow->info.figures.at("flow_mean_speed_m_s");
  EXPECT_LT(snowSpeed, 0.1);
  // The ground's grip holds the lowest layer of water too; the rest flows over it.
  EXPECT_GT(water->info.figures.at("flow_mean_speed_m_s"), std::max(0.15, 3.0 * snowSpeed));
  EXPECT_GT(meanX(flowOf(*water)), meanX(flowOf(*snow)) + 0.5);
}

TEST(FlowProcess, AnInflowHasItsVolumeAndDoesNotOverlap) {
  FlowTestScene scene;
  scene.land(41, 21, 0.5, [](double, double) { return 0.0; });
  WaterSourceNode source;
  source.position = {2.0, 3.0, 0.05};
  source.end = {2.0, 6.0, 0.05};
  source.velocity = {1.5, 0.0, 0.0};
  source.flowPerMetre = 0.45;
  scene.settings.spacing = 0.1;
  scene.add(kWaterSourceType, "source", source);
  const FramePointer frame = lastFrame(scene.build(), 10);
  // 3 m x 0.45 m2/s x 1 s, to one lattice.
  EXPECT_NEAR(frame->info.budget.get("flow_inflow") / 999.8, 1.35, 30 * 3 * 1e-3);
  EXPECT_LT(frame->info.figures.at("flow_density_error"), 0.05);
  EXPECT_LT(frame->info.figures.at("flow_max_speed_m_s"), 4.5);
}

TEST(FlowProcess, WindAndSinksFollowTheirKeys) {
  const auto run = [](bool windy) {
    FlowTestScene scene;
    scene.land(41, 21, 0.5, [](double, double) { return 0.0; });
    scene.settings.grip = GroundGrip::FreeSlip;
    scene.settings.windDrag = 0.1;
    AvalancheReleaseNode release = test::squareRelease(4.0, 6.0, 0.3);
    scene.add(kAvalancheReleaseType, "release", release).add(kWeatherType, "weather", WeatherNode{});
    SceneSnapshot snapshot = scene.build();
    for (SceneNode& node : snapshot.nodes) {
      if (node.id != "weather") continue;
      setPlainValue(node, *node.type->find("wind_speed_m_s"), 0.0);
      setPlainValue(node, *node.type->find("wind_from_deg"), 270.0);
      node.curves["wind_speed_m_s"].setKey({0.0, 0.0, Interpolation::Step});
      if (windy) node.curves["wind_speed_m_s"].setKey({0.5, 30.0, Interpolation::Step});
    }
    return meanX(flowOf(*lastFrame(snapshot, 10)));
  };
  EXPECT_GT(run(true), run(false) + 0.3);
}

TEST(FlowProcess, BodiesStandMoveByKeysOrAreCarriedAway) {
  FlowTestScene scene;
  test::slopeScene(scene);
  scene.settings.vegetation = 0.1;
  scene.settings.spacing = 0.2;
  scene.add(kAvalancheReleaseType, "slab", test::squareRelease(2.0, 5.0, 1.0));
  test::addCube(scene, "crate", 0.8f, {6.5, 3.5, 0.42}, RigidMotion::Dynamic);
  test::addCube(scene, "pillar", 1.0f, {9.0, 3.0, 0.4}, RigidMotion::Static);
  test::addCube(scene, "ram", 0.6f, {2.0, 9.0, 1.0}, RigidMotion::Kinematic);
  SceneSnapshot snapshot = scene.build();
  for (SceneNode& node : snapshot.nodes)
    if (node.id == "ram") {
      node.curves["position_m"].setKey({0.0, Vec3d{2.0, 9.0, 1.0}, Interpolation::Linear});
      node.curves["position_m"].setKey({2.0, Vec3d{2.0, 11.0, 1.0}, Interpolation::Linear});
    }
  const FramePointer frame = lastFrame(snapshot, 15);
  const auto* bodies = frame->part<BodiesPart>("bodies");
  ASSERT_TRUE(bodies);
  ASSERT_EQ(bodies->bodies.size(), 2u) << "the pillar is a wall";
  const auto* crate = bodies->find("crate");
  const auto* ram = bodies->find("ram");
  ASSERT_TRUE(crate && ram);
  EXPECT_GT(crate->placement.translation.x, 7.0) << "pushed down the slope";
  EXPECT_NEAR(ram->placement.translation.y, 10.5, 1e-6);
  EXPECT_NEAR(ram->velocity.y, 1.0, 1e-6);
  for (const Vec3f& p : flowOf(*frame).positions) {
    const bool within = std::abs(p.x - 9.0f) < 0.4f && std::abs(p.y - 3.0f) < 0.4f && p.z < 1.3f;
    EXPECT_FALSE(within) << "in the pillar: " << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_LT(std::abs(frame->info.budget.relativeImbalance()), 1e-12);
  // Boundary particles lie within the moving bodies, where those are now.
  const auto* boundary = frame->part<ParticlePart>("flow_boundary");
  ASSERT_TRUE(boundary);
  EXPECT_GT(boundary->particles.size(), 30u);
  for (const Vec3f& p : boundary->particles.positions) {
    const double toCrate = length(p.to<double>() - crate->placement.translation);
    const double toRam = length(p.to<double>() - ram->placement.translation);
    EXPECT_TRUE(toCrate < 0.7 || toRam < 0.53) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(FlowEstimate, IsAboutWhatIsThere) {
  const SceneSnapshot scene = busyScene();
  const FlowEstimate need = estimateFlow(scene);
  // At the last frame all slabs are there and the source has flowed for 2 - 0.15 s.
  EXPECT_NEAR(need.particles, 2 * 2 * 1.118 * 0.6 / 0.008 + 1.118 * 0.4 / 0.008 + 1.85 * 0.7 * 2 / 0.008, 60);
  EXPECT_GT(need.seconds(2.0, Isa::Baseline, 1), need.seconds(2.0, Isa::Avx512, 1));
  FrameStore store;
  const RunEstimate run = estimateRun(scene, store, flowOptions(kLast));
  EXPECT_GT(run.frameBytes, need.particles * 60.0);
  EXPECT_GT(run.memoryBytes, run.frameBytes);
}

}  // namespace
}  // namespace spin
