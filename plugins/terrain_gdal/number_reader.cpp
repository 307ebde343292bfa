// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "plugins/sdk/file_name.h"
#include "plugins/terrain_gdal/ascii_check.h"
#include "plugins/terrain_gdal/height_rows.h"
#include "plugins/terrain_gdal/terrain_gdal_plugin.h"

namespace spin {
namespace {

int bitsOf(GDALDataType type) {
  if (type == GDT_Byte) return 8;
  return type == GDT_UInt16 ? 16 : 0;
}

}  // namespace

Result<RasterImport> TerrainGdalPlugin::readRaster(const std::string& path) {
  prepareGdal();
  const GdalMessages messages;
  const Result<RasterSource> source = openRaster(path, messages);
  if (!source) return source.error();
  const ImportOptions plain;
  const Result<RasterCrs> crs = crsOf(*source, plain, path);
  if (!crs) return crs.error();
  const Result<RasterPlacement> place = placementOf(*source, plain, path);
  if (!place) return place.error();
  if (Status status = checkRasterMemory(*source, path); !status) return status.error();
  if (lowerCaseExtension(path) == "asc")
    if (Status status = checkAsciiGrid(path); !status) return status.error();
  RasterImport import;
  import.values = Raster<float>(source->width, source->height, 0.0, 0.0, place->cell);
  import.geo.origin = {place->west + 0.5 * place->cell, place->south + 0.5 * place->cell, 0.0};
  import.geo.epsg = crs->epsg;
  import.geo.wkt = crs->wkt;
  import.georeferenced = place->georeferenced;
  import.bits = bitsOf(source->band->GetRasterDataType());
  const GdalMessages reading;
  HeightRows rows(*source, plain);
  std::vector<double> row;
  for (int j = 0; j < source->height; ++j) {
    if (Status status = rows.read(j, row, reading, path); !status) return status.error();
    float* to = &import.values.at(0, place->rowsFromSouth ? j : source->height - 1 - j);
    for (std::size_t i = 0; i < row.size(); ++i) to[i] = static_cast<float>(row[i]);
  }
  return import;
}

}  // namespace spin
