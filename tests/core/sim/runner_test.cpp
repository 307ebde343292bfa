// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/runner.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <future>

#include "tests/core/sim/test_processes.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

using test::behaviour;

class RunnerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    behaviour().nanAtFrame = -1;
    behaviour().stepMilliseconds = 0;
  }
  SnapshotPointer scene = std::make_shared<SceneSnapshot>(test::testScene());
  std::shared_ptr<FrameStore> store = std::make_shared<FrameStore>();
};

TEST_F(RunnerTest, RunsOffTheCallersThreadAtLowPriority) {
  Runner runner;
  std::promise<Status> result;
  std::atomic<int> priority{0};
  std::thread::id where;
  RunCallbacks callbacks;
  callbacks.frameReady = [&](const FramePointer&) {
    where = std::this_thread::get_id();
    priority = getpriority(PRIO_PROCESS, 0);
  };
  runner.start(scene, store, test::testOptions(5), callbacks,
               [&](const Status& status) { result.set_value(status); });
  EXPECT_TRUE(result.get_future().get().ok());
  EXPECT_NE(where, std::this_thread::get_id());
  EXPECT_GE(priority, 10);
  EXPECT_LT(getpriority(PRIO_PROCESS, 0), 10) << "the caller keeps its own";
  runner.wait();
  EXPECT_FALSE(runner.running());
  EXPECT_EQ(test::resultsOf(*store, 5), test::referenceResults(*scene, 5));
}

TEST_F(RunnerTest, CancelEndsTheRunWithinASecond) {
  behaviour().stepMilliseconds = 100000;
  Runner runner;
  std::promise<void> began;
  std::once_flag once;
  RunCallbacks callbacks;
  callbacks.progress = [&](const RunProgress& progress) {
    if (progress.frame == 1) std::call_once(once, [&] { began.set_value(); });
  };
  ErrorKind kind = ErrorKind::Failed;
  runner.start(scene, store, test::testOptions(5), callbacks,
               [&](const Status& status) { kind = status.error().kind; });
  began.get_future().wait();
  EXPECT_TRUE(runner.running());
  const auto start = std::chrono::steady_clock::now();
  runner.cancel();
  runner.wait();
  EXPECT_LT(std::chrono::steady_clock::now() - start, test::timeLimit(std::chrono::seconds(1)));
  EXPECT_EQ(kind, ErrorKind::Cancelled);
}

TEST_F(RunnerTest, ANewStartReplacesTheOldRunWithoutBlockingTheCaller) {
  behaviour().stepMilliseconds = 20;
  Runner runner;
  std::mutex mutex;
  std::vector<std::string> ends;
  const auto note = [&](const std::string& name) {
    return [&, name](const Status& status) {
      std::lock_guard lock(mutex);
      ends.push_back(name + (status.ok()                                   ? " done"
                             : status.error().kind == ErrorKind::Cancelled ? " cancelled"
                                                                           : " failed"));
    };
  };
  runner.start(scene, store, test::testOptions(1000), {}, note("a"));
  const auto start = std::chrono::steady_clock::now();
  runner.start(scene, store, test::testOptions(1000), {}, note("b"));
  behaviour().stepMilliseconds = 0;
  runner.start(scene, store, test::testOptions(6), {}, note("c"));
  EXPECT_LT(std::chrono::steady_clock::now() - start, test::timeLimit(std::chrono::milliseconds(500)));
  runner.wait();
  ASSERT_EQ(ends.size(), 3u) << "every start ends once";
  EXPECT_EQ(std::count(ends.begin(), ends.end(), "a cancelled"), 1);
  EXPECT_EQ(std::count(ends.begin(), ends.end(), "b cancelled"), 1);
  EXPECT_EQ(ends.back(), "c done");
  EXPECT_EQ(store->state(6), FrameState::Ready);
}

TEST_F(RunnerTest, TheDestructorCancels) {
  behaviour().stepMilliseconds = 100000;
  bool cancelled = false;
  {
    Runner runner;
    std::promise<void> began;
    std::once_flag once;
    RunCallbacks callbacks;
    callbacks.progress = [&](const RunProgress&) { std::call_once(once, [&] { began.set_value(); }); };
    runner.start(scene, store, test::testOptions(5), callbacks,
                 [&](const Status& status) { cancelled = !status.ok(); });
    began.get_future().wait();
  }
  EXPECT_TRUE(cancelled);
}

TEST_F(RunnerTest, FinishedMayStartTheNextRun) {
  Runner runner;
  std::promise<void> second;
  runner.start(scene, store, test::testOptions(2), {}, [&](const Status&) {
    runner.start(scene, store, test::testOptions(4), {}, [&](const Status&) { second.set_value(); });
  });
  second.get_future().wait();
  runner.wait();
  EXPECT_EQ(store->state(4), FrameState::Ready);
}

}  // namespace
}  // namespace spin
