// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/terrain_gdal/raster_source.h"

#include <fmt/format.h>

#include <cmath>

#include "plugins/sdk/file_name.h"
#include "plugins/sdk/import_limits.h"
#include "plugins/sdk/memory_budget.h"

namespace spin {
namespace {

constexpr const char* kWhat = "The raster could not be read";

const char* driverFor(const std::string& extension) {
  if (extension == "asc") return "AAIGrid";
  if (extension == "png") return "PNG";
  if (extension == "xyz") return "XYZ";
  if (extension == "hgt") return "SRTMHGT";
  return "GTiff";
}

Status checkBands(const RasterSource& source, const std::string& path) {
  const int bands = source.dataset->GetRasterCount();
  const bool withAlpha =
      bands == 2 && source.dataset->GetRasterBand(2)->GetColorInterpretation() == GCI_AlphaBand;
  if (bands != 1 && !withAlpha)
    return badInput(kWhat, path, fmt::format("it has {} bands where one with values is wanted", bands),
                    bands >= 3 ? "It looks like a picture; choose the raster with the values"
                               : "Pick one band: gdal_translate -b 1 IN OUT");
  if (source.band->GetColorTable())
    return badInput(kWhat, path, "its cells are colours of a palette, not values",
                    "Choose the raster with the values");
  if (GDALDataTypeIsComplex(source.band->GetRasterDataType()))
    return badInput(kWhat, path, "its cells are complex numbers", "Choose the raster with the values");
  return {};
}

}  // namespace

Result<RasterSource> openRaster(const std::string& path, const GdalMessages& messages) {
  const char* driver = driverFor(lowerCaseExtension(path));
  const char* const drivers[] = {driver, nullptr};
  // Text grids are read in double precision whatever their first lines look like.
  const char* const asDouble[] = {"DATATYPE=Float64", nullptr};
  const bool text = std::string(driver) == "AAIGrid";
  RasterSource source;
  source.dataset.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers,
                                         text ? asDouble : nullptr, nullptr));
  if (!source.dataset)
    return badInput(kWhat, path, messages.reason("it is not what its ending says"),
                    "Check that the file is complete and of the kind its ending names");
  source.width = source.dataset->GetRasterXSize();
  source.height = source.dataset->GetRasterYSize();
  if (source.width < 2 || source.height < 2 || source.width > kMaxRasterEdge ||
      source.height > kMaxRasterEdge)
    return badInput(kWhat, path,
                    fmt::format("it claims {} x {} cells; 2 to {} along each edge are possible", source.width,
                                source.height, kMaxRasterEdge),
                    "Cut out or coarsen the part you need: gdalwarp -te ... -tr ...");
  if (source.dataset->GetRasterCount() < 1) return badInput(kWhat, path, "it has no band");
  source.band = source.dataset->GetRasterBand(1);
  if (Status status = checkBands(source, path); !status) return status.error();
  return source;
}

// Cells here, the copy in the answer, and GDAL's own row and block memory.
Status checkRasterMemory(const RasterSource& source, const std::string& path) {
  const std::size_t cells = static_cast<std::size_t>(source.width) * static_cast<std::size_t>(source.height);
  int blockWidth = 0, blockHeight = 0;
  source.band->GetBlockSize(&blockWidth, &blockHeight);
  const std::size_t block =
      static_cast<std::size_t>(blockWidth) * static_cast<std::size_t>(blockHeight) *
      static_cast<std::size_t>(GDALGetDataTypeSizeBytes(source.band->GetRasterDataType()));
  const std::size_t need = 2 * sizeof(float) * cells + 2 * block;
  const std::size_t left = memoryLeft();
  if (need <= left) return {};
  return Error{
      ErrorKind::OutOfResources, kWhat, path,
      fmt::format("its {} x {} cells need {} MiB and {} MiB are left of the memory allowed for an import",
                  source.width, source.height, need >> 20, left >> 20),
      "Cut out or coarsen the part you need: gdalwarp -te ... -tr ..."};
}

