// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/nodes/ground_nodes.h"
#include "plugins/sdk/file_name.h"
#include "plugins/sdk/output_file.h"
#include "plugins/terrain_gdal/raster_source.h"
#include "plugins/terrain_gdal/terrain_gdal_plugin.h"

namespace spin {
namespace {

constexpr const char* kWhatRead = "The painted layer could not be read";
/// K; snow and ground on Earth stay well within.
constexpr float kMaxTemperature = 400.0f;

Status checkValue(std::uint8_t value, const std::string& path) {
  if (value < kGroundTypeCount || value == kUnpaintedGround) return {};
  return badInput(kWhatRead, path, fmt::format("it holds the ground type {}", value),
                  fmt::format("Ground types are 0 to {}; {} marks what is not painted", kGroundTypeCount - 1,
                              kUnpaintedGround));
}

Status checkValue(float value, const std::string& path) {
  if (std::isnan(value) || (value >= 0.0f && value <= kMaxTemperature)) return {};
  return badInput(kWhatRead, path, fmt::format("it holds a temperature of {} K", value),
                  "Temperatures are in kelvin; NaN marks what is not painted");
}

template <class T>
Result<PaintedLayer> readTiled(const RasterSource& source, GDALDataType type, T fill,
                               const GdalMessages& messages, const std::string& path) {
  TiledRaster<T> layer(source.width, source.height, fill);
  std::vector<T> row(static_cast<std::size_t>(source.width));
  for (int j = 0; j < source.height; ++j) {
    const CPLErr result = source.band->RasterIO(GF_Read, 0, j, source.width, 1, row.data(), source.width, 1,
                                                type, 0, 0, nullptr);
    if (result != CE_None || messages.failed())
      return badInput(kWhatRead, path, messages.reason("its cells could not be read"),
                      "The file may be cut off: undo the last copy or paint the layer again");
    for (int i = 0; i < source.width; ++i) {
      const T value = row[static_cast<std::size_t>(i)];
      if (Status status = checkValue(value, path); !status) return status.error();
      layer.set(i, source.height - 1 - j, value);
    }
  }
  return PaintedLayer(std::move(layer));
}

template <class T>
bool fillBand(GDALDataset& dataset, const TiledRaster<T>& layer, GDALDataType type) {
  std::vector<T> row(static_cast<std::size_t>(layer.width()));
  for (int j = 0; j < layer.height(); ++j) {
    for (int i = 0; i < layer.width(); ++i)
      row[static_cast<std::size_t>(i)] = layer.at(i, layer.height() - 1 - j);
    if (dataset.GetRasterBand(1)->RasterIO(GF_Write, 0, j, layer.width(), 1, row.data(), layer.width(), 1,
                                           type, 0, 0, nullptr) != CE_None)
      return false;
  }
  return true;
}

DatasetPointer create(const char* driver, const std::string& path, int width, int height, GDALDataType type,
                      const char* const* options) {
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName(driver);
  return DatasetPointer(
      found ? found->Create(path.c_str(), width, height, 1, type, const_cast<char**>(options)) : nullptr);
}

bool writePng(const TiledRaster<std::uint8_t>& layer, const std::string& path) {
  const DatasetPointer memory = create("MEM", "", layer.width(), layer.height(), GDT_Byte, nullptr);
  GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
  if (!memory || !png || !fillBand(*memory, layer, GDT_Byte)) return false;
  // No .aux.xml beside it: the picture says all there is.
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
  const DatasetPointer written(png->CreateCopy(path.c_str(), memory.get(), TRUE, nullptr, nullptr, nullptr));
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
  return written != nullptr;
}

bool writeTiff(const TiledRaster<float>& layer, const TerrainData& terrain, const std::string& path) {
  const char* const options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", nullptr};
  const DatasetPointer file = create("GTiff", path, layer.width(), layer.height(), GDT_Float32, options);
  if (!file) return false;
  const Raster<float>& r = terrain.heights;
  double transform[6];
  geoTransformOf(r.originX, r.originY, r.cellSize, layer.height(), terrain.geo, transform);
  file->SetGeoTransform(transform);
  if (const auto srs = spatialReferenceOf(terrain.geo)) file->SetSpatialRef(srs.get());
  GDALRasterBand* band = file->GetRasterBand(1);
  band->SetNoDataValue(std::nan(""));
  band->SetDescription("ground temperature");
  band->SetUnitType("K");
  return fillBand(*file, layer, GDT_Float32);
}

}  // namespace

Result<PaintedLayer> TerrainGdalPlugin::readLayer(const std::string& path) {
  prepareGdal();
  const GdalMessages messages;
  const Result<RasterSource> source = openRaster(path, messages);
  if (!source) return source.error();
  const GdalMessages reading;
  const GDALDataType type = source->band->GetRasterDataType();
  if (type == GDT_Byte) return readTiled<std::uint8_t>(*source, type, kUnpaintedGround, reading, path);
  if (type == GDT_Float32) return readTiled<float>(*source, type, std::nanf(""), reading, path);
  return badInput(kWhatRead, path, "its cells are neither 8-bit numbers nor floats",
                  "Ground types are 8-bit PNG files, temperatures float GeoTIFF files");
}

Status TerrainGdalPlugin::writeLayer(const PaintedLayer& layer, const TerrainData& terrain,
                                     const std::string& path) {
  prepareGdal();
  const GdalMessages messages;
  const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer);
  const auto* temperatures = std::get_if<TiledRaster<float>>(&layer);
  const std::string wanted = types ? "png" : "tif";
  if ((!types && !temperatures) || lowerCaseExtension(path) != wanted)
    return Error{ErrorKind::Usage, "The painted layer could not be written", path,
                 "ground types go to .png files and temperatures to .tif files", ""};
  OutputFile file(path);
  const bool written = types ? writePng(*types, file.temporaryPath())
                             : writeTiff(*temperatures, terrain, file.temporaryPath());
  // Compressed cells go out when the dataset closes, so a full disk may show only in the messages.
  if (!written || messages.failed())
    return cannotWrite(path, messages.reason("its cells could not be written"));
  return file.commit(64);
}

}  // namespace spin
