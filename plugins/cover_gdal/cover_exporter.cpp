// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/cover_gdal/cover_exporter.h"

#include <fmt/format.h>

#include <cmath>

#include "plugins/cover_gdal/cover_raster.h"
#include "plugins/gdal_common/gdal_session.h"
#include "plugins/sdk/output_file.h"
#include "plugins/sdk/particle_parts.h"

namespace spin {
namespace {

/// GIS programs handle a number better than NaN.
constexpr double kNoData = -9999.0;

bool writeBand(GDALDataset& dataset, int number, const Raster<float>& values, const char* description,
               const char* unit) {
  GDALRasterBand* band = dataset.GetRasterBand(number);
  band->SetNoDataValue(kNoData);
  band->SetDescription(description);
  band->SetUnitType(unit);
  std::vector<float> row(static_cast<std::size_t>(values.width));
  for (int j = 0; j < values.height; ++j) {
    const float* from = &values.at(0, values.height - 1 - j);
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] = std::isnan(from[i]) ? static_cast<float>(kNoData) : from[i];
    if (band->RasterIO(GF_Write, 0, j, values.width, 1, row.data(), values.width, 1, GDT_Float32, 0, 0,
                       nullptr) != CE_None)
      return false;
  }
  return true;
}

bool writeTiff(const TerrainCover& cover, const TerrainData& terrain, const FrameTime& time,
               const std::string& path) {
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "INTERLEAVE=BAND", nullptr};
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const Raster<float>& r = cover.depth;
  const DatasetPointer file(
      driver ? driver->Create(path.c_str(), r.width, r.height, 4, GDT_Float32, const_cast<char**>(options))
             : nullptr);
  if (!file) return false;
  double transform[6];
  geoTransformOf(r.originX, r.originY, r.cellSize, r.height, terrain.geo, transform);
  file->SetGeoTransform(transform);
  if (const auto srs = spatialReferenceOf(terrain.geo)) file->SetSpatialRef(srs.get());
  file->SetMetadataItem("TIFFTAG_SOFTWARE", "Spindrift " SPIN_VERSION);
  if (!terrain.credit.empty()) file->SetMetadataItem("TIFFTAG_COPYRIGHT", terrain.credit.c_str());
  file->SetMetadataItem("FRAME", fmt::format("{}", time.frame).c_str());
  file->SetMetadataItem("TIME_FILM_S", fmt::format("{:.9g}", time.film).c_str());
  file->SetMetadataItem("TIME_WEATHER_S", fmt::format("{:.9g}", time.weather).c_str());
  return writeBand(*file, 1, cover.depth, "snow depth", "m") &&
         writeBand(*file, 2, cover.swe, "snow water equivalent", "kg/m2") &&
         writeBand(*file, 3, cover.liquid, "liquid water in the snow", "kg/m2") &&
         writeBand(*file, 4, cover.temperature, "surface temperature", "K");
}

}  // namespace

bool CoverExporter::applies(const Frame& frame) const {
  const auto* cover = frame.part<CoverPart>("cover");
  if (!cover || !cover->layout) return false;
  for (const CoverGrid& grid : cover->layout->grids)
    if (grid.id == "terrain") return true;
  return false;
}

Status CoverExporter::begin(const ExportContext& context) {
  m_context = context;
  m_files.clear();
  if (context.scene && context.scene->terrain) return {};
  return Error{ErrorKind::Failed, "The snow cover could not be exported", "", "the scene has no terrain",
               "Import a terrain, or leave this format out"};
}

Status CoverExporter::writeFrame(const Frame& frame) {
  const std::string name = frameFileName(m_context.baseName, frame.info.time.frame, "tif");
  const auto* part = frame.part<CoverPart>("cover");
  const auto cover = part ? gatherTerrainCover(*part) : std::nullopt;
  if (!cover)
    return Error{ErrorKind::Failed, "The snow cover could not be exported", name, "the frame holds none", ""};
  prepareGdal();
  const GdalMessages messages;
  const std::string path = m_context.directory + "/" + name;
  OutputFile file(path);
  const bool written = writeTiff(*cover, *m_context.scene->terrain, frame.info.time, file.temporaryPath());
  // Cells go out when the dataset closes, so a full disk may show only in the messages.
  if (!written || messages.failed())
    return cannotWrite(path, messages.reason("its cells could not be written"));
  if (Status status = file.commit(256); !status) return status;
  m_files.push_back(name);
  return {};
}

}  // namespace spin