Result<RasterPlacement> placementOf(const RasterSource& source, const ImportOptions& options,
                                    const std::string& path) {
  RasterPlacement place;
  double t[6] = {0, 1, 0, 0, 0, -1};
  if (source.dataset->GetGeoTransform(t) != CE_None) {
    if (!std::isfinite(options.cellSize) || options.cellSize < 0.0)
      return Error{ErrorKind::Usage, kWhat, path, fmt::format("a cell size of {} m", options.cellSize),
                   "Give a positive cell size"};
    place.cell = options.cellSize > 0.0 ? options.cellSize : 1.0;
    return place;
  }
  for (const double v : t)
    if (!std::isfinite(v) || std::abs(v) > kMaxWorldCoordinate)
      return badInput(kWhat, path, fmt::format("its georeference holds the number {}", v),
                      "Correct its georeference");
  const double extent = std::max(source.width, source.height);
  if (std::abs(t[2]) * extent > 1e-3 * std::abs(t[1]) || std::abs(t[4]) * extent > 1e-3 * std::abs(t[5]))
    return badInput(kWhat, path, "its rows do not run east", "Turn it north up: gdalwarp IN OUT");
  if (t[1] <= 0.0 || t[5] == 0.0)
    return badInput(kWhat, path, fmt::format("cells of {} x {} m", t[1], std::abs(t[5])),
                    "Correct its georeference");
  if (std::abs(t[1] - std::abs(t[5])) * extent > 0.01 * t[1])
    return badInput(kWhat, path, fmt::format("its cells are not square: {} x {} m", t[1], std::abs(t[5])),
                    fmt::format("Resample it: gdalwarp -tr {0} {0} -r bilinear IN OUT", t[1]));
  place.cell = t[1];
  place.rowsFromSouth = t[5] > 0.0;
  place.west = t[0];
  place.south = place.rowsFromSouth ? t[3] : t[3] + t[5] * source.height;
  place.georeferenced = true;
  return place;
}

namespace {

/// The metric zone that fits the raster's centre, for the advice.
std::string warpAdvice(const RasterSource& source) {
  double t[6] = {0, 1, 0, 0, 0, -1};
  source.dataset->GetGeoTransform(t);
  const double longitude = t[0] + 0.5 * t[1] * source.width;
  const double latitude = t[3] + 0.5 * t[5] * source.height;
  std::string target = "EPSG:NUMBER";
  if (std::abs(longitude) <= 180.0 && std::abs(latitude) <= 84.0) {
    const int zone = std::min(60, static_cast<int>(std::floor((longitude + 180.0) / 6.0)) + 1);
    target = fmt::format("EPSG:{}", (latitude >= 0.0 ? 32600 : 32700) + zone);
  }
  return "Reproject it into metres: gdalwarp -t_srs " + target + " -r bilinear IN OUT";
}

Status checkMetres(const OGRSpatialReference& srs, const RasterSource& source, const std::string& path) {
  if (srs.IsGeographic() || srs.IsGeocentric())
    return badInput(kWhat, path,
                    fmt::format("its coordinates are {}, not metres on a map",
                                srs.IsGeographic() ? "degrees" : "geocentric"),
                    warpAdvice(source));
  const char* unit = nullptr;
  const double metres = srs.GetLinearUnits(&unit);
  if (srs.IsProjected() && std::abs(metres - 1.0) > 1e-9)
    return badInput(kWhat, path,
                    fmt::format("its coordinates are in {}, not in metres", unit ? unit : "other units"),
                    "Reproject it into metres: gdalwarp -t_srs EPSG:NUMBER -r bilinear IN OUT");
  return {};
}

int epsgOf(const OGRSpatialReference& srs) {
  const auto codeOf = [](const OGRSpatialReference& s) {
    const char* authority = s.GetAuthorityName(nullptr);
    const char* code = s.GetAuthorityCode(nullptr);
    return authority && code && EQUAL(authority, "EPSG") ? std::atoi(code) : 0;
  };
  OGRSpatialReference own(srs);
  if (own.AutoIdentifyEPSG() == OGRERR_NONE && codeOf(own) > 0) return codeOf(own);
  const std::unique_ptr<OGRSpatialReference> match(srs.FindBestMatch());
  return match ? codeOf(*match) : 0;
}

}  // namespace

Result<RasterCrs> crsOf(const RasterSource& source, const ImportOptions& options, const std::string& path) {
  RasterCrs crs;
  OGRSpatialReference srs;
  if (options.epsg > 0) {
    if (srs.importFromEPSG(options.epsg) != OGRERR_NONE)
      return Error{ErrorKind::Usage, kWhat, path,
                   fmt::format("EPSG:{} is not a known coordinate system", options.epsg),
                   "Look it up at epsg.io"};
  } else if (const OGRSpatialReference* own = source.dataset->GetSpatialRef()) {
    srs = *own;
  } else {
    return crs;
  }
  if (Status status = checkMetres(srs, source, path); !status) return status.error();
  crs.epsg = options.epsg > 0 ? options.epsg : epsgOf(srs);
  if (const char* name = srs.GetName()) crs.name = name;
  char* text = nullptr;
  if (srs.exportToWkt(&text) == OGRERR_NONE && text) crs.wkt = text;
  CPLFree(text);
  return crs;
}

}  // namespace spin
