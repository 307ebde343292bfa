// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <cmath>

#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

/// A terrain of 4 x 3 cells of 5 m; cell (1, 1) is replaced by a fine grid of 4 x 4 cells, (3, 2) is a hole
/// and a model's patch lies about.
struct CoverScene {
  SnapshotPointer scene;
  Frame frame;
  double mass = 0.0;  ///< kg on the terrain
};

CoverGrid grid(const std::string& id, const Raster<float>& base, float area) {
  return {id, id.substr(0, id.find('/')), base, base.sameShape<float>(area)};
}

CoverScene makeCover() {
  CoverScene out;
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(4, 3, 0.0, 0.0, 5.0, 10.0f);
  terrain->geo = {{176975.9368, 376240.3352, 1000.0}, 31287, ""};
  terrain->credit = "Data: Land Tirol";
  auto scene = std::make_shared<SceneSnapshot>();
  scene->terrain = terrain;
  out.scene = scene;

  auto layout = std::make_shared<CoverLayout>();
  CoverGrid coarse = grid("terrain", terrain->heights, 25.0f);
  coarse.area.at(0, 0) = 6.25f;  // a corner: a quarter of a quad
  coarse.area.at(1, 1) = 0.0f;
  coarse.base.at(3, 2) = std::nanf("");
  layout->grids = {coarse, grid("terrain/fine0", Raster<float>(4, 4, 3.125, 3.125, 1.25, 10.0f), 1.5625f),
                   grid("hut/0", Raster<float>(2, 2, 5.0, 5.0, 0.5, 1.0f), 0.25f)};
  layout->grids[1].area.at(3, 3) = 0.0f;  // under the hut

  auto part = std::make_shared<CoverPart>();
  part->layout = layout;
  for (std::size_t g = 0; g < layout->grids.size(); ++g) {
    CoverPart::Values values;
    for (std::size_t c = 0; c < layout->grids[g].base.size(); ++c) {
      const float swe = 10.0f * static_cast<float>(g + 1) + static_cast<float>(c);
      values.swe.push_back(swe);
      values.depth.push_back(swe / 80.0f);
      values.liquid.push_back(0.1f * swe);
      values.temperature.push_back(273.15f - 0.5f * static_cast<float>(c));
      if (g < 2 && !std::isnan(layout->grids[g].base.values[c]))
        out.mass += static_cast<double>(swe) * static_cast<double>(layout->grids[g].area.values[c]);
    }
    part->values.push_back(values);
  }
  out.frame.info.time = {12, 0.5, 1440.0};
  out.frame.parts["cover"] = part;
  return out;
}

std::vector<float> readBand(GDALDataset& file, int band) {
  std::vector<float> values(12);
  EXPECT_EQ(file.GetRasterBand(band)->RasterIO(GF_Read, 0, 0, 4, 3, values.data(), 4, 3, GDT_Float32, 0, 0,
                                               nullptr),
            CE_None);
  return values;
}

class CoverExporterTest : public ::testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    m_exporter = m_host.makeExporter("cover_tif");
    ASSERT_TRUE(m_exporter);
    ASSERT_TRUE(m_exporter->begin({m_cover.scene, m_folder.path(), "cover", 0, 20}).ok());
  }

  PluginHost m_host;
  TempFolder m_folder;
  CoverScene m_cover = makeCover();
  std::unique_ptr<CacheExporter> m_exporter;
};

TEST_F(CoverExporterTest, LiesOnTheTerrainsCellsInTheWorld) {
  ASSERT_TRUE(m_exporter->applies(m_cover.frame));
  const Status status = m_exporter->writeFrame(m_cover.frame);
  ASSERT_TRUE(status.ok()) << status.error().text();
  EXPECT_EQ(m_exporter->files(), std::vector<std::string>{"cover.0012.tif"});
  EXPECT_EQ(m_folder.names(), std::vector<std::string>{"cover.0012.tif"});
  auto* file = static_cast<GDALDataset*>(GDALOpen(m_folder.file("cover.0012.tif").c_str(), GA_ReadOnly));
  ASSERT_NE(file, nullptr);
  double t[6];
  ASSERT_EQ(file->GetGeoTransform(t), CE_None);
  EXPECT_DOUBLE_EQ(t[0], 176975.9368 - 2.5);
  EXPECT_DOUBLE_EQ(t[3], 376240.3352 + 12.5);
  EXPECT_EQ(t[1], 5.0);
  EXPECT_EQ(t[5], -5.0);
  EXPECT_STREQ(file->GetSpatialRef()->GetAuthorityCode(nullptr), "31287");
  EXPECT_EQ(file->GetRasterCount(), 4);
  EXPECT_STREQ(file->GetRasterBand(1)->GetDescription(), "snow depth");
  EXPECT_STREQ(file->GetRasterBand(1)->GetUnitType(), "m");
  EXPECT_STREQ(file->GetRasterBand(2)->GetUnitType(), "kg/m2");
  EXPECT_STREQ(file->GetRasterBand(3)->GetUnitType(), "kg/m2");
  EXPECT_STREQ(file->GetRasterBand(4)->GetUnitType(), "K");
  EXPECT_EQ(file->GetRasterBand(2)->GetNoDataValue(), -9999.0);
  EXPECT_STREQ(file->GetMetadataItem("TIME_WEATHER_S"), "1440");
  EXPECT_STREQ(file->GetMetadataItem("TIFFTAG_COPYRIGHT"), "Data: Land Tirol");
  GDALClose(file);
}

