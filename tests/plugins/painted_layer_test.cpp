// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/nodes/ground_nodes.h"
#include "tests/plugins/raster_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::TempFolder;

TerrainData someTerrain() {
  TerrainData terrain;
  terrain.heights = Raster<float>(130, 70, 0.0, 0.0, 5.0);
  terrain.geo = {{176975.9368, 376240.3352, 1000.0}, 31287, ""};
  return terrain;
}

class PaintedLayers : public ::testing::Test {
 protected:
  PaintedLayer readBack(const std::string& path) {
    auto layer = m_reader->readLayer(path, CancelToken());
    EXPECT_TRUE(layer.ok()) << layer.error().text();
    return layer.ok() ? *layer : PaintedLayer();
  }

  TempFolder m_folder;
  std::shared_ptr<AssetReader> m_reader = makeHelperAssetReader();
};

TEST_F(PaintedLayers, GroundTypesSurviveSavingAndLoading) {
  TiledRaster<std::uint8_t> types(130, 70, kUnpaintedGround);
  types.set(0, 0, 7);
  types.set(129, 69, 4);
  types.set(65, 3, 0);
  const std::string path = m_folder.file("types.png");
  const Status status = m_reader->writeLayer(types, someTerrain(), path);
  ASSERT_TRUE(status.ok()) << status.error().text();
  EXPECT_EQ(std::get<TiledRaster<std::uint8_t>>(readBack(path)), types);
  EXPECT_EQ(m_folder.names(), std::vector<std::string>{"types.png"}) << "files left beside the layer";
}

TEST_F(PaintedLayers, TemperaturesKeepNaNAndTheTerrainsPlace) {
  TiledRaster<float> kelvin(130, 70, std::nanf(""));
  kelvin.set(0, 0, 268.25f);
  kelvin.set(129, 69, 271.0f);
  const std::string path = m_folder.file("kelvin.tif");
  const Status status = m_reader->writeLayer(kelvin, someTerrain(), path);
  ASSERT_TRUE(status.ok()) << status.error().text();
  const auto after = std::get<TiledRaster<float>>(readBack(path));
  EXPECT_EQ(after.at(0, 0), 268.25f);
  EXPECT_EQ(after.at(129, 69), 271.0f);
  EXPECT_TRUE(std::isnan(after.at(64, 35)));
  // Read as a terrain it lies on the cells of the elevation model.
  const auto import = test::readTerrain(path);
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_NEAR(import->terrain->geo.origin.x, 176975.9368, 1e-6);
  EXPECT_NEAR(import->terrain->geo.origin.y, 376240.3352, 1e-6);
  EXPECT_EQ(import->terrain->geo.epsg, 31287);
}

TEST_F(PaintedLayers, SameLayerSameBytes) {
  TiledRaster<std::uint8_t> types(130, 70, 3);
  types.set(64, 64, 1);
  ASSERT_TRUE(m_reader->writeLayer(types, someTerrain(), m_folder.file("a.png")).ok());
  ASSERT_TRUE(m_reader->writeLayer(types, someTerrain(), m_folder.file("b.png")).ok());
  EXPECT_EQ(test::readBytes(m_folder.file("a.png")), test::readBytes(m_folder.file("b.png")));
}

TEST_F(PaintedLayers, UnknownGroundTypesAreRefused) {
  test::RasterFile raster;
  raster.type = "Byte";
  raster.values.assign(12, 3.0);
  raster.values[7] = 8.0;
  const std::string path = test::writePng(m_folder.file("types.png"), raster);
  test::expectError(m_reader->readLayer(path, CancelToken()), ErrorKind::BadInput, path, {"ground type 8"});
}

TEST_F(PaintedLayers, ForeignAndDamagedFilesAreRefused) {
  test::RasterFile raster;
  raster.values.assign(12, 270.0);
  raster.values[2] = INFINITY;
  std::string path = test::writeTiff(m_folder.file("kelvin.tif"), raster);
  test::expectError(m_reader->readLayer(path, CancelToken()), ErrorKind::BadInput, path, {"inf K"});
  raster.type = "UInt16";
  raster.values.assign(12, 3.0);
  path = test::writePng(m_folder.file("deep.png"), raster);
  test::expectError(m_reader->readLayer(path, CancelToken()), ErrorKind::BadInput, path, {"8-bit"});
  path = test::writeBytes(m_folder.file("text.png"), "no picture");
  test::expectError(m_reader->readLayer(path, CancelToken()), ErrorKind::BadInput, path,
                    {"could not be read"});
}

TEST_F(PaintedLayers, WritingWhereNothingCanBeWrittenIsAnError) {
  const TiledRaster<std::uint8_t> types(130, 70, 3);
  const std::string path = m_folder.file("no/such/folder/types.png");
  EXPECT_FALSE(m_reader->writeLayer(types, someTerrain(), path).ok());
  EXPECT_FALSE(m_reader->writeLayer(types, someTerrain(), m_folder.file("types.tif")).ok());
}

}  // namespace
}  // namespace spin
