// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// Rasters that are damaged, hostile or simply not what this program needs: always an error that says why.
#include <cmath>

#include "tests/plugins/raster_files.h"
#include "tests/plugins/support.h"

namespace spin {
namespace {

using test::expectError;
using test::RasterFile;
using test::TempFolder;

class TerrainHostile : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& bytes) {
    return test::writeBytes(m_folder.file(name), bytes);
  }
  std::string tiff(const RasterFile& raster) { return test::writeTiff(m_folder.file("dem.tif"), raster); }

  TempFolder m_folder;
};

TEST_F(TerrainHostile, CutOffFiles) {
  const std::string asc = test::smallAsc();
  std::string path = write("cut.asc", asc.substr(0, asc.size() - 12));
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"row 3 of 3", "cut off"});
  path = write("head.asc", asc.substr(0, 30));
  EXPECT_FALSE(test::readTerrain(path).ok());

  RasterFile large;
  large.width = large.height = 200;
  const std::string tif = test::readBytes(tiff(large));
  path = write("cut.tif", tif.substr(0, tif.size() / 2));
  EXPECT_FALSE(test::readTerrain(path).ok());
  path = write("head.tif", tif.substr(0, 100));
  EXPECT_FALSE(test::readTerrain(path).ok());

  large.type = "UInt16";
  const std::string png = test::readBytes(test::writePng(m_folder.file("dem.png"), large));
  path = write("cut.png", png.substr(0, png.size() / 2));
  EXPECT_FALSE(test::readTerrain(path).ok());
}

TEST_F(TerrainHostile, TextUnderTheNameOfARaster) {
  for (const char* name : {"a.png", "a.tif", "a.asc", "a.xyz"}) {
    const std::string path = write(name, "It was a dark and stormy night.\n");
    expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"could not be read"});
  }
}

TEST_F(TerrainHostile, ClaimsOfHugeSizes) {
  const std::string wide =
      write("wide.asc", "ncols 2147000000\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  EXPECT_FALSE(test::readTerrain(wide).ok());
  const std::string broad =
      write("broad.asc", "ncols 20001\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  expectError(test::readTerrain(broad), ErrorKind::BadInput, broad, {"20001 x 2", "gdalwarp"});

  // IHDR of 60000 x 60000 with 16 bits, valid checksum, and hardly any data behind.
  RasterFile raster;
  raster.width = raster.height = 60000 / 1000;
  raster.type = "UInt16";
  std::string png = test::readBytes(test::writePng(m_folder.file("ok.png"), raster));
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (int k = 0; k < 4; ++k)
      png[at + static_cast<std::size_t>(k)] = static_cast<char>(value >> (24 - 8 * k));
  };
  put(16, 60000);
  put(20, 60000);
  std::uint32_t crc = ~0u;
  for (std::size_t i = 12; i < 29; ++i) {
    crc ^= static_cast<unsigned char>(png[i]);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xEDB88320u : 0u);
  }
  put(29, ~crc);
  const std::string path = write("huge.png", png);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"60000 x 60000"});
}

TEST_F(TerrainHostile, MoreThanTheMemoryAllowed) {
  // A few bytes that claim 400 million cells.
  const std::string header = "ncols 20000\nnrows 20000\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  const std::string path = write("large.asc", header + "1 2 3\n");
  const std::size_t before = test::peakMemory();
  const auto result = test::readTerrain(path, {}, {std::size_t{64} << 20, 60.0});
#if defined(__SANITIZE_ADDRESS__)
  EXPECT_FALSE(
      result.ok());  // no address-space limit can be set under the sanitizer, so the file is just short
#else
  expectError(result, ErrorKind::OutOfResources, path, {"20000 x 20000", "memory"});
#endif
  EXPECT_LT(test::peakMemory(), before + (std::size_t{16} << 20));
}

