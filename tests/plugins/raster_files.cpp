// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/plugins/raster_files.h"

#include <gtest/gtest.h>

#include <gdal_priv.h>
#include <ogr_spatialref.h>

namespace spin::test {
namespace {

GDALDataset* create(const char* driver, const std::string& path, const RasterFile& raster) {
  GDALAllRegister();
  GDALDataset* file = GetGDALDriverManager()->GetDriverByName(driver)->Create(
      path.c_str(), raster.width, raster.height, raster.bands, GDALGetDataTypeByName(raster.type), nullptr);
  EXPECT_NE(file, nullptr) << path;
  std::vector<double> values = raster.values;
  for (int j = 0; raster.values.empty() && j < raster.height; ++j)
    for (int i = 0; i < raster.width; ++i) values.push_back(100.0 + i + 10.0 * j);
  for (int b = 1; b <= raster.bands; ++b) {
    GDALRasterBand* band = file->GetRasterBand(b);
    EXPECT_EQ(band->RasterIO(GF_Write, 0, 0, raster.width, raster.height, values.data(), raster.width,
                             raster.height, GDT_Float64, 0, 0, nullptr),
              CE_None);
    if (raster.hasNoData) band->SetNoDataValue(raster.noData);
    if (*raster.unit) band->SetUnitType(raster.unit);
  }
  if (!raster.transform.empty()) file->SetGeoTransform(const_cast<double*>(raster.transform.data()));
  if (raster.epsg > 0) {
    OGRSpatialReference srs;
    srs.importFromEPSG(raster.epsg);
    file->SetSpatialRef(&srs);
  }
  if (*raster.copyright) file->SetMetadataItem("TIFFTAG_COPYRIGHT", raster.copyright);
  return file;
}

}  // namespace

std::string writeTiff(const std::string& path, const RasterFile& raster) {
  GDALClose(create("GTiff", path, raster));
  return path;
}

std::string writePng(const std::string& path, const RasterFile& raster) {
  RasterFile plain = raster;
  plain.transform.clear();
  plain.epsg = 0;
  GDALDataset* memory = create("MEM", "", plain);
  GDALClose(GetGDALDriverManager()->GetDriverByName("PNG")->CreateCopy(path.c_str(), memory, TRUE, nullptr,
                                                                       nullptr, nullptr));
  GDALClose(memory);
  return path;
}

std::string smallAsc() {
  return "ncols 4\nnrows 3\nxllcorner 176973.4368\nyllcorner 376237.8352\ncellsize 5\nNODATA_value -9999\n"
         "100 101.25 102 103\n110 -9999 112 113\n120 121 122 123\n";
}

}  // namespace spin::test
