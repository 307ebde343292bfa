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
  const Status status = m_reader->writeLayer(types, LayerFormat(), someTerrain(), path);
  ASSERT_TRUE(status.ok()) << status.error().text();
  EXPECT_EQ(std::get<TiledRaster<std::uint8_t>>(readBack(path)), types);
  EXPECT_EQ(m_folder.names(), std::vector<std::string>{"types.png"}) << "files left beside the layer";
}

TEST_F(PaintedLayers, TemperaturesKeepNaNAndTheTerrainsPlace) {
  TiledRaster<float> kelvin(130, 70, std::nanf(""));
  kelvin.set(0, 0, 268.25f);
  kelvin.set(129, 69, 271.0f);
  const std::string path = m_folder.file("kelvin.tif");
  const Status status = m_reader->writeLayer(kelvin, {"ground temperature", "K"}, someTerrain(), path);
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

TiledRaster<float> ramp() {
  TiledRaster<float> share(130, 70, 0.0f);
  for (int j = 0; j < 70; ++j)
    for (int i = 0; i < 130; ++i) share.set(i, j, static_cast<float>(i) / 129.0f);
  return share;
}

TEST_F(PaintedLayers, MasksGoOutAsPicturesAndComeBackAsNumbers) {
  for (const int bits : {8, 16}) {
    const std::string path = m_folder.file(std::to_string(bits) + ".png");
    const LayerFormat format{"share kept clear", "", bits, 0.0, 1.0};
    ASSERT_TRUE(m_reader->writeLayer(ramp(), format, someTerrain(), path).ok());
    const Result<RasterImport> read = m_reader->readRaster(path, CancelToken());
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(read->bits, bits);
    EXPECT_FALSE(read->georeferenced);
    ASSERT_EQ(read->values.width, 130);
    ASSERT_EQ(read->values.height, 70);
    const double white = bits == 8 ? 255.0 : 65535.0;
    for (const int i : {0, 1, 64, 129})
      EXPECT_NEAR(static_cast<double>(read->values.at(i, 12)) / white, i / 129.0, 0.501 / white)
          << bits << " bits, column " << i;
  }
}

TEST_F(PaintedLayers, LayersGoOutAsGeoTiffsThatKnowTheirPlace) {
  TiledRaster<float> depth(130, 70, std::nanf(""));
  depth.set(3, 5, 1.75f);
  const std::string path = m_folder.file("depth.tif");
  ASSERT_TRUE(m_reader->writeLayer(depth, {"snow depth", "m"}, someTerrain(), path).ok());
  Result<RasterImport> read = m_reader->readRaster(path, CancelToken());
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->bits, 0);
  EXPECT_TRUE(read->georeferenced);
  EXPECT_NEAR(read->geo.origin.x, 176975.9368, 1e-6);
  EXPECT_EQ(read->geo.epsg, 31287);
  EXPECT_FLOAT_EQ(read->values.at(3, 5), 1.75f);
  EXPECT_TRUE(std::isnan(read->values.at(4, 5)));

  TiledRaster<std::uint8_t> types(130, 70, kUnpaintedGround);
  types.set(3, 5, 4);
  const std::string numbers = m_folder.file("types.tif");
  ASSERT_TRUE(m_reader->writeLayer(types, {"ground type", ""}, someTerrain(), numbers).ok());
  read = m_reader->readRaster(numbers, CancelToken());
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(read->values.at(3, 5), 4.0f);
  EXPECT_TRUE(std::isnan(read->values.at(4, 5)));
}

TEST_F(PaintedLayers, RastersThatAreNoneAreRefused) {
  const std::string path = test::writeBytes(m_folder.file("text.png"), "no picture");
  test::expectError(m_reader->readRaster(path, CancelToken()), ErrorKind::BadInput, path,
                    {"could not be read"});
  test::expectError(m_reader->readRaster(m_folder.file("none.tif"), CancelToken()), ErrorKind::BadInput,
                    m_folder.file("none.tif"), {"no such file"});
}

TEST_F(PaintedLayers, SameLayerSameBytes) {
  TiledRaster<std::uint8_t> types(130, 70, 3);
  types.set(64, 64, 1);
  ASSERT_TRUE(m_reader->writeLayer(types, LayerFormat(), someTerrain(), m_folder.file("a.png")).ok());
  ASSERT_TRUE(m_reader->writeLayer(types, LayerFormat(), someTerrain(), m_folder.file("b.png")).ok());
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
  test::expectError(m_reader->readLayer(path, CancelToken()), ErrorKind::BadInput, path, {"inf"});
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
  EXPECT_FALSE(m_reader->writeLayer(types, LayerFormat(), someTerrain(), path).ok());
  EXPECT_FALSE(m_reader->writeLayer(types, LayerFormat(), someTerrain(), m_folder.file("types.jpg")).ok());
  LayerFormat empty;
  empty.low = empty.high;
  const TiledRaster<float> share(130, 70, 0.0f);
  EXPECT_FALSE(m_reader->writeLayer(share, empty, someTerrain(), m_folder.file("share.png")).ok());
  EXPECT_FALSE(m_reader->writeLayer(PaintedLayer(), {}, someTerrain(), m_folder.file("none.tif")).ok());
}

}  // namespace
}  // namespace spin
