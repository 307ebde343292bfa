// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <map>

#include "tests/plugins/particle_frames.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

/// A reader as strict as the format's description: known types only, exactly as many bytes as promised.
struct PlyFile {
  std::size_t count = 0;
  std::vector<std::string> comments;
  std::map<std::string, std::vector<double>> columns;
};

void readRows(const std::string& bytes, std::size_t at,
              const std::vector<std::pair<std::string, std::string>>& properties, PlyFile& file) {
  ASSERT_EQ(bytes.size() - at, file.count * properties.size() * 4) << "wrong size";
  for (std::size_t i = 0; i < file.count; ++i)
    for (const auto& [type, name] : properties) {
      if (type == "float") {
        float v = 0.0f;
        std::memcpy(&v, bytes.data() + at, 4);
        file.columns[name].push_back(static_cast<double>(v));
      } else {
        std::uint32_t v = 0;
        std::memcpy(&v, bytes.data() + at, 4);
        file.columns[name].push_back(v);
      }
      at += 4;
    }
}

PlyFile readPly(const std::string& path) {
  const std::string bytes = test::readBytes(path);
  const std::size_t end = bytes.find("end_header\n");
  PlyFile file;
  EXPECT_NE(end, std::string::npos);
  std::istringstream lines(bytes.substr(0, end));
  std::vector<std::pair<std::string, std::string>> properties;
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "ply");
  std::getline(lines, line);
  EXPECT_EQ(line, "format binary_little_endian 1.0");
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word, type, name;
    words >> word;
    if (word == "comment") {
      file.comments.push_back(line.substr(8));
    } else if (word == "element") {
      words >> name >> file.count;
      EXPECT_EQ(name, "vertex");
    } else {
      EXPECT_EQ(word, "property") << line;
      words >> type >> name;
      EXPECT_TRUE(type == "float" || type == "uint") << line;
      properties.emplace_back(type, name);
      file.columns[name];
    }
  }
  readRows(bytes, end + 11, properties, file);
  return file;
}

class PlyExporterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    m_exporter = m_host.makeExporter("ply");
    ASSERT_TRUE(m_exporter);
    ASSERT_TRUE(m_exporter->begin({test::sceneWithTerrain(), m_folder.path(), "kontertal", 0, 9}).ok());
  }

  PluginHost m_host;
  TempFolder m_folder;
  std::unique_ptr<CacheExporter> m_exporter;
};

TEST_F(PlyExporterTest, AllAttributesComeBack) {
  const Frame frame = test::flakeFrame(3, 5);
  ASSERT_TRUE(m_exporter->applies(frame));
  ASSERT_TRUE(m_exporter->writeFrame(frame).ok());
  ASSERT_TRUE(m_exporter->finish().ok());
  EXPECT_EQ(m_exporter->files(), std::vector<std::string>{"kontertal.0003.ply"});
  const PlyFile file = readPly(m_folder.file("kontertal.0003.ply"));
  ASSERT_EQ(file.count, 5u);
  EXPECT_EQ(file.columns.size(), 8u);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto v = static_cast<double>(i);
    EXPECT_EQ(file.columns.at("x")[i], v);
    EXPECT_EQ(file.columns.at("y")[i], 2 * v + 0.5);
    EXPECT_EQ(file.columns.at("z")[i], -v);
    EXPECT_EQ(file.columns.at("id")[i], v + 7);
    EXPECT_NEAR(file.columns.at("scalar_velocity_x")[i], 0.1 * v, 1e-6);
    EXPECT_EQ(file.columns.at("scalar_velocity_z")[i], -1.0);
    EXPECT_NEAR(file.columns.at("scalar_size")[i], 0.001 * v, 1e-9);
  }
  EXPECT_TRUE(test::mentions(file.comments, "unit velocity m/s"));
  EXPECT_TRUE(test::mentions(file.comments, "time_film_s 0.125 time_weather_s 360"));
  EXPECT_TRUE(test::mentions(file.comments, "weight 12.5"));
  EXPECT_TRUE(
      test::mentions(file.comments, "local_origin 176975.936800 376240.335200 1000.000000 epsg 31287"));
  const auto attributes = m_exporter->attributes();
  ASSERT_EQ(attributes.size(), 4u);
  EXPECT_EQ(attributes[2].name, "velocity");
  EXPECT_EQ(attributes[2].unit, "m/s");
  EXPECT_EQ(attributes[2].components, 3);
}

TEST_F(PlyExporterTest, NoParticlesIsAValidFile) {
  ASSERT_TRUE(m_exporter->writeFrame(test::flakeFrame(0, 0)).ok());
  EXPECT_EQ(readPly(m_folder.file("kontertal.0000.ply")).count, 0u);
}

TEST_F(PlyExporterTest, LargeIdsKeepAllTheirBits) {
  const std::uint64_t first = (std::uint64_t{5} << 32) + 9;
  ASSERT_TRUE(m_exporter->writeFrame(test::flakeFrame(1, 2, first)).ok());
  const PlyFile file = readPly(m_folder.file("kontertal.0001.ply"));
  EXPECT_EQ(file.columns.at("id")[1], 10.0);
  EXPECT_EQ(file.columns.at("id_high")[1], 5.0);
}

TEST_F(PlyExporterTest, OtherSetsGetTheirOwnFiles) {
  Frame frame = test::flakeFrame(1, 2);
  frame.parts["spray"] = frame.parts["flakes"];
  ASSERT_TRUE(m_exporter->writeFrame(frame).ok());
  EXPECT_EQ(m_exporter->files(),
            (std::vector<std::string>{"kontertal.0001.ply", "kontertal_spray.0001.ply"}));
}

TEST_F(PlyExporterTest, FramesWithoutParticlesAreNotItsBusiness) {
  EXPECT_FALSE(m_exporter->applies(Frame{}));
}

TEST_F(PlyExporterTest, UnfitArraysAndFoldersAreErrors) {
  const Frame sound = test::flakeFrame(1, 4);
  auto part = std::make_shared<ParticlePart>(*sound.part<ParticlePart>("flakes"));
  part->particles.attributes[0].values.pop_back();
  Frame frame;
  frame.parts["flakes"] = part;
  EXPECT_FALSE(m_exporter->writeFrame(frame).ok());
  ASSERT_TRUE(m_exporter->begin({nullptr, m_folder.file("no/such"), "a", 0, 1}).ok());
  EXPECT_FALSE(m_exporter->writeFrame(sound).ok());
  EXPECT_TRUE(m_exporter->files().empty());
  EXPECT_TRUE(m_folder.names().empty());
}

}  // namespace
}  // namespace spin
