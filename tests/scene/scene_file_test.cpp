// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/scene_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/nodes/node_registry.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

namespace fs = std::filesystem;

const std::string kHead = "{\"format\": \"spindrift-scene\", \"schema\": 2, \"min_reader\": 2, ";

Result<LoadedScene> readNodes(const std::string& nodes) {
  return readSceneText(kHead + "\"nodes\": [" + nodes + "]}", "test");
}

std::string errorOf(const Result<LoadedScene>& loaded) {
  return loaded ? std::string("no error") : loaded.error().text();
}

/// A value that is not the default.
Value otherValue(const NodeType& type, const PropertyInfo& property) {
  const Value value = defaultValue(type, property);
  if (const auto* flag = std::get_if<bool>(&value)) return !*flag;
  if (const auto* integer = std::get_if<std::int64_t>(&value))
    return *integer == 0 ? *integer + 1 : *integer - 1;
  const double inside = property.min + 0.37 * (property.max - property.min);
  if (std::holds_alternative<double>(value)) return inside;
  if (std::holds_alternative<Vec3d>(value)) return Vec3d{inside, property.min, property.max};
  if (std::holds_alternative<PlanPoints>(value))
    return PlanPoints{{inside, 0.0}, {property.min, property.max}};
  return std::string("a \"b\" \u00e9 / c");
}

/// All types, every property changed, keys where it can be animated.
Scene fullScene() {
  Scene scene;
  for (const NodeType* type : nodeTypes()) {
    SceneNode node = makeNode(*type, std::string(type->id) + "_1", "N\u00e4me");
    node.enabled = false;
    for (const PropertyRow& row : type->properties) {
      setPlainValue(node, row, otherValue(*type, row));
      if (!row.animatable) continue;
      node.curves[row.id].setKey({0.25, defaultValue(*type, row), Interpolation::Smooth});
      node.curves[row.id].setKey({1.0 / 3.0, otherValue(*type, row), Interpolation::Step});
    }
    EXPECT_TRUE(scene.append(std::move(node)).ok());
  }
  return scene;
}

void expectSame(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.nodes().size(), b.nodes().size());
  for (std::size_t i = 0; i < a.nodes().size(); ++i) {
    const SceneNode &x = a.nodes()[i], &y = b.nodes()[i];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.enabled, y.enabled);
    EXPECT_EQ(x.curves, y.curves) << x.id;
    ASSERT_EQ(x.type, y.type);
    for (const PropertyRow& row : x.type->properties)
      EXPECT_EQ(plainValue(x, row), plainValue(y, row)) << x.id << "." << row.id;
  }
}

TEST(SceneFile, EveryPropertyAndKeyRoundTrips) {
  const Scene scene = fullScene();
  const std::string text = writeSceneText(scene);
  const Result<LoadedScene> loaded = readSceneText(text, "test");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  expectSame(scene, loaded->scene);
  EXPECT_EQ(writeSceneText(loaded->scene, loaded->extras), text) << "same scene, same text";
}

TEST(SceneFile, DefaultsAreNotWritten) {
  EXPECT_EQ(writeSceneText(makeDefaultScene()).find("properties"), std::string::npos);
}

TEST(SceneFile, HeadComesFirstAndOneValueStandsOnALine) {
  Scene scene = makeDefaultScene();
  ASSERT_TRUE(scene.setFromText("weather.wind_speed_m_s", "0.1").ok());
  ASSERT_TRUE(scene.setFromText("camera.position_m", "1 2.5 -3").ok());
  const std::string text = writeSceneText(scene);
  EXPECT_EQ(
      text.rfind(
          "{\n  \"format\": \"spindrift-scene\",\n  \"schema\": 2,\n  \"min_reader\": 2,\n  \"generator\": "
          "\"spindrift " SPIN_VERSION "\",\n  \"nodes\": [\n",
          0),
      0u)
      << text;
  EXPECT_NE(text.find("\n        \"wind_speed_m_s\": 0.1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n        \"position_m\": [1, 2.5, -3]\n"), std::string::npos) << text;
}

struct BadScene {
  const char* what;
  std::string nodes;
  const char* mustSay;
};

