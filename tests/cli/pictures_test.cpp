// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/cli/program.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

class Pictures : public ::testing::Test {
 protected:
  std::map<std::string, std::string> render(const std::string& out, std::vector<std::string> more) {
    const auto outcome =
        test::runProgram(folder, test::joined({"render", scene, "--output", folder / out}, more));
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return test::filesBelow(folder / out);
  }
  test::Folder folder;
  std::string scene = test::writeTinyScene(folder);
};

TEST_F(Pictures, NeedNoDisplayAndAreTheSameEveryTime) {
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  const auto first = render("a", {"--frames", "0:2"});
  ASSERT_TRUE(first.count("images/tiny.0002.png"));
  EXPECT_EQ(first.at("images/tiny.0002.png").substr(1, 3), "PNG");
  EXPECT_NE(first.at("images/tiny.0000.png"), first.at("images/tiny.0002.png")) << "the flakes move";
  EXPECT_EQ(render("b", {"--frames", "0:2", "--threads", "1", "--cache", folder / "other.cache"}), first);
}

TEST_F(Pictures, ComeInEveryImageFormatOfTheJob) {
  const auto files =
      render("a", {"--frames", "1", "--format", "png8", "--format", "png16", "--format", "exr"});
  for (const char* name : {"images/tiny.0001.png", "png16/tiny.0001.png", "exr/tiny.0001.exr"})
    EXPECT_TRUE(files.count(name)) << name;
}

TEST_F(Pictures, CarryTheCreditUnlessSwitchedOff) {
  const auto with = render("a", {"--frames", "1"});
  const auto without = render("b", {"--frames", "1", "--set", "render.show_caption=false"});
  EXPECT_NE(with.at("images/tiny.0001.png"), without.at("images/tiny.0001.png"));
}

TEST_F(Pictures, ACancelDoesNotWaitForAHugePicture) {
  test::Program program(folder,
                        {"run", scene, "--frames", "0:3", "--format", "vtp", "--format", "png8", "--output",
                         folder / "a", "--progress", "json", "--set", "render.width_px=7000", "--set",
                         "render.height_px=5000", "--set", "render.samples=8"});
  ASSERT_TRUE(program.waitFor("\"stage\":\"export\""));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto start = std::chrono::steady_clock::now();
  program.kill(SIGTERM);
  EXPECT_EQ(program.wait(), 5);
  EXPECT_LT(std::chrono::steady_clock::now() - start, test::timeLimit(std::chrono::milliseconds(1500)));
  EXPECT_EQ(test::numberOf(test::progressLines(program.out()).back(), "exit_code"), 5);
  const auto files = test::filesBelow(folder / "a");
  EXPECT_TRUE(files.count("paraview/tiny.pvd")) << "indexes are closed all the same";
  for (const auto& [name, bytes] : files) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

TEST_F(Pictures, SayThatMissingFramesAreSimulated) {
  const auto outcome = test::runProgram(folder, {"render", scene, "--frames", "1", "--output", folder / "a"});
  EXPECT_NE(outcome.error.find("2 frames to simulate"), std::string::npos) << outcome.error;
  const auto again = test::runProgram(folder, {"render", scene, "--frames", "1", "--output", folder / "a"});
  EXPECT_NE(again.error.find("0 frames to simulate"), std::string::npos) << again.error;
}

}  // namespace
}  // namespace spin