TEST_F(TerrainHostile, NumbersThatAreNone) {
  const std::string head = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  std::string path = write("nan.asc", head + "nan nan\nnan nan\n");
  EXPECT_FALSE(test::readTerrain(path).ok());
  path = write("none.asc", head + "NODATA_value -9999\n-9999 -9999\n-9999 -9999\n");
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"no cell holds a height"});
  path = write("words.asc", head + "1 2\n3 four\n");
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"line 7", "four"});
  path = write("mixed.asc", head + "1 nan\n-3.5e+1 4\n");
  const auto mixed = test::readTerrain(path);
  ASSERT_TRUE(mixed.ok()) << mixed.error().text();
  EXPECT_TRUE(std::isnan(mixed->terrain->heights.at(1, 1)));
  EXPECT_EQ(mixed->terrain->geo.origin.z, -35.0);
  path = write("high.asc", head + "1 2\n3 25000\n");
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"25000 m", "NoData"});

  RasterFile raster;
  raster.values.assign(12, 5.0);
  raster.values[0] = INFINITY;
  raster.values[1] = std::nan("");
  const auto import = test::readTerrain(tiff(raster));
  ASSERT_TRUE(import.ok()) << import.error().text();
  EXPECT_TRUE(std::isnan(import->terrain->heights.at(0, 2)));
  EXPECT_TRUE(std::isnan(import->terrain->heights.at(1, 2)));
  EXPECT_TRUE(test::mentions(import->summary.warnings, "infinite"));

  for (const double bad : {std::nan(""), HUGE_VAL, 1e300}) {
    raster.transform[0] = bad;
    EXPECT_FALSE(test::readTerrain(tiff(raster)).ok()) << bad;
  }
}

/// Tiles of the Shuttle Radar Topography Mission are read, and as all that is in degrees they are refused
/// with the command that puts them into metres.
TEST_F(TerrainHostile, ShuttleTilesAreKnown) {
  const std::string path =
      test::writeBytes(m_folder.file("N47E011.hgt"), std::string(std::size_t{2} * 1201 * 1201, '\1'));
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"degrees", "gdalwarp -t_srs EPSG:32632"});
}

TEST_F(TerrainHostile, DegreesAreRefusedWithTheCommandThatHelps) {
  RasterFile raster;
  raster.epsg = 4326;
  raster.transform = {11.0, 0.001, 0.0, 47.0, 0.0, -0.001};
  const std::string path = tiff(raster);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"degrees", "gdalwarp -t_srs EPSG:32632"});
  raster.epsg = 2263;  // New York, US survey feet
  raster.transform = {980000.0, 10.0, 0.0, 200000.0, 0.0, -10.0};
  expectError(test::readTerrain(tiff(raster)), ErrorKind::BadInput, path, {"not in metres"});
}

TEST_F(TerrainHostile, GridsThatAreNotSquareOrNotNorthUp) {
  RasterFile raster;
  raster.transform = {500000.0, 5.0, 0.0, 5200000.0, 0.0, -7.0};
  std::string path = tiff(raster);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"not square", "gdalwarp -tr 5 5"});
  raster.transform = {500000.0, 4.0, 3.0, 5200000.0, 3.0, -4.0};
  expectError(test::readTerrain(tiff(raster)), ErrorKind::BadInput, path, {"do not run east"});
}

TEST_F(TerrainHostile, PicturesAreNoHeights) {
  RasterFile raster;
  raster.type = "Byte";
  std::string path = test::writePng(m_folder.file("grey.png"), raster);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"8 bits", "16-bit"});
  raster.bands = 3;
  path = test::writePng(m_folder.file("photo.png"), raster);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"3 bands", "picture"});
  raster.type = "CFloat32";
  raster.bands = 1;
  path = tiff(raster);
  expectError(test::readTerrain(path), ErrorKind::BadInput, path, {"complex"});
}

TEST_F(TerrainHostile, OptionsThatMakeNoSense) {
  const std::string path = write("dem.asc", test::smallAsc());
  ImportOptions options;
  options.heightScale = -1.0;
  expectError(test::readTerrain(path, options), ErrorKind::Usage, path, {"height scale"});
  options = {};
  options.epsg = 999998;
  expectError(test::readTerrain(path, options), ErrorKind::Usage, path, {"EPSG:999998"});
  options.epsg = 4326;
  expectError(test::readTerrain(path, options), ErrorKind::BadInput, path, {"degrees"});
}

}  // namespace
}  // namespace spin