TEST(SceneFile, RefusesBadNodesInClearWords) {
  const std::string w = "{\"id\": \"w\", \"type\": \"weather\", \"properties\": ";
  const BadScene cases[] = {
      {"misspelt property", w + "{\"wind_sped_m_s\": 1}}", "\"wind_speed_m_s\""},
      {"misspelt type", "{\"id\": \"w\", \"type\": \"wether\"}", "\"weather\""},
      {"misspelt key", "{\"id\": \"w\", \"type\": \"weather\", \"enabeld\": true}", "\"enabled\""},
      {"text for a number", w + "{\"wind_speed_m_s\": \"2\"}}", "expected is a number, found a text"},
      {"out of range", w + "{\"wind_speed_m_s\": 81}}", "0 to 80"},
      {"huge number", w + "{\"wind_speed_m_s\": 1e999}}", "1e999"},
      {"NaN", w + "{\"wind_speed_m_s\": NaN}}", "line 1"},
      {"null", w + "{\"wind_speed_m_s\": null}}", "found null"},
      {"doubled key", w + "{\"cloud_cover\": 1, \"cloud_cover\": 0}}", "stands twice"},
      {"vector of two", "{\"id\": \"c\", \"type\": \"camera\", \"properties\": {\"position_m\": [1, 2]}}",
       "three numbers"},
      {"wrong choice", "{\"id\": \"g\", \"type\": \"ground_type\", \"properties\": {\"base\": \"rok\"}}",
       "\"rock\""},
      {"broken integer", "{\"id\": \"r\", \"type\": \"render\", \"properties\": {\"width_px\": 640.5}}",
       "whole number"},
      {"two of one id", "{\"id\": \"m\", \"type\": \"model\"}, {\"id\": \"m\", \"type\": \"model\"}",
       "the id is taken"},
      {"two weathers", "{\"id\": \"a\", \"type\": \"weather\"}, {\"id\": \"b\", \"type\": \"weather\"}",
       "at most"},
      {"bad id", "{\"id\": \"../a\", \"type\": \"weather\"}", "lower-case"},
      {"no id", "{\"type\": \"weather\"}", "id of a node is missing"},
      {"node is a number", "7", "found a number"},
      {"properties is a list", w + "[]}", "properties is no object"},
      {"keys out of order",
       w + "{\"cloud_cover\": {\"keys\": [{\"time_s\": 2, \"value\": 0}, {\"time_s\": 1, \"value\": 1}]}}}",
       "does not come after"},
      {"key without time", w + "{\"cloud_cover\": {\"keys\": [{\"value\": 0}]}}}", "time_s"},
      {"key out of range", w + "{\"cloud_cover\": {\"keys\": [{\"time_s\": 1, \"value\": 2}]}}}", "0 to 1"},
      {"keys empty", w + "{\"cloud_cover\": {\"keys\": []}}}", "at least one key"},
      {"unknown interpolation",
       w + "{\"cloud_cover\": {\"keys\": [{\"time_s\": 1, \"value\": 0, \"interpolation\": \"bezier\"}]}}}",
       "smooth"},
      {"animated although it cannot be",
       "{\"id\": \"s\", \"type\": \"simulation\", \"properties\": {\"seed\": {\"keys\": [{\"time_s\": 0, "
       "\"value\": 1}]}}}",
       "cannot be animated"},
  };
  for (const BadScene& bad : cases) {
    const std::string error = errorOf(readNodes(bad.nodes));
    EXPECT_NE(error.find(bad.mustSay), std::string::npos) << bad.what << ": " << error;
  }
}

TEST(SceneFile, TellsAllProblemsAtOnce) {
  const std::string error = errorOf(readNodes(
      "{\"id\": \"w\", \"type\": \"weather\", \"enabeld\": true, \"properties\": {\"wind_sped_m_s\": 1, "
      "\"cloud_cover\": 2, \"air_temperature_c\": -3}}, {\"id\": \"c\", \"type\": \"camra\"}"));
  for (const char* said :
       {"\"enabled\"", "\"wind_speed_m_s\"", "0 to 1", "\"air_temperature_k\"", "\"camera\""})
    EXPECT_NE(error.find(said), std::string::npos) << said << " in " << error;
  EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 4) << error;
  // A file full of them is cut short, and says so.
  std::string many;
  for (int k = 0; k < 50; ++k)
    many += fmt::format("{}{{\"id\": \"n{}\", \"type\": \"x\"}}", k ? ", " : "", k);
  EXPECT_NE(errorOf(readNodes(many)).find("30 more problems"), std::string::npos);
}

TEST(SceneFile, RefusesForeignAndNewerFiles) {
  EXPECT_NE(errorOf(readSceneText("{}", "f")).find("no Spindrift scene"), std::string::npos);
  EXPECT_NE(errorOf(readSceneText("PNG", "f")).find("JSON"), std::string::npos);
  EXPECT_NE(
      errorOf(readSceneText(
                  "{\"format\": \"spindrift-scene\", \"schema\": 9, \"min_reader\": 3, \"nodes\": []}", "f"))
          .find("newer version"),
      std::string::npos);
  EXPECT_FALSE(
      readSceneText("{\"format\": \"spindrift-scene\", \"min_reader\": 1, \"nodes\": []}", "f").ok());
  EXPECT_FALSE(
      readSceneText("{\"format\": \"spindrift-scene\", \"schema\": 0, \"min_reader\": 1, \"nodes\": []}", "f")
          .ok());
  EXPECT_FALSE(readSceneText(kHead + "\"nodes\": {}}", "f").ok());
  EXPECT_NE(errorOf(readSceneText(kHead + "\"node\": []}", "f")).find("\"nodes\""), std::string::npos);
  EXPECT_NE(errorOf(readSceneText(std::string(kMaxSceneBytes + 1, ' '), "f")).find("larger than"),
            std::string::npos);
}

