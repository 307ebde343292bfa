// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "core/bench/bench_case.h"
#include "tests/cli/program.h"

namespace spin {
namespace {

class ExitCode : public ::testing::Test {
 protected:
  /// Runs and expects the code and a message on stderr.
  void expect(int code, const std::vector<std::string>& arguments, const std::string& message) {
    const test::Outcome outcome = test::runProgram(folder, arguments);
    EXPECT_EQ(outcome.code, code) << outcome.error;
    EXPECT_NE(outcome.error.find(message), std::string::npos) << outcome.error;
  }
  test::Folder folder;
  std::string scene = test::writeTinyScene(folder);
};

TEST_F(ExitCode, ZeroForHelpAndVersion) {
  EXPECT_EQ(test::runProgram(folder, {"--help"}).code, 0);
  EXPECT_EQ(test::runProgram(folder, {"run", "--help"}).code, 0);
  EXPECT_NE(test::runProgram(folder, {"--version"}).out.find("spindrift 0."), std::string::npos);
}

TEST_F(ExitCode, OneWhenTheRunFails) {
  test::writeFile(folder / "blocked", "a file, not a folder");
  expect(1, {"export", scene, "--format", "ply", "--output", folder / "blocked"}, "could not be made");
}

TEST_F(ExitCode, TwoForWrongUse) {
  expect(2, {}, "");
  expect(2, {"fly", scene}, "");
  expect(2, {"run"}, "SCENE");
  expect(2, {"run", scene, "--colour", "red"}, "--colour");
  expect(2, {"export", scene}, "--format");
  expect(2, {"run", scene, "--frames", "9:3"}, "9:3");
  expect(2, {"run", scene, "--device", "abacus"}, "abacus");
  expect(2, {"run", scene, "--set", "weather.wind=3"}, "wind_speed_m_s");
  expect(2, {"export", scene, "--format", "gif", "--output", folder / "out"}, "png8");
}

TEST_F(ExitCode, AnUnknownFormatOrCommandIsToldBeforeAnyWork) {
  const auto format = test::runProgram(folder, {"export", scene, "--format", "obj"});
  EXPECT_EQ(format.code, 2);
  EXPECT_EQ(format.error.find("frames to simulate"), std::string::npos) << format.error;
  EXPECT_NE(format.error.find("cover_tif"), std::string::npos) << format.error;
  const auto command = test::runProgram(folder, {"simulat", scene});
  EXPECT_EQ(command.code, 2);
  EXPECT_NE(command.error.find("simulate"), std::string::npos) << command.error;
}

TEST_F(ExitCode, BenchMeasuresTheExposureOfAScene) {
  const auto measured = test::runProgram(
      folder, {"bench", "exposure-raytraced", "--quick", "--scene", scene, "--json", folder / "rows.json"});
  EXPECT_EQ(measured.code, 0) << measured.out << measured.error;
  const auto rows = readBenchJson(test::readFile(folder / "rows.json"));
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  const auto found = std::find_if(rows->begin(), rows->end(), [](const BenchRow& r) {
    return r.settings.at("scene") == "tiny.spindrift" && r.settings.count("map_size") == 0;
  });
  ASSERT_NE(found, rows->end());
  const BenchRow& row = *found;
  std::map<std::string, BenchMetric> metrics(row.metrics.begin(), row.metrics.end());
  EXPECT_EQ(metrics.at("rmse").bar, 0.02);
  EXPECT_EQ(metrics.at("error_99th_percentile").bar, 0.08);
  EXPECT_EQ(metrics.at("points").value, 1000);
  EXPECT_GT(metrics.at("points_model").value, 100);
  EXPECT_GT(metrics.at("points_fine").value, 100);
  EXPECT_GT(metrics.at("rmse").value, 1e-4) << "two independent estimates never agree fully";
  EXPECT_EQ(test::runProgram(folder, {"bench", "mass", "--scene"}).code, 2);
  EXPECT_EQ(
      test::runProgram(folder, {"bench", "exposure-raytraced", "--quick", "--scene", "no.spindrift"}).code,
      1);
}

TEST_F(ExitCode, ThreeForBadFiles) {
  expect(3, {"run", folder / "none.spindrift"}, "none.spindrift");
  test::writeFile(folder / "cut.spindrift", test::readFile(scene).substr(0, 200));
  expect(3, {"run", folder / "cut.spindrift"}, "cut.spindrift");
  test::writeFile(folder / "text.spindrift", "hello");
  expect(3, {"validate", folder / "text.spindrift"}, "text.spindrift");
  expect(3, {"import", folder / "hill.xyzzy"}, "xyzzy");
  test::writeFile(folder / "text.asc", "ncols many\n");
  expect(3, {"import", folder / "text.asc"}, "text.asc");
  std::filesystem::remove(folder / "box.obj");
  expect(3, {"simulate", scene}, "node box");
}

TEST_F(ExitCode, ValidateNamesAllProblems) {
  std::filesystem::remove(folder / "box.obj");
  test::writeFile(folder / "hill.asc", "nonsense");
  const test::Outcome outcome =
      test::runProgram(folder, {"validate", scene, "--set", "simulation.first_frame=900"});
  EXPECT_EQ(outcome.code, 3);
  for (const char* line : {"error: box: ", "error: terrain: ", "error: simulation: "})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << outcome.out;
}

TEST_F(ExitCode, FourWhenTheDiskCannotHoldIt) {
  expect(4,
         {"render", scene, "--format", "exr", "--frames", "0:49999", "--set", "render.width_px=16384",
          "--set", "render.height_px=16384", "--output", folder / "out"},
         "does not fit on the disk");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/exr")) << "refused before anything is written";
}

TEST_F(ExitCode, FailuresAlsoEndTheJsonProgress) {
  const test::Outcome outcome =
      test::runProgram(folder, {"run", folder / "none.spindrift", "--progress", "json"});
  EXPECT_EQ(outcome.code, 3);
  const auto lines = test::progressLines(outcome.out);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(test::textOf(lines.back(), "stage"), "failed");
  EXPECT_EQ(test::numberOf(lines.back(), "exit_code"), 3);
  EXPECT_NE(test::textOf(lines.back(), "error").find("none.spindrift"), std::string::npos);
}

}  // namespace
}  // namespace spin
