// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

class Cancel : public ::testing::Test {
 protected:
  std::vector<std::string> arguments(const std::string& name, int last) {
    return test::joined({"run", scene, "--frames", "0:" + std::to_string(last), "--cache",
                         folder / (name + ".cache"), "--output", folder / name, "--progress", "json"},
                        test::dataFormats());
  }
  std::map<std::string, std::string> uninterrupted(int last) {
    EXPECT_EQ(test::runProgram(folder, arguments("whole", last)).code, 0);
    return test::filesBelow(folder / "whole");
  }
  test::Folder folder;
  std::string scene = test::writeTinyScene(folder);
};

TEST_F(Cancel, SignalsEndTheRunCleanlyWithinASecond) {
  for (const int number : {SIGINT, SIGTERM}) {
    test::Program program(folder, arguments("long" + std::to_string(number), 100000));
    ASSERT_TRUE(program.waitFor("\"frame\":3,"));
    const auto start = std::chrono::steady_clock::now();
    program.kill(number);
    EXPECT_EQ(program.wait(), 5);
    EXPECT_LT(std::chrono::steady_clock::now() - start, test::timeLimit(std::chrono::seconds(1)));
    const auto lines = test::progressLines(program.out());
    EXPECT_EQ(test::textOf(lines.back(), "stage"), "failed");
    EXPECT_EQ(test::numberOf(lines.back(), "exit_code"), 5);
  }
}

TEST_F(Cancel, ContinuingGivesTheFilesOfAnUninterruptedRun) {
  constexpr int kLast = 30;
  const auto expected = uninterrupted(kLast);
  for (const int number : {SIGINT, SIGKILL}) {
    const std::string name = "stopped" + std::to_string(number);
    {
      test::Program program(folder, arguments(name, kLast));
      ASSERT_TRUE(program.waitFor("\"frame\":7,"));
      program.kill(number);
      EXPECT_NE(program.wait(), 0);
    }
    const test::Outcome outcome = test::runProgram(folder, arguments(name, kLast));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    EXPECT_EQ(test::filesBelow(folder / name), expected) << number;
  }
}

TEST_F(Cancel, StoppedWhileExportingLeavesOnlyWholeFiles) {
  constexpr int kLast = 60;
  const auto expected = uninterrupted(kLast);
  std::filesystem::rename(folder / "whole.cache", folder / "part.cache");
  test::Program program(folder, arguments("part", kLast));
  ASSERT_TRUE(program.waitFor("\"stage\":\"export\",\"frame\":5,"));
  program.kill(SIGINT);
  EXPECT_EQ(program.wait(), 5);
  const auto files = test::filesBelow(folder / "part");
  EXPECT_GT(files.size(), 5u);
  EXPECT_LT(files.size(), expected.size());
  for (const auto& [name, bytes] : files) {
    if (name.ends_with(".pvd")) continue;  // an index names what is there so far
    ASSERT_TRUE(expected.count(name)) << name;
    EXPECT_EQ(bytes, expected.at(name)) << name;
  }
}

}  // namespace
}  // namespace spin
