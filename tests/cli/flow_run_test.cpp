// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/cli/program.h"

namespace spin {
namespace {

using test::filesBelow;
using test::numberOf;
using test::runProgram;

/// The example chute, coarse and short.
class CliFlow : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path scenes(SPIN_SOURCE_DIR "/resources/scenes");
    std::filesystem::copy(scenes / "chute.spindrift", folder / "chute.spindrift");
    std::filesystem::copy(scenes / "chute.assets", folder / "chute.assets");
  }
  std::vector<std::string> arguments(const std::string& command, const std::string& out) const {
    return {command,    folder / "chute.spindrift",
            "--frames", "0:5",
            "--output", folder / out,
            "--cache",  folder / (out + ".cache"),
            "--set",    "flow_settings.spacing_m=0.15",
            "--set",    "simulation.frame_rate=10"};
  }
  test::Outcome run(const std::vector<std::string>& words) {
    const test::Outcome outcome = runProgram(folder, words);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return outcome;
  }
  test::Folder folder;
};

TEST_F(CliFlow, TheChuteRunsAndItsParticlesAreExported) {
  const auto done = run(test::joined(arguments("run", "a"),
                                     {"--format", "ply", "--format", "vtp", "--part", "flow", "--timings"}));
  for (const char* stage : {"stage sort:", "stage shear rate:", "stage force:", "stage integrate:"})
    EXPECT_NE(done.out.find(stage), std::string::npos) << stage << "\n" << done.out;
  EXPECT_NE(done.error.find("particles; about"), std::string::npos) << done.error;
  const auto files = filesBelow(folder / "a");
  ASSERT_TRUE(files.count("particles/chute_flow.0005.ply") || files.count("particles/chute.0005.ply"));
  for (const auto& [name, content] : files) {
    if (name.find("0005.ply") == std::string::npos) continue;
    for (const char* attribute : {"velocity", "density", "pressure", "acceleration", "shear_rate",
                                  "viscosity", "age", "neighbours", "material", "class"})
      EXPECT_NE(content.find(attribute), std::string::npos) << attribute;
  }
}

TEST_F(CliFlow, InfoTellsTheFiguresAndTheBudget) {
  run(arguments("simulate", "a"));
  const Result<JsonValue> info = parseJson(
      run({"info", folder / "chute.spindrift", "--json", "--frames", "0:5", "--cache", folder / "a.cache",
           "--set", "flow_settings.spacing_m=0.15", "--set", "simulation.frame_rate=10"})
          .out,
      "info");
  ASSERT_TRUE(info.ok()) << info.error().text();
  ASSERT_EQ(info->find("frames")->items.size(), 6u);
  const JsonValue& last = info->find("frames")->items.back();
  EXPECT_GT(numberOf(*last.find("figures"), "flow_particles"), 200.0);
  EXPECT_GT(numberOf(*last.find("figures"), "flow_max_speed_m_s"), 0.5);
  EXPECT_GT(numberOf(*last.find("sources_kg"), "flow_released"), 100.0);
  EXPECT_LE(std::abs(numberOf(last, "relative_imbalance")), 1e-12);
}

TEST_F(CliFlow, ThreadsDoNotChangeAByte) {
  const std::vector<std::string> ply{"--format", "ply"};
  run(test::joined(test::joined(arguments("run", "a"), ply), {"--threads", "1"}));
  run(test::joined(test::joined(arguments("run", "b"), ply), {"--threads", "4"}));
  auto a = filesBelow(folder / "a"), b = filesBelow(folder / "b");
  EXPECT_GT(a.size(), 6u);
  EXPECT_EQ(a, b);
}

TEST_F(CliFlow, ValidateNamesWhatIsWrong) {
  const auto told = [&](const std::string& assignment) {
    const auto outcome = runProgram(folder, {"validate", folder / "chute.spindrift", "--set", assignment});
    return outcome.out + outcome.error;
  };
  EXPECT_NE(told("slab.outline_m=100 100; 101 100; 101 101").find("slab"), std::string::npos);
  EXPECT_NE(told("slab.outline_m=100 100; 101 100; 101 101").find("lies on the terrain"), std::string::npos);
  EXPECT_NE(told("slab.outline_m=1 1; 2 2; 2 1; 1 2").find("crosses itself"), std::string::npos);
  EXPECT_NE(told("flow_settings.spacing_m=0.5").find("spacings deep"), std::string::npos);
  EXPECT_NE(told("slab.material=custom").find("custom_material"), std::string::npos);
  EXPECT_NE(told("slab.depth_m=0.6").find("is fine"), std::string::npos) << told("slab.depth_m=0.6");
}

}  // namespace
}  // namespace spin
