// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "plugins/host/plugin_catalogue.h"
#include "plugins/sdk/importer.h"
#include "tests/plugins/raster_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::lineOf;
using test::RasterFile;
using test::TempFolder;

class TerrainImportTest : public ::testing::Test {
 protected:
  TempFolder m_folder;
};

TEST_F(TerrainImportTest, AsciiGridStandsRightInPlaceAndHeight) {
  const auto import = test::readTerrain(test::writeBytes(m_folder.file("dem.asc"), test::smallAsc()));
  ASSERT_TRUE(import.ok()) << import.error().text();
  const TerrainData& terrain = *import->terrain;
  const Raster<float>& h = terrain.heights;
  EXPECT_EQ(h.width, 4);
  EXPECT_EQ(h.height, 3);
  EXPECT_EQ(h.cellSize, 5.0);
  EXPECT_EQ(h.originX, 0.0);
  EXPECT_EQ(h.originY, 0.0);
  // Centre of the south-west cell and the lowest height, in double.
  EXPECT_DOUBLE_EQ(terrain.geo.origin.x, 176973.4368 + 2.5);
  EXPECT_DOUBLE_EQ(terrain.geo.origin.y, 376237.8352 + 2.5);
  EXPECT_DOUBLE_EQ(terrain.geo.origin.z, 100.0);
  // Row 0 is the southern one, the last in the file.
  EXPECT_EQ(h.at(0, 0), 20.0f);
  EXPECT_EQ(h.at(3, 0), 23.0f);
  EXPECT_EQ(h.at(1, 2), 1.25f);
  EXPECT_TRUE(std::isnan(h.at(1, 1)));
  EXPECT_EQ(lineOf(import->summary, "Format"), "AAIGrid");
  EXPECT_EQ(lineOf(import->summary, "Size"), "4 x 3 cells");
  EXPECT_EQ(lineOf(import->summary, "Cell size"), "5 m");
  EXPECT_EQ(lineOf(import->summary, "Heights"), "100.000 to 123.000 m");
  EXPECT_EQ(lineOf(import->summary, "No data"), "8.333 % of the cells");
  EXPECT_EQ(lineOf(import->summary, "West, south"), "176973.437, 376237.835 m");
  EXPECT_TRUE(test::mentions(import->summary.warnings, "no coordinate system"));
}

TEST_F(TerrainImportTest, XyzListsBecomeAGrid) {
  const std::string path =
      test::writeBytes(m_folder.file("dem.xyz"), "1000 2020 7\n1010 2020 8\n1000 2010 5\n1010 2010 6.5\n");
  const auto import = test::readTerrain(path);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->heights.cellSize, 10.0);
  EXPECT_EQ(import->terrain->geo.origin, (Vec3d{1000.0, 2010.0, 5.0}));
  EXPECT_EQ(import->terrain->heights.at(1, 0), 1.5f);
  EXPECT_EQ(import->terrain->heights.at(1, 1), 3.0f);
}

TEST_F(TerrainImportTest, EpsgOfTheImportIsKept) {
  ImportOptions options;
  options.epsg = 31287;
  const auto import =
      test::readTerrain(test::writeBytes(m_folder.file("dem.asc"), test::smallAsc()), options);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->geo.epsg, 31287);
  EXPECT_NE(import->terrain->geo.wkt.find("Austria Lambert"), std::string::npos);
  EXPECT_FALSE(test::mentions(import->summary.warnings, "coordinate system"));
}

