// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/particle_frames.h"
#include "tests/plugins/support.h"
#include "tests/plugins/vtp_reader.h"

namespace spin {
namespace {

using test::TempFolder;

class VtpExporterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    m_exporter = m_host.makeExporter("vtp");
    ASSERT_TRUE(m_exporter);
    ASSERT_TRUE(m_exporter->begin({test::sceneWithTerrain(), m_folder.path(), "kontertal", 0, 9}).ok());
  }

  PluginHost m_host;
  TempFolder m_folder;
  std::unique_ptr<CacheExporter> m_exporter;
};

TEST_F(VtpExporterTest, AllAttributesComeBack) {
  ASSERT_TRUE(m_exporter->writeFrame(test::flakeFrame(3, 5)).ok());
  const test::VtpFile file = test::readVtp(m_folder.file("kontertal.0003.vtp"));
  ASSERT_EQ(file.problem, "");
  ASSERT_EQ(file.points, 5u);
  ASSERT_EQ(file.arrays.at("Points").values.size(), 15u);
  EXPECT_EQ(file.arrays.at("Points").components, 3);
  EXPECT_EQ(file.arrays.at("Points").values[4], 2.5);
  EXPECT_EQ(file.arrays.at("id").values[2], 9.0);
  EXPECT_EQ(file.arrays.at("velocity").components, 3);
  EXPECT_EQ(file.arrays.at("velocity").values[5], -1.0);
  EXPECT_NEAR(file.arrays.at("size").values[4], 0.004, 1e-9);
  EXPECT_EQ(file.arrays.at("TimeValue").values, std::vector<double>{0.125});
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(file.arrays.at("connectivity").values.at(i), static_cast<double>(i));
    EXPECT_EQ(file.arrays.at("offsets").values.at(i), static_cast<double>(i + 1));
  }
}

TEST_F(VtpExporterTest, NoParticlesIsAValidFile) {
  ASSERT_TRUE(m_exporter->writeFrame(test::flakeFrame(0, 0)).ok());
  const test::VtpFile file = test::readVtp(m_folder.file("kontertal.0000.vtp"));
  EXPECT_EQ(file.problem, "");
  EXPECT_EQ(file.points, 0u);
  EXPECT_TRUE(file.arrays.at("Points").values.empty());
}

TEST_F(VtpExporterTest, CollectionListsTheFramesWithTheirFilmTimes) {
  for (const int frame : {0, 1, 2}) ASSERT_TRUE(m_exporter->writeFrame(test::flakeFrame(frame, 2)).ok());
  ASSERT_TRUE(m_exporter->finish().ok());
  EXPECT_EQ(m_exporter->files().back(), "kontertal.pvd");
  EXPECT_EQ(m_exporter->files().size(), 4u);
  const std::string pvd = test::readBytes(m_folder.file("kontertal.pvd"));
  EXPECT_NE(pvd.find("<VTKFile type=\"Collection\""), std::string::npos);
  std::vector<std::string> files;
  std::vector<double> times;
  for (std::size_t at = pvd.find("<DataSet"); at != std::string::npos; at = pvd.find("<DataSet", at + 1)) {
    const std::string element = pvd.substr(at, pvd.find("/>", at) - at);
    files.push_back(test::attributeOf(element, "file"));
    times.push_back(std::stod(test::attributeOf(element, "timestep")));
  }
  EXPECT_EQ(files,
            (std::vector<std::string>{"kontertal.0000.vtp", "kontertal.0001.vtp", "kontertal.0002.vtp"}));
  ASSERT_EQ(times.size(), 3u);
  EXPECT_NEAR(times[2], 2.0 / 24.0, 1e-9);
}

TEST_F(VtpExporterTest, NothingWrittenGivesNoCollection) {
  ASSERT_TRUE(m_exporter->finish().ok());
  EXPECT_TRUE(m_folder.names().empty());
}

}  // namespace
}  // namespace spin
