// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/asset_library.h"
#include "plugins/gdal_common/gdal_session.h"

namespace spin {

/// A raster file opened and checked before any memory is taken for its cells.
struct RasterSource {
  DatasetPointer dataset;
  GDALRasterBand* band = nullptr;
  int width = 0;
  int height = 0;
};

/// Opens by the driver that the extension names, checks size, bands and number type.
Result<RasterSource> openRaster(const std::string& path, const GdalMessages& messages);

/// Whether the memory that an import may take suffices for all cells as floats.
Status checkRasterMemory(const RasterSource& source, const std::string& path);

/// Where the cells lie: north up, square, metres.
struct RasterPlacement {
  double west = 0.0;   ///< world x of the western edge, m
  double south = 0.0;  ///< world y of the southern edge, m
  double cell = 1.0;   ///< m
  bool rowsFromSouth = false;
  bool georeferenced = false;
};
Result<RasterPlacement> placementOf(const RasterSource& source, const ImportOptions& options,
                                    const std::string& path);

/// The coordinate system; a geographic one (degrees) or one in feet is refused with the command that helps.
struct RasterCrs {
  int epsg = 0;
  std::string wkt;
  std::string name;
};
Result<RasterCrs> crsOf(const RasterSource& source, const ImportOptions& options, const std::string& path);

}  // namespace spin
