// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/layer_import.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/nodes/ground_nodes.h"

namespace spin {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

TerrainData terrain(int width = 40, int height = 30, double cell = 5.0) {
  TerrainData data;
  data.heights = Raster<float>(width, height, 0.0, 0.0, cell);
  data.geo = {{1000.0, 2000.0, 0.0}, 31287, ""};
  return data;
}

RasterImport raster(int width, int height, int bits = 0, float value = 0.0f) {
  RasterImport import;
  import.values = Raster<float>(width, height, 0.0, 0.0, 1.0, value);
  import.bits = bits;
  return import;
}

const PaintedKind& clear() {
  return *paintedKind(kKeepClearLayerType);
}
const PaintedKind& depth() {
  return *paintedKind(kSnowDepthLayerType);
}

LaidRaster laid(const RasterImport& import, const TerrainData& land, const PaintedKind& kind,
                const LayerImportOptions& options = {}) {
  Result<LaidRaster> result = laidOver(import, land, kind, options, "f");
  EXPECT_TRUE(result.ok()) << result.error().text();
  return result.ok() ? *result : LaidRaster();
}

const TiledRaster<float>& measures(const LaidRaster& laid) {
  return std::get<TiledRaster<float>>(laid.layer);
}

TEST(LayerImport, PicturesOfTheTerrainsSizeLieCellOnCell) {
  RasterImport picture = raster(40, 30, 8);
  picture.values.at(7, 3) = 255.0f;
  picture.values.at(8, 3) = 51.0f;
  const LaidRaster got = laid(picture, terrain(), depth(), {0.5, 2.5});
  EXPECT_TRUE(got.remarks.empty());
  EXPECT_FLOAT_EQ(measures(got).at(7, 3), 2.5f);
  EXPECT_FLOAT_EQ(measures(got).at(8, 3), 0.9f);
  EXPECT_FLOAT_EQ(measures(got).at(0, 0), 0.5f);
}

TEST(LayerImport, OtherSizesAreStretchedWithAWordAboutIt) {
  // Twice and half as fine: a ramp stays the ramp.
  for (const int width : {80, 20}) {
    RasterImport ramp = raster(width, 30, 16);
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < width; ++i) ramp.values.at(i, j) = static_cast<float>(65535.0 * (i + 0.5) / width);
    const LaidRaster got = laid(ramp, terrain(), clear());
    ASSERT_EQ(got.remarks.size(), 1u);
    EXPECT_NE(got.remarks[0].find("resampled"), std::string::npos);
    for (int i = 1; i < 39; ++i)
      EXPECT_NEAR(measures(got).at(i, 12), (i + 0.5) / 40.0, 2e-4) << width << ' ' << i;
  }
}

TEST(LayerImport, FineRastersAreAveraged) {
  RasterImport board = raster(400, 300, 8);
  for (int j = 0; j < 300; ++j)
    for (int i = 0; i < 400; ++i) board.values.at(i, j) = (i + j) % 2 ? 255.0f : 0.0f;
  const LaidRaster got = laid(board, terrain(), clear());
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(measures(got).at(i, 11), 0.5, 1e-6);
}

TEST(LayerImport, GeoreferencedRastersLieWhereTheySay) {
  RasterImport part = raster(4, 4);
  part.values = Raster<float>(4, 4, 0.0, 0.0, 5.0, 1.5f);
  part.values.at(3, 3) = kNone;
  part.georeferenced = true;
  part.geo = {{1050.0, 2020.0, 0.0}, 31287, ""};
  const LaidRaster got = laid(part, terrain(), depth());
  EXPECT_FLOAT_EQ(measures(got).at(10, 4), 1.5f);
  EXPECT_FLOAT_EQ(measures(got).at(13, 6), 1.5f);
  EXPECT_TRUE(std::isnan(measures(got).at(9, 4)));
  EXPECT_TRUE(std::isnan(measures(got).at(14, 4)));
  EXPECT_TRUE(std::isnan(measures(got).at(13, 7))) << "no data there";

  part.geo.origin.x = 9000.0;
  EXPECT_FALSE(laidOver(part, terrain(), depth(), {}, "f").ok());
  part.geo.origin.x = 1050.0;
  part.geo.epsg = 25832;
  const Result<LaidRaster> elsewhere = laidOver(part, terrain(), depth(), {}, "f");
  ASSERT_FALSE(elsewhere.ok());
  EXPECT_NE(elsewhere.error().text().find("gdalwarp"), std::string::npos);
}

TEST(LayerImport, CelsiusIsKnownAndLimitsHold) {
  RasterImport warm = raster(40, 30, 0, -5.0f);
  LaidRaster got = laid(warm, terrain(), *paintedKind(kGroundTemperatureLayerType));
  ASSERT_EQ(got.remarks.size(), 1u);
  EXPECT_NEAR(measures(got).at(3, 3), 268.15, 1e-4);
  warm = raster(40, 30, 0, 270.0f);
  got = laid(warm, terrain(), *paintedKind(kGroundTemperatureLayerType));
  EXPECT_TRUE(got.remarks.empty());
  EXPECT_FLOAT_EQ(measures(got).at(3, 3), 270.0f);
  RasterImport share = raster(40, 30, 0, 0.5f);
  share.values.at(1, 1) = 7.0f;
  got = laid(share, terrain(), clear());
  ASSERT_EQ(got.remarks.size(), 1u);
  EXPECT_NE(got.remarks[0].find("1 cells"), std::string::npos);
  EXPECT_EQ(measures(got).at(1, 1), 1.0f);
}

TEST(LayerImport, NamesAreNearestAndKnown) {
  RasterImport types = raster(20, 15, 8, 2.0f);
  types.values.at(5, 5) = 4.0f;
  types.values.at(6, 5) = 255.0f;
  const PaintedKind& kind = *paintedKind(kGroundTypeLayerType);
  const LaidRaster got = laid(types, terrain(), kind);
  const auto& layer = std::get<TiledRaster<std::uint8_t>>(got.layer);
  EXPECT_EQ(layer.at(10, 10), 4);
  EXPECT_EQ(layer.at(11, 11), 4);
  EXPECT_EQ(layer.at(12, 10), kUnpaintedGround);
  EXPECT_EQ(layer.at(9, 10), 2);
  types.values.at(0, 0) = 9.0f;
  const Result<LaidRaster> bad = laidOver(types, terrain(), kind, {}, "f");
  ASSERT_FALSE(bad.ok());
  EXPECT_NE(bad.error().text().find("9 is the number of no ground type"), std::string::npos);
}

}  // namespace
}  // namespace spin
