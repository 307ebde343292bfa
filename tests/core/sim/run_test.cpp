// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>

#include "tests/core/sim/test_processes.h"

namespace spin {
namespace {

namespace fs = std::filesystem;
using test::behaviour;
using test::setProperty;

class Simulation : public ::testing::Test {
 protected:
  void SetUp() override {
    behaviour().nanAtFrame = -1;
    behaviour().stepMilliseconds = 0;
    behaviour().stepsDone = 0;
    behaviour().begins = 0;
  }
  test::TemporaryFolder folder;
  SceneSnapshot scene = test::testScene();
};

std::vector<Hash128> keysOf(const SceneSnapshot& scene, int last, const std::string& backend = "cpu-x") {
  return frameKeys(scene, Pipeline::compile(scene, test::testTypes()), backend, last);
}

/// First frame whose key differs; last + 1 if none does.
int firstDifference(const std::vector<Hash128>& a, const std::vector<Hash128>& b) {
  std::size_t frame = 0;
  while (frame < a.size() && a[frame] == b[frame]) ++frame;
  for (std::size_t later = frame; later < a.size(); ++later)
    EXPECT_NE(a[later], b[later]) << "the chain broke";
  return static_cast<int>(frame);
}

TEST_F(Simulation, PipelineHoldsWhatTheSceneNeedsInOrder) {
  const Pipeline both = Pipeline::compile(scene, test::testTypes());
  ASSERT_EQ(both.processes().size(), 2u);
  EXPECT_STREQ(both.processes()[0]->id(), "walk");
  EXPECT_STREQ(both.processes()[1]->id(), "grow");
  scene.nodes[1].enabled = false;
  EXPECT_EQ(Pipeline::compile(scene, test::testTypes()).processes().size(), 1u);
  EXPECT_EQ(Pipeline::compile(SceneSnapshot{}, test::testTypes()).processes().size(), 0u);
}

TEST_F(Simulation, AnEditKeepsTheFramesBeforeIt) {
  const auto before = keysOf(scene, 20);
  EXPECT_EQ(keysOf(scene, 20), before);
  SceneSnapshot edited = scene;
  AnimationCurve& curve = edited.nodes[0].curves["wind_speed_m_s"];
  curve.setKey({0.0, 2.0, Interpolation::Step});
  curve.setKey({1.2, 6.0, Interpolation::Step});
  EXPECT_EQ(firstDifference(before, keysOf(edited, 20)), 12);
  edited = scene;
  setProperty(edited.nodes[0], "sun_azimuth_deg", 12.0);
  EXPECT_EQ(firstDifference(before, keysOf(edited, 20)), 21) << "light is no matter of the simulation";
}

TEST_F(Simulation, KeysCountSeedRateScaleAndBackendAndNotTheLength) {
  const auto before = keysOf(scene, 10);
  const auto afterSetting = [&](const char* property, const Value& value) {
    SceneSnapshot edited = scene;
    setProperty(edited.nodes[2], property, value);
    return firstDifference(before, keysOf(edited, 10));
  };
  EXPECT_EQ(afterSetting("seed", std::int64_t{2}), 0);
  EXPECT_EQ(afterSetting("frame_rate", 12.0), 1) << "frame 0 is the same at any rate";
  EXPECT_EQ(afterSetting("time_scale", 3.0), 1);
  EXPECT_EQ(afterSetting("last_frame", std::int64_t{7}), 11);
  EXPECT_EQ(afterSetting("checkpoint_interval", std::int64_t{7}), 11);
  EXPECT_EQ(firstDifference(before, keysOf(scene, 10, "cuda-sm90")), 0);
  scene.nodes[1].enabled = false;
  EXPECT_EQ(firstDifference(before, keysOf(scene, 10)), 0) << "another set of processes";
}

TEST_F(Simulation, KeysCountTheRayCasterAndNotTheThreads) {
  struct Other final : RayScene {
    std::uint32_t addTriangles(const std::vector<Vec3f>&, const std::vector<std::uint32_t>&) override {
      return 0;
    }
    bool commit(const CancelToken&) override { return true; }
    bool occluded(const Ray&) const override { return false; }
    std::optional<RayHit> closest(const Ray&) const override { return std::nullopt; }
    const char* name() const override { return "other"; }
  };
  RunOptions options = test::testOptions(3, 1);
  const auto before = frameKeys(scene, options);
  options.threads = 2;
  EXPECT_EQ(frameKeys(scene, options), before);
  options.makeRayScene = [] { return std::unique_ptr<RayScene>(std::make_unique<Other>()); };
  EXPECT_EQ(firstDifference(before, frameKeys(scene, options)), 0);
}

TEST_F(Simulation, ThreadsDoNotChangeABit) {
  const auto one = test::referenceResults(scene, 12, 1);
  EXPECT_EQ(test::referenceResults(scene, 12, 2), one);
  EXPECT_EQ(test::referenceResults(scene, 12, 4), one);
  setProperty(scene.nodes[2], "seed", std::int64_t{2});
  EXPECT_NE(test::referenceResults(scene, 12, 1), one) << "the comparison sees the walk";
}

TEST_F(Simulation, FramesCarryTheirOrigin) {
  FrameStore store;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(2), {}, CancelToken()));
  const FramePointer frame = store.get(2);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->info.backend, backendName("auto"));
  EXPECT_EQ(frame->info.solverVersion, kSolverVersion);
  EXPECT_EQ(frame->info.seed, 1);
  EXPECT_EQ(frame->info.budget.get("emitted"), 100.0);
  EXPECT_GT(frame->info.timings.seconds("walk"), 0.0) << "a stage of the process";
  EXPECT_EQ(frame->info.key, store.keys()[2]);
}