TEST(SceneFile, KeepsWhatANewerVersionWrote) {
  const std::string text =
      "{\"format\": \"spindrift-scene\", \"schema\": 3, \"min_reader\": 2, \"nodes\": ["
      "{\"id\": \"weather\", \"type\": \"weather\", \"mood\": \"grim\", \"properties\": {\"fog_m\": [1, 2], "
      "\"cloud_cover\": 1}},"
      "{\"id\": \"river\", \"type\": \"river\", \"depth\": 3},"
      "{\"id\": \"camera\", \"type\": \"camera\"}], \"studio\": {\"name\": \"x\"}}";
  Result<LoadedScene> loaded = readSceneText(text, "f");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_EQ(loaded->scene.nodes().size(), 2u);
  ASSERT_TRUE(loaded->scene.setFromText("weather.wind_speed_m_s", "7").ok());
  const std::string saved = writeSceneText(loaded->scene, loaded->extras);
  for (const char* kept : {"\"schema\": 3", "\"mood\": \"grim\"", "\"fog_m\": [1, 2]", "\"river\"",
                           "\"depth\": 3", "\"studio\"", "\"wind_speed_m_s\": 7"})
    EXPECT_NE(saved.find(kept), std::string::npos) << kept << "\n" << saved;
  EXPECT_LT(saved.find("\"river\""), saved.find("\"id\": \"camera\"")) << "it stands where it stood";
  EXPECT_TRUE(readSceneText(saved, "f").ok());
}

TEST(SceneFile, MigratesSchemaOne) {
  const std::string text =
      "{\"format\": \"spindrift-scene\", \"schema\": 1, \"min_reader\": 1, \"nodes\": [{\"id\": \"weather\", "
      "\"type\": "
      "\"weather\", \"properties\": {\"precipitation_mm_h\": {\"value\": 7.2, \"keys\": [{\"time_s\": 0, "
      "\"value\": 3.6}]}}}]}";
  const Result<LoadedScene> loaded = readSceneText(text, "f");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const SceneNode& weather = *loaded->scene.find("weather");
  EXPECT_NEAR(weather.as<WeatherNode>()->precipitationRate, 0.002, 1e-15);
  EXPECT_NEAR(std::get<double>(weather.curves.at("precipitation_rate_kg_m2_s").at(0.0)), 0.001, 1e-15);
  EXPECT_EQ(loaded->extras.messages.size(), 1u);
  EXPECT_NE(
      errorOf(
          readNodes("{\"id\": \"w\", \"type\": \"weather\", \"properties\": {\"precipitation_mm_h\": 1}}"))
          .find("no property"),
      std::string::npos)
      << "schema 2 does not know the old name";
}

class SceneFolder : public testing::Test {
 protected:
  void SetUp() override {
    m_folder = fs::temp_directory_path() / ("spin_scene_" + std::to_string(::getpid()));
    fs::remove_all(m_folder);
    fs::create_directories(m_folder);
  }
  void TearDown() override { fs::remove_all(m_folder); }
  std::string path(const char* name) const { return (m_folder / name).string(); }
  static void write(const std::string& file, const std::string& text) { std::ofstream(file) << text; }
  static std::string read(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  fs::path m_folder;
};

TEST_F(SceneFolder, SavingOverAnOldSchemaKeepsIt) {
  const std::string old =
      "{\"format\": \"spindrift-scene\", \"schema\": 1, \"min_reader\": 1, \"nodes\": []}";
  write(path("a.spindrift"), old);
  const Result<LoadedScene> loaded = loadScene(path("a.spindrift"));
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  ASSERT_TRUE(saveScene(loaded->scene, loaded->extras, path("a.spindrift")).ok());
  EXPECT_EQ(read(path("a.schema1.bak")), old);
  EXPECT_NE(read(path("a.spindrift")).find("\"schema\": 2"), std::string::npos);
  ASSERT_TRUE(saveScene(loaded->scene, loaded->extras, path("a.spindrift")).ok());
  EXPECT_FALSE(fs::exists(path("a.schema2.bak"))) << "a current file needs no copy";
}

TEST_F(SceneFolder, AFailedSaveLeavesTheOldFile) {
  write(path("a.spindrift"), "precious");
  EXPECT_FALSE(saveScene(makeDefaultScene(), {}, path("none/a.spindrift")).ok());
  fs::create_directory(path("b.spindrift"));
  EXPECT_FALSE(saveScene(makeDefaultScene(), {}, path("b.spindrift")).ok());
  EXPECT_EQ(read(path("a.spindrift")), "precious");
  int files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(m_folder)) ++files;
  EXPECT_EQ(files, 2) << "no temporary file is left";
}

TEST_F(SceneFolder, LoadingRefusesFoldersAndMissingFiles) {
  EXPECT_FALSE(loadScene(path("none.spindrift")).ok());
  EXPECT_FALSE(loadScene(m_folder.string()).ok());
}

}  // namespace
}  // namespace spin
