// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/nodes/camera_node.h"
#include "tests/cli/program.h"

namespace spin {
namespace {

using test::dataFormats;
using test::filesBelow;
using test::joined;
using test::numberOf;
using test::runProgram;
using test::textOf;

class CliProgram : public ::testing::Test {
 protected:
  test::Outcome run(const std::vector<std::string>& arguments) {
    const test::Outcome outcome = runProgram(folder, arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    return outcome;
  }
  test::Folder folder;
  std::string scene = test::writeTinyScene(folder);
};

TEST_F(CliProgram, RunWritesNumberedFilesAndTheManifest) {
  run(joined({"run", scene, "--output", folder / "out", "--frames", "2:4"}, dataFormats()));
  const auto files = filesBelow(folder / "out");
  for (const char* name : {"particles/tiny.0002.ply", "particles/tiny.0004.ply", "paraview/tiny.0003.vtp",
                           "paraview/tiny.pvd", "manifest.json"})
    EXPECT_TRUE(files.count(name)) << name;
  EXPECT_FALSE(files.count("particles/tiny.0001.ply"));
  EXPECT_FALSE(files.count("particles/tiny.0005.ply"));
  const Result<JsonValue> manifest = parseJson(files.at("manifest.json"), "manifest");
  ASSERT_TRUE(manifest.ok());
  EXPECT_EQ(textOf(*manifest, "command"),
            "spindrift-cli run tiny.spindrift --frames 2:4 --format ply --format vtp --format cover_tif");
  std::size_t listed = 1;
  for (const JsonValue& output : manifest->find("outputs")->items)
    for (const JsonValue& file : output.find("files")->items) {
      ++listed;
      EXPECT_TRUE(files.count(textOf(output, "folder") + "/" + file.text)) << file.text;
    }
  EXPECT_EQ(listed, files.size()) << "the manifest names every file";
  EXPECT_EQ(manifest->find("place")->find("epsg")->number, 31287);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "tiny.cache"));
}

TEST_F(CliProgram, ThreadsDoNotChangeAByteOfTheOutput) {
  std::map<std::string, std::string> expected;
  for (const char* threads : {"1", "2", "4"}) {
    const std::string out = folder / (std::string("out") + threads);
    run(joined({"run", scene, "--threads", threads, "--cache", folder / (std::string("cache") + threads),
                "--output", out},
               dataFormats()));
    const auto files = filesBelow(out);
    if (expected.empty()) expected = files;
    EXPECT_GT(files.size(), 15u);
    EXPECT_EQ(files, expected) << threads;
  }
}

TEST_F(CliProgram, SetChangesTheRunAndNotTheFile) {
  const std::string before = test::readFile(scene);
  run({"run", scene, "--output", folder / "a", "--format", "cover_tif"});
  run({"run", scene, "--output", folder / "b", "--format", "cover_tif", "--set", "weather.wind_speed_m_s=8",
       "--set", "simulation.seed=5"});
  EXPECT_NE(filesBelow(folder / "a"), filesBelow(folder / "b"));
  EXPECT_EQ(test::readFile(scene), before);
  run({"run", scene, "--output", folder / "c", "--format", "cover_tif"});
  EXPECT_EQ(filesBelow(folder / "a"), filesBelow(folder / "c")) << "the first frames are still cached";
}

TEST_F(CliProgram, ProgressIsJsonLinesThatRiseToDone) {
  const auto lines = test::progressLines(
      run({"run", scene, "--output", folder / "out", "--format", "ply", "--progress", "json"}).out);
  ASSERT_GT(lines.size(), 10u);
  double last = 0.0;
  std::vector<std::string> stages;
  for (const JsonValue& line : lines) {
    EXPECT_GE(numberOf(line, "fraction"), last);
    last = numberOf(line, "fraction");
    if (stages.empty() || stages.back() != textOf(line, "stage")) stages.push_back(textOf(line, "stage"));
  }
  EXPECT_EQ(stages, (std::vector<std::string>{"load", "simulate", "export", "done"}));
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(numberOf(lines.back(), "files"), 6);
}

TEST_F(CliProgram, SimulateFillsTheCacheAndExportUsesIt) {
  const auto first = run({"simulate", scene});
  EXPECT_NE(first.out.find("6 simulated now"), std::string::npos) << first.out;
  const auto second = run({"export", scene, "--format", "vtp", "--output", folder / "out"});
  EXPECT_NE(second.out.find("0 simulated now"), std::string::npos) << second.out;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/particles"));
}

TEST_F(CliProgram, DamagedCacheFramesAreComputedAgain) {
  run({"export", scene, "--format", "ply", "--output", folder / "a"});
  for (const auto& entry : std::filesystem::directory_iterator(folder / "tiny.cache/frames")) {
    std::string bytes = test::readFile(entry.path().string());
    if (entry.path().filename().string()[5] == '3') bytes[bytes.size() / 2] ^= 1;
    if (entry.path().filename().string()[5] == '4') bytes.resize(bytes.size() / 3);
    test::writeFile(entry.path().string(), bytes);
  }
  const auto again = run({"export", scene, "--format", "ply", "--output", folder / "b"});
  EXPECT_EQ(filesBelow(folder / "a"), filesBelow(folder / "b"));
  EXPECT_NE(again.error.find("damaged"), std::string::npos) << "and the log says so";
}

TEST_F(CliProgram, InfoPrintsTheBudgetOfEveryFrame) {
  run({"simulate", scene});
  const Result<JsonValue> info = parseJson(run({"info", scene, "--json"}).out, "info");
  ASSERT_TRUE(info.ok()) << info.error().text();
  ASSERT_EQ(info->find("frames")->items.size(), 6u);
  for (const JsonValue& frame : info->find("frames")->items) {
    double sources = 0.0, sinks = 0.0;
    for (const auto& term : frame.find("sources_kg")->members) sources += term.value.number;
    for (const auto& term : frame.find("sinks_kg")->members) sinks += term.value.number;
    EXPECT_GT(sources, 0.0);
    EXPECT_NEAR(sinks, sources, 1e-6 * sources);
    EXPECT_LE(std::abs(numberOf(frame, "relative_imbalance")), 1e-6);
  }
  EXPECT_EQ(numberOf(*info->find("terrain"), "columns"), 10);
  EXPECT_EQ(numberOf(*info->find("cache"), "ready"), 6);
  const std::string text = run({"info", scene}).out;
  for (const char* word : {"node box: model, box.obj", "terrain: 10 x 8 cells of 5 m", "EPSG 31287",
                           "6 frames ready", "deposited", "frame 5 "})
    EXPECT_NE(text.find(word), std::string::npos) << word << "\n" << text;
}

TEST_F(CliProgram, ImportShowsTheFileAndAddsIt) {
  const auto seen = run({"import", folder / "hill.asc"});
  EXPECT_NE(seen.out.find("5 m"), std::string::npos) << seen.out;
  const std::string made = folder / "new.spindrift";
  run({"import", folder / "hill.asc", "--into", made, "--epsg", "31287"});
  const auto added = run({"import", folder / "box.obj", "--into", made, "--up", "z", "--unit-scale", "0.5"});
  EXPECT_NE(added.out.find("added node box"), std::string::npos) << added.out;
  const Result<LoadedScene> loaded = loadScene(made);
  ASSERT_TRUE(loaded.ok());
  const SceneNode* box = loaded->scene.find("box");
  ASSERT_TRUE(box);
  EXPECT_EQ(toText(plainValue(*box, *box->type->find("source"))), "box.obj");
  EXPECT_EQ(toText(plainValue(*box, *box->type->find("unit_m"))), "0.5");
  EXPECT_NE(run({"validate", made}).out.find("is fine"), std::string::npos);
}

TEST_F(CliProgram, ANewSceneSnowsOnAModelThatTheCameraSees) {
  const std::string made = folder / "new.spindrift";
  run({"import", folder / "hill.asc", "--into", made});
  run({"import", folder / "box.obj", "--into", made});
  run({"import", folder / "box.obj", "--into", made, "--name", "Other", "--position", "3 4 0.5"});
  const Result<LoadedScene> loaded = loadScene(made);
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(loaded->scene.firstOf(kSnowfallType));
  const auto* settings = loaded->scene.find("simulation")->as<SimulationNode>();
  ASSERT_TRUE(settings);
  EXPECT_GT(settings->timeScale, 100.0) << "the cover would not be seen to grow";
  const auto* camera = loaded->scene.find("camera")->as<CameraNode>();
  const auto* box = loaded->scene.find("box")->as<ModelNode>();
  const auto* other = loaded->scene.find("box_2")->as<ModelNode>();
  ASSERT_TRUE(camera && box && other);
  // The hill is 45 m x 35 m.
  EXPECT_NEAR(camera->target.x, 22.5, 5.0);
  EXPECT_NEAR(camera->target.y, 17.5, 5.0);
  EXPECT_GT(camera->position.z, camera->target.z + 5.0);
  EXPECT_NEAR(box->position.x, camera->target.x, 0.5);
  EXPECT_NEAR(box->position.y, camera->target.y, 0.5);
  EXPECT_EQ(other->position, (Vec3d{3, 4, 0.5}));
  const auto wrong = runProgram(folder, {"import", folder / "box.obj", "--into", made, "--position", "3,4"});
  EXPECT_EQ(wrong.code, 2) << wrong.error;
}

TEST_F(CliProgram, ImportCopiesWhatAModelRefersTo) {
  const test::Folder other;
  test::writeFile(folder / "hut.obj", "mtllib walls.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood\nf 1 2 3\n");
  test::writeFile(folder / "walls.mtl", "newmtl wood\nmap_Kd tex/wood.png\n");
  std::filesystem::create_directories(folder / "tex");
  test::writeFile(folder / "tex/wood.png", "a picture of another test");
  run({"import", folder / "hut.obj", "--into", other / "new.spindrift", "--copy"});
  for (const char* name : {"hut.obj", "walls.mtl", "tex/wood.png"})
    EXPECT_EQ(test::readFile((other / "new.assets/") + name), test::readFile(folder / name)) << name;
}

TEST_F(CliProgram, ImportFromElsewhereAsksForACopy) {
  const test::Folder other;
  const std::string made = other / "new.spindrift";
  const auto refused = runProgram(folder, {"import", folder / "box.obj", "--into", made});
  EXPECT_EQ(refused.code, 3);
  EXPECT_NE(refused.error.find("--copy"), std::string::npos) << refused.error;
  run({"import", folder / "box.obj", "--into", made, "--copy"});
  EXPECT_TRUE(std::filesystem::exists(other / "new.assets/box.obj"));
  EXPECT_EQ(run({"validate", made}).code, 0);
}

TEST_F(CliProgram, ARefusedImportLeavesNothingBehind) {
  const test::Folder other;
  const std::string made = other / "new.spindrift";
  const auto outside = runProgram(folder, {"import", folder / "hill.asc", "--into", made});
  EXPECT_EQ(outside.code, 3);
  EXPECT_EQ(outside.out.find("made "), std::string::npos) << outside.out;
  EXPECT_TRUE(filesBelow(other.path()).empty());
  EXPECT_NE(run({"import", folder / "hill.asc", "--into", made, "--copy"}).out.find("made "),
            std::string::npos);
  const auto before = filesBelow(other.path());
  std::filesystem::copy_file(folder / "hill.asc", folder / "second.asc");
  const auto second = runProgram(folder, {"import", folder / "second.asc", "--into", made, "--copy"});
  EXPECT_EQ(second.code, 3);
  EXPECT_EQ(filesBelow(other.path()), before);
}

TEST_F(CliProgram, AScenesNameEndsInSpindrift) {
  for (const char* name : {"scene.json", "scene"}) {
    const auto refused = runProgram(folder, {"import", folder / "hill.asc", "--into", folder / name});
    EXPECT_EQ(refused.code, 2) << refused.error;
    EXPECT_NE(refused.error.find(".spindrift"), std::string::npos) << refused.error;
    EXPECT_FALSE(std::filesystem::exists(folder / name));
  }
}

TEST_F(CliProgram, ACacheThatCannotBeWrittenIsToldBeforeAnythingIsComputed) {
  test::writeFile(folder / "file", "in the way");
  const auto outcome = runProgram(folder, {"simulate", scene, "--cache", folder / "file/cache"});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_NE(outcome.error.find("The cache folder cannot be written"), std::string::npos) << outcome.error;
  EXPECT_EQ((outcome.out + outcome.error).find("frame 1"), std::string::npos) << outcome.error;
}

TEST_F(CliProgram, AReadOnlyPlaceMovesTheCacheBelowTheOutput) {
  // Where a file stands in the way of the folder even root cannot make it.
  test::writeFile(folder / "tiny.cache", "in the way");
  const auto outcome = run({"export", scene, "--format", "ply", "--output", folder / "out"});
  EXPECT_NE(outcome.error.find("cannot be written; the cache goes to"), std::string::npos) << outcome.error;
  EXPECT_TRUE(std::filesystem::is_directory(folder / "out/tiny.cache/frames"));
}

}  // namespace
}  // namespace spin