TEST_F(TerrainImportTest, GeoTiffBringsItsSystemNoDataAndCredit) {
  RasterFile raster;
  raster.hasNoData = true;
  raster.noData = 112.0;
  raster.copyright = "Survey of Somewhere";
  const auto import = test::readTerrain(test::writeTiff(m_folder.file("dem.tif"), raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->geo.epsg, 32632);
  EXPECT_EQ(import->terrain->credit, "Survey of Somewhere");
  EXPECT_TRUE(std::isnan(import->terrain->heights.at(2, 1)));
  EXPECT_EQ(import->terrain->heights.at(3, 0), 23.0f);
  EXPECT_DOUBLE_EQ(import->terrain->geo.origin.y, 5200000.0 - 15.0 + 2.5);
  EXPECT_NE(lineOf(import->summary, "Coordinate system").find("EPSG:32632"), std::string::npos);
}

TEST_F(TerrainImportTest, LargeFloatNoDataIsFoundThoughItRounds) {
  RasterFile raster;
  raster.hasNoData = true;
  raster.noData = -3.4028234663852886e+38;
  raster.values.assign(12, 50.0);
  raster.values[5] = raster.noData;
  const auto import = test::readTerrain(test::writeTiff(m_folder.file("dem.tif"), raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_TRUE(std::isnan(import->terrain->heights.at(1, 1)));
  EXPECT_EQ(import->terrain->geo.origin.z, 50.0);
}

TEST_F(TerrainImportTest, HeightsFarFromZeroKeepMillimetres) {
  RasterFile raster;
  raster.type = "Float64";
  for (int i = 0; i < 12; ++i) raster.values.push_back(8848.0 + 0.001 * i);
  const auto import = test::readTerrain(test::writeTiff(m_folder.file("dem.tif"), raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_DOUBLE_EQ(import->terrain->geo.origin.z, 8848.0);
  EXPECT_NEAR(static_cast<double>(import->terrain->heights.at(3, 0)), 0.011, 1e-7);
}

TEST_F(TerrainImportTest, FeetBecomeMetres) {
  RasterFile raster;
  raster.unit = "ft";
  const auto import = test::readTerrain(test::writeTiff(m_folder.file("dem.tif"), raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_NEAR(import->terrain->geo.origin.z, 30.48, 1e-9);
  EXPECT_NEAR(static_cast<double>(import->terrain->heights.at(3, 0)), 23 * 0.3048, 1e-5);
}

TEST_F(TerrainImportTest, CentimetresBecomeMetresAndUnitsOfNoLengthCountAsNone) {
  RasterFile raster;
  raster.unit = "cm";
  const auto small = test::readTerrain(test::writeTiff(m_folder.file("cm.tif"), raster));
  ASSERT_TRUE(small.ok()) << small.error().text();
  EXPECT_NEAR(small->terrain->geo.origin.z, 1.0, 1e-9);
  raster.unit = "count";
  ImportOptions options;
  options.heightScale = 0.5;
  const auto scaled = test::readTerrain(test::writeTiff(m_folder.file("count.tif"), raster), options);
  ASSERT_TRUE(scaled.ok()) << scaled.error().text();
  EXPECT_NEAR(scaled->terrain->geo.origin.z, 50.0, 1e-9);
}

TEST_F(TerrainImportTest, SouthUpRastersAreTurned) {
  RasterFile raster;
  raster.transform = {500000.0, 5.0, 0.0, 5200000.0, 0.0, 5.0};
  const auto import = test::readTerrain(test::writeTiff(m_folder.file("dem.tif"), raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->heights.at(0, 0), 0.0f);
  EXPECT_EQ(import->terrain->heights.at(0, 2), 20.0f);
  EXPECT_DOUBLE_EQ(import->terrain->geo.origin.y, 5200000.0 + 2.5);
}

TEST_F(TerrainImportTest, Png16TakesItsScaleAndHolesFromTheImport) {
  RasterFile raster;
  raster.type = "UInt16";
  raster.values = {0, 0, 1000, 1010, 1020, 1030, 1040, 1050, 1060, 1070, 1080, 1090};
  const std::string path = test::writePng(m_folder.file("dem.png"), raster);
  const auto plain = test::readTerrain(path);
  ASSERT_TRUE(plain.ok()) << plain.error().text();
  EXPECT_TRUE(test::mentions(plain->summary.warnings, "2 cells hold 0"));
  EXPECT_TRUE(test::mentions(plain->summary.warnings, "1 m assumed"));
  EXPECT_EQ(plain->terrain->heights.at(2, 2), 1000.0f);

  ImportOptions options;
  options.noDataValue = 0.0;
  options.heightScale = 0.1;
  options.cellSize = 2.0;
  const auto scaled = test::readTerrain(path, options);
  ASSERT_TRUE(scaled.ok()) << scaled.error().text();
  EXPECT_TRUE(std::isnan(scaled->terrain->heights.at(0, 2)));
  EXPECT_NEAR(scaled->terrain->geo.origin.z, 100.0, 1e-9);
  EXPECT_NEAR(static_cast<double>(scaled->terrain->heights.at(3, 2)), 1.0, 1e-5);
  EXPECT_EQ(scaled->terrain->heights.cellSize, 2.0);
  EXPECT_FALSE(test::mentions(scaled->summary.warnings, "cells hold 0"));
}

TEST_F(TerrainImportTest, Png16FullOfTheLastNumberIsSuspected) {
  RasterFile raster;
  raster.type = "UInt16";
  raster.values.assign(12, 1000.0);
  raster.values[3] = raster.values[4] = raster.values[5] = 65535.0;
  const std::string path = test::writePng(m_folder.file("dem.png"), raster);
  // As metres it is no height on Earth, as decimetres it might be.
  test::expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"65535 m", "NoData"});
  ImportOptions options;
  options.heightScale = 0.1;
  const auto scaled = test::readTerrain(path, options);
  ASSERT_TRUE(scaled.ok()) << scaled.error().text();
  EXPECT_TRUE(test::mentions(scaled->summary.warnings, "3 cells hold 65535"));
}

TEST_F(TerrainImportTest, CreditStandsInTheFirstLineBesideTheFile) {
  test::writeBytes(m_folder.file("CREDITS.txt"), "Data: Land Tirol\r\nMore text\n");
  const auto import = test::readTerrain(test::writeBytes(m_folder.file("dem.asc"), test::smallAsc()));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_EQ(import->terrain->credit, "Data: Land Tirol");
}

TEST_F(TerrainImportTest, UndeclaredMarkersAreSuspected) {
  RasterFile raster;
  raster.values.assign(12, 700.0);
  raster.values[3] = raster.values[4] = -9999.0;
  const std::string path = test::writeTiff(m_folder.file("dem.tif"), raster);
  const auto import = test::readTerrain(path);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_TRUE(test::mentions(import->summary.warnings, "2 cells lie at -9999 m"));
  ImportOptions options;
  options.noDataValue = -9999.0;
  const auto mended = test::readTerrain(path, options);
  ASSERT_TRUE(mended.ok()) << mended.error().text();
  EXPECT_EQ(mended->terrain->geo.origin.z, 700.0);
}

TEST(TerrainPlugin, ItsMetadataListsWhatItsCodeReads) {
  const PluginCatalogue catalogue = readPluginCatalogue(pluginFolders());
  const PluginEntry* entry = findPlugin(catalogue, SPIN_TERRAIN_IMPORTER_IID, "tif");
  ASSERT_NE(entry, nullptr);
  const auto object = loadPlugin(*entry);
  ASSERT_TRUE(object.ok()) << object.error().text();
  auto* importer = qobject_cast<TerrainImporter*>(*object);
  ASSERT_NE(importer, nullptr);
  EXPECT_EQ(importer->extensions(), entry->extensions);
}

}  // namespace
}  // namespace spin