TEST_F(CoverExporterTest, HoldsTheTerrainsWholeMass) {
  ASSERT_TRUE(m_exporter->writeFrame(m_cover.frame).ok());
  auto* file = static_cast<GDALDataset*>(GDALOpen(m_folder.file("cover.0012.tif").c_str(), GA_ReadOnly));
  ASSERT_NE(file, nullptr);
  const std::vector<float> depth = readBand(*file, 1), swe = readBand(*file, 2);
  GDALClose(file);
  // Row 0 of the file is the northern one.
  const auto at = [](int i, int j) { return static_cast<std::size_t>((2 - j) * 4 + i); };
  EXPECT_EQ(swe[at(3, 2)], -9999.0f);
  EXPECT_EQ(depth[at(3, 2)], -9999.0f);
  EXPECT_EQ(swe[at(2, 0)], 12.0f);
  // The replaced cell: the mean over 15 fine cells of 20 + c, the 16th does not count.
  EXPECT_NEAR(swe[at(1, 1)], 20.0 + 105.0 / 15.0, 1e-4);
  EXPECT_NEAR(depth[at(1, 1)], (20.0 + 7.0) / 80.0, 1e-5);
  double mass = 0.0;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 4; ++i) {
      if (i == 3 && j == 2) continue;
      const double area = i == 0 && j == 0 ? 6.25 : i == 1 && j == 1 ? 15 * 1.5625 : 25.0;
      mass += area * static_cast<double>(swe[at(i, j)]);
    }
  EXPECT_NEAR(mass / m_cover.mass, 1.0, 1e-6);
}

TEST_F(CoverExporterTest, HoldsWaterAndTemperatureWhereTheFrameHasThem) {
  const auto at = [](int i, int j) { return static_cast<std::size_t>((2 - j) * 4 + i); };
  const auto bands = [&] {
    EXPECT_TRUE(m_exporter->writeFrame(m_cover.frame).ok());
    auto* file = static_cast<GDALDataset*>(GDALOpen(m_folder.file("cover.0012.tif").c_str(), GA_ReadOnly));
    auto read = std::make_pair(readBand(*file, 3), readBand(*file, 4));
    GDALClose(file);
    return read;
  };
  const auto [water, temperature] = bands();
  EXPECT_NEAR(water[at(2, 0)], 1.2, 1e-5);
  EXPECT_NEAR(temperature[at(2, 0)], 272.15, 1e-3);
  EXPECT_NEAR(water[at(1, 1)], 2.7, 1e-4) << "the mean over the fine cells";
  EXPECT_NEAR(temperature[at(1, 1)], 273.15 - 0.5 * 7.0, 1e-3);
  EXPECT_EQ(water[at(3, 2)], -9999.0f);
  auto part = std::make_shared<CoverPart>(*m_cover.frame.part<CoverPart>("cover"));
  for (CoverPart::Values& values : part->values) values.liquid.clear(), values.temperature.clear();
  m_cover.frame.parts["cover"] = part;
  const auto [noWater, noTemperature] = bands();
  EXPECT_EQ(noWater[at(2, 0)], -9999.0f);
  EXPECT_EQ(noTemperature[at(1, 1)], -9999.0f);
}

TEST_F(CoverExporterTest, FineCellsBesideTheirCoarseCellLoseNothing) {
  // Shifted by a third of a cell: fine cells fall into four coarse ones.
  auto part = std::make_shared<CoverPart>(*m_cover.frame.part<CoverPart>("cover"));
  auto layout = std::make_shared<CoverLayout>(*part->layout);
  layout->grids[1].base.originX += 1.7;
  layout->grids[1].base.originY += 1.7;
  part->layout = layout;
  m_cover.frame.parts["cover"] = part;
  ASSERT_TRUE(m_exporter->writeFrame(m_cover.frame).ok());
  auto* file = static_cast<GDALDataset*>(GDALOpen(m_folder.file("cover.0012.tif").c_str(), GA_ReadOnly));
  ASSERT_NE(file, nullptr);
  const std::vector<float> swe = readBand(*file, 2);
  GDALClose(file);
  std::vector<double> area(12);
  for (std::size_t c = 0; c < 12; ++c)
    area[c] = std::isnan(layout->grids[0].base.values[c])
                  ? 0.0
                  : static_cast<double>(layout->grids[0].area.values[c]);
  const Raster<float>& fine = layout->grids[1].base;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const auto column = static_cast<std::size_t>(std::lround(fine.x(i) / 5.0));
      const auto row = static_cast<std::size_t>(std::lround(fine.y(j) / 5.0));
      area[row * 4 + column] += static_cast<double>(layout->grids[1].area.at(i, j));
    }
  double mass = 0.0;
  for (std::size_t j = 0; j < 3; ++j)
    for (std::size_t i = 0; i < 4; ++i) {
      const float value = swe[(2 - j) * 4 + i];
      if (value > -9999.0f) mass += area[j * 4 + i] * static_cast<double>(value);
    }
  EXPECT_NEAR(mass / m_cover.mass, 1.0, 1e-6);
}

TEST_F(CoverExporterTest, NothingToWriteIsSaid) {
  EXPECT_FALSE(m_exporter->applies(Frame{}));
  EXPECT_FALSE(m_exporter->writeFrame(Frame{}).ok());
  EXPECT_FALSE(m_exporter->begin({std::make_shared<SceneSnapshot>(), m_folder.path(), "cover", 0, 1}).ok());
  const auto attributes = m_exporter->attributes();
  ASSERT_EQ(attributes.size(), 4u);
  EXPECT_EQ(attributes[1].unit, "kg/m2");
}

TEST_F(CoverExporterTest, FolderThatIsGoneIsAnError) {
  ASSERT_TRUE(m_exporter->begin({m_cover.scene, m_folder.file("gone"), "cover", 0, 20}).ok());
  test::expectError(m_exporter->writeFrame(m_cover.frame), ErrorKind::Failed, "cover.0012.tif", {});
}

}  // namespace
}  // namespace spin