TEST_F(Simulation, AShorterRunLeavesLaterFramesValid) {
  FrameStore store({folder.path("cache")});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(20), {}, CancelToken()));
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(5), {}, CancelToken()));
  EXPECT_EQ(store.state(15), FrameState::Ready);
  ASSERT_TRUE(store.purgeStale());
  EXPECT_TRUE(store.get(20));
  setProperty(scene.nodes[2], "seed", std::int64_t{2});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(5), {}, CancelToken()));
  EXPECT_EQ(store.state(15), FrameState::Stale) << "of another seed";
}

TEST_F(Simulation, FinishedFramesAreNotComputedAgain) {
  FrameStore store({folder.path("cache")});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(10), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 10);
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(10), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 10);
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(12), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 12) << "goes on from the last frame's state";
  EXPECT_EQ(behaviour().begins, 1);
}

TEST_F(Simulation, ContinuingAfterCancelGivesTheSameBytes) {
  const auto expected = test::referenceResults(scene, 15);
  for (const bool onDisk : {true, false}) {
    for (const int stopAt : {0, 1, 6, 7, 14}) {
      FrameStore store({onDisk ? folder.path("cache" + std::to_string(stopAt)) : ""});
      CancelToken cancel;
      RunCallbacks callbacks;
      callbacks.frameReady = [&](const FramePointer& frame) {
        if (frame->info.time.frame == stopAt) cancel.cancel();
      };
      const Status stopped = runSimulation(scene, store, test::testOptions(15), callbacks, cancel);
      ASSERT_FALSE(stopped);
      EXPECT_EQ(stopped.error().kind, ErrorKind::Cancelled);
      EXPECT_EQ(store.state(stopAt), FrameState::Ready);
      EXPECT_EQ(store.state(stopAt + 1), FrameState::Missing);
      behaviour().stepsDone = 0;
      ASSERT_TRUE(runSimulation(scene, store, test::testOptions(15), {}, CancelToken()));
      EXPECT_EQ(test::resultsOf(store, 15), expected) << stopAt;
      EXPECT_EQ(behaviour().stepsDone, 15 - stopAt) << "the cancelled run saved its last state";
    }
  }
}

