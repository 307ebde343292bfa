// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/check.h"
#include "core/base/cpu_features.h"
#include "core/base/log.h"
#include "core/base/result.h"
#include "core/base/timings.h"
#include "core/base/units.h"

namespace spin {
namespace {

TEST(ResultTest, HoldsAValueOrAnError) {
  Result<int> good = 3;
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(*good, 3);
  const Result<int> bad = badInput("what", "where", "why");
  EXPECT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().kind, ErrorKind::BadInput);
}

TEST(ResultTest, TextNamesWhatWhereWhyAndAdvice) {
  const Error full = badInput("The file could not be read", "a.asc", "it ends early", "Export it again");
  EXPECT_EQ(full.text(), "The file could not be read (a.asc): it ends early. Export it again");
  const Error bare = {ErrorKind::Failed, "It failed", {}, {}, {}};
  EXPECT_EQ(bare.text(), "It failed");
}

TEST(ResultTest, MovesWhatCannotBeCopied) {
  Result<std::unique_ptr<int>> result = std::make_unique<int>(5);
  const std::unique_ptr<int> taken = std::move(result).value();
  EXPECT_EQ(*taken, 5);
}

TEST(ResultTest, ExitCodesAreThoseOfTheCommandLine) {
  EXPECT_EQ(exitCode(ErrorKind::Failed), 1);
  EXPECT_EQ(exitCode(ErrorKind::Usage), 2);
  EXPECT_EQ(exitCode(ErrorKind::BadInput), 3);
  EXPECT_EQ(exitCode(ErrorKind::OutOfResources), 4);
  EXPECT_EQ(exitCode(ErrorKind::Cancelled), 5);
}

TEST(ResultDeathTest, TakingTheValueOfAFailureStopsWithItsText) {
  const Result<int> bad = badInput("no snow", {}, "too warm");
  EXPECT_DEATH(static_cast<void>(bad.value()), "no snow: too warm");
  EXPECT_DEATH(static_cast<void>(Status().error()), "error\\(\\) of a successful status");
}

TEST(CheckDeathTest, PrintsBothValues) {
  const int wide = 3;
  EXPECT_DEATH(SPIN_CHECK_EQ(wide, 4), "wide == 4: 3 against 4");
  EXPECT_DEATH(SPIN_CHECK(wide < 0, "a message"), "wide < 0: a message");
}

TEST(CheckTest, PassesQuietlyAndEvaluatesOnce) {
  int calls = 0;
  SPIN_CHECK(++calls == 1, "once");
  SPIN_CHECK_LT(calls, 2);
  EXPECT_EQ(calls, 1);
}

TEST(LogTest, SinkGetsMessagesAtTheLevelAndAbove) {
  std::vector<std::string> seen;
  setLogSink([&](LogLevel, std::string_view text) { seen.emplace_back(text); });
  setLogLevel(LogLevel::Warning);
  logInfo("quiet");
  logWarning("loud");
  logError("louder");
  setLogLevel(LogLevel::Info);
  logInfo("now");
  setLogSink({});
  EXPECT_EQ(seen, (std::vector<std::string>{"loud", "louder", "now"}));
}

TEST(LogTest, DefaultSinkWritesToStderrOnly) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  logError("broken");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "spindrift: error: broken\n");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
}

TEST(TimingsTest, AddsByNameInOrderOfFirstUse) {
  StageTimings timings;
  timings.add("b", 1.0);
  timings.add("a", 2.0);
  timings.add("b", 0.5);
  const auto table = timings.table();
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].name, "b");
  EXPECT_EQ(table[0].calls, 2u);
  EXPECT_EQ(table[0].seconds, 1.5);
  EXPECT_EQ(timings.seconds("a"), 2.0);
  EXPECT_EQ(timings.seconds("none"), 0.0);
}

TEST(TimingsTest, MergeAddsCallsAndSeconds) {
  StageTimings a, b;
  a.add("x", 1.0);
  b.add("x", 1.0);
  b.add("x", 1.0);
  b.add("y", 4.0);
  a.merge(b);
  EXPECT_EQ(a.table()[0].calls, 3u);
  EXPECT_EQ(a.seconds("x"), 3.0);
  EXPECT_EQ(a.seconds("y"), 4.0);
  a.clear();
  EXPECT_TRUE(a.table().empty());
}

TEST(TimingsTest, ManyThreadsMayAdd) {
  StageTimings timings;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int k = 0; k < 1000; ++k) timings.add("x", 1.0);
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(timings.table()[0].calls, 4000u);
}

TEST(CancelTest, CopiesShareTheFlag) {
  const CancelToken token;
  const CancelToken copy = token;
  EXPECT_FALSE(copy.cancelled());
  token.cancel();
  EXPECT_TRUE(copy.cancelled());
  EXPECT_FALSE(CancelToken().cancelled());
}

TEST(UnitsTest, ConvertsThereAndBack) {
  EXPECT_DOUBLE_EQ(celsiusToKelvin(-10.0), 263.15);
  EXPECT_DOUBLE_EQ(kelvinToCelsius(celsiusToKelvin(12.5)), 12.5);
  EXPECT_DOUBLE_EQ(degreesToRadians(180.0), kPi);
  EXPECT_DOUBLE_EQ(radiansToDegrees(degreesToRadians(37.0)), 37.0);
  EXPECT_DOUBLE_EQ(millimetresPerHourToSi(3.6), 0.001);
  EXPECT_DOUBLE_EQ(siToMillimetresPerHour(millimetresPerHourToSi(5.0)), 5.0);
}

TEST(CpuFeaturesTest, ChoosesAmongWhatRuns) {
  EXPECT_TRUE(cpuRuns(Isa::Baseline));
  EXPECT_EQ(runnableIsas().front(), Isa::Baseline);
  const auto automatic = chooseIsa("auto");
  ASSERT_TRUE(automatic.ok());
  EXPECT_EQ(*automatic, bestIsa());
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    const auto chosen = chooseIsa(isaName(isa));
    ASSERT_EQ(chosen.ok(), cpuRuns(isa)) << isaName(isa);
    if (chosen.ok())
      EXPECT_EQ(*chosen, isa);
    else
      EXPECT_EQ(chosen.error().kind, ErrorKind::Failed);
  }
  EXPECT_EQ(chooseIsa("mmx").error().kind, ErrorKind::Usage);
}

}  // namespace
}  // namespace spin
