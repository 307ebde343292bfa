// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace spin::test {

/// A GeoTIFF or PNG made by GDAL, north row first.
struct RasterFile {
  int width = 4;
  int height = 3;
  int bands = 1;
  const char* type = "Float32";  ///< name of GDAL's data type
  std::vector<double> values;  ///< row by row from the north; empty = 100 + column + 10 x row from the north
  std::vector<double> transform{500000.0, 5.0, 0.0, 5200000.0, 0.0, -5.0};  ///< empty = none
  int epsg = 32632;                                                         ///< 0 = none
  double noData = std::numeric_limits<double>::quiet_NaN();
  bool hasNoData = false;
  const char* unit = "";
  const char* copyright = "";
};

/// Returns the path.
std::string writeTiff(const std::string& path, const RasterFile& raster);
std::string writePng(const std::string& path, const RasterFile& raster);
/// 4 x 3 cells of 5 m with one hole, heights 100 .. 123.
std::string smallAsc();

}  // namespace spin::test