TEST_F(Simulation, ACancelWithinAStepLosesOnlyThatStep) {
  const auto expected = test::referenceResults(scene, 5);
  FrameStore store({folder.path("cache")});
  behaviour().stepMilliseconds = 30;
  CancelToken cancel;
  RunCallbacks callbacks;
  int reports = 0;
  callbacks.progress = [&](const RunProgress& progress) {
    if (progress.frame == 3 && ++reports == 2) cancel.cancel();
  };
  behaviour().stepMilliseconds = 200;
  EXPECT_FALSE(runSimulation(scene, store, test::testOptions(5), callbacks, cancel));
  EXPECT_EQ(store.state(2), FrameState::Ready);
  EXPECT_EQ(store.state(3), FrameState::Missing);
  behaviour().stepMilliseconds = 0;
  behaviour().stepsDone = 0;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(5), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 3);
  EXPECT_EQ(test::resultsOf(store, 5), expected);
}

TEST_F(Simulation, AnEditRestartsAtTheCheckpointBeforeIt) {
  FrameStore store({folder.path("cache")});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(14), {}, CancelToken()));
  AnimationCurve& curve = scene.nodes[0].curves["wind_speed_m_s"];
  curve.setKey({0.0, 2.0, Interpolation::Step});
  curve.setKey({1.0, 6.0, Interpolation::Step});
  behaviour().stepsDone = 0;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(14), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 14 - 8) << "checkpoint 8 is the last before frame 10";
  EXPECT_EQ(test::resultsOf(store, 14), test::referenceResults(scene, 14));
}

TEST_F(Simulation, HolesAreFilledAndTheRestIsLeft) {
  const auto expected = test::referenceResults(scene, 13);
  {
    FrameStore store({folder.path("cache")});
    ASSERT_TRUE(runSimulation(scene, store, test::testOptions(13), {}, CancelToken()));
  }
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder.path("cache/frames")))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  fs::resize_file(files[2], 40);
  fs::remove(files[9]);
  test::LogCatcher log;
  FrameStore store({folder.path("cache")});
  behaviour().stepsDone = 0;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(13), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 2 + 1) << "0 to 2 from the start, 8 to 9 from a checkpoint";
  EXPECT_EQ(test::resultsOf(store, 13), expected);
}

TEST_F(Simulation, UnusableCheckpointsAreSkipped) {
  const auto expected = test::referenceResults(scene, 9);
  FrameStore store({folder.path("cache")});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(6), {}, CancelToken()));
  // Whole as files, but not a state that the processes accept.
  ASSERT_TRUE(store.putCheckpoint(6, store.keys()[6], {'x'}));
  ByteWriter foreign;
  foreign.put(std::string("walk"));
  foreign.putArray(std::vector<char>{1, 2, 3});
  ASSERT_TRUE(store.putCheckpoint(4, store.keys()[4], foreign.bytes()));
  test::LogCatcher log;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(9), {}, CancelToken()));
  EXPECT_EQ(test::resultsOf(store, 9), expected);
  EXPECT_NE(log.text().find("checkpoint of frame 6"), std::string::npos);
  EXPECT_NE(log.text().find("checkpoint of frame 4"), std::string::npos);
}

TEST_F(Simulation, ANonFiniteValueStopsTheRunAndNamesItsPlace) {
  FrameStore store({folder.path("cache")});
  behaviour().nanAtFrame = 5;
  const Status stopped = runSimulation(scene, store, test::testOptions(10), {}, CancelToken());
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Failed);
  EXPECT_EQ(stopped.error().where, "frame 5, process walk, part walkers");
  EXPECT_EQ(stopped.error().why, "height of particle 17 is nan");
  EXPECT_EQ(store.state(4), FrameState::Ready);
  EXPECT_EQ(store.state(5), FrameState::Missing);
  behaviour().nanAtFrame = -1;
  behaviour().stepsDone = 0;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(10), {}, CancelToken()));
  EXPECT_EQ(behaviour().stepsDone, 6) << "goes on from frame 4";
}

TEST_F(Simulation, ARunOverTheRamBudgetStillEnds) {
  FrameStore store({"", 3 * 80000});
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(10), {}, CancelToken()));
  EXPECT_EQ(store.state(10), FrameState::Ready);
  EXPECT_EQ(store.state(0), FrameState::Missing);
}

TEST_F(Simulation, ADiskThatRefusesEndsTheRun) {
  std::ofstream(folder.path("file")) << "in the way";
  test::LogCatcher log;
  FrameStore store({folder.path("file/cache")});
  EXPECT_FALSE(runSimulation(scene, store, test::testOptions(3), {}, CancelToken()));
}

TEST_F(Simulation, ProgressRisesToOneAndTellsTheTimeLeft) {
  FrameStore store;
  RunCallbacks callbacks;
  double last = 0.0;
  double left = -1.0;
  int frames = 0;
  callbacks.progress = [&](const RunProgress& progress) {
    EXPECT_GE(progress.fractionDone, last);
    last = progress.fractionDone;
    left = progress.secondsLeft;
    EXPECT_EQ(progress.lastFrame, 8);
  };
  callbacks.frameReady = [&](const FramePointer& frame) { EXPECT_EQ(frame->info.time.frame, frames++); };
  behaviour().stepMilliseconds = 5;
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(8), callbacks, CancelToken()));
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(left, 0.0);
  EXPECT_EQ(frames, 9);
}

TEST_F(Simulation, ProgressCountsTheFramesOfThisRunAlone) {
  FrameStore store({folder.path("cache")});
  RunCallbacks callbacks;
  int done = -1;
  callbacks.progress = [&](const RunProgress& progress) { done = progress.framesDone; };
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(3), callbacks, CancelToken()));
  EXPECT_EQ(done, 4);
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(8), callbacks, CancelToken()));
  EXPECT_EQ(done, 5) << "frames 0 to 3 were there";
}

TEST_F(Simulation, EstimateCountsWhatIsMissing) {
  FrameStore store({folder.path("cache")});
  const RunEstimate before = estimateRun(scene, store, test::testOptions(9));
  EXPECT_EQ(before.framesToCompute, 10);
  const double state = test::kWalkers * 12 + 24, frame = test::kWalkers * 16 + 72;
  EXPECT_DOUBLE_EQ(before.diskBytes, 10 * frame + 3 * state);
  EXPECT_DOUBLE_EQ(before.memoryBytes, 2 * state + 10 * frame);
  ASSERT_TRUE(runSimulation(scene, store, test::testOptions(4), {}, CancelToken()));
  EXPECT_EQ(estimateRun(scene, store, test::testOptions(9)).framesToCompute, 5);
  EXPECT_EQ(store.state(3), FrameState::Ready) << "asking changes nothing";
  FrameStore memory;
  EXPECT_EQ(estimateRun(scene, memory, test::testOptions(9)).diskBytes, 0.0);
}

TEST_F(Simulation, NonsenseIsRefused) {
  FrameStore store;
  EXPECT_EQ(runSimulation(scene, store, test::testOptions(-1), {}, CancelToken()).error().kind,
            ErrorKind::Usage);
  RunOptions options = test::testOptions(1);
  options.isa = "mmx";
  EXPECT_EQ(runSimulation(scene, store, options, {}, CancelToken()).error().kind, ErrorKind::Usage);
}

TEST_F(Simulation, AnEmptySceneGivesEmptyFrames) {
  FrameStore store;
  ASSERT_TRUE(runSimulation(SceneSnapshot{}, store, test::testOptions(3), {}, CancelToken()));
  EXPECT_TRUE(store.get(3)->parts.empty());
}

}  // namespace
}  // namespace spin
