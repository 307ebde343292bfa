// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/nodes/ground_nodes.h"
#include "plugins/sdk/file_name.h"
#include "plugins/sdk/output_file.h"
#include "plugins/terrain_gdal/raster_source.h"
#include "plugins/terrain_gdal/terrain_gdal_plugin.h"

namespace spin {
namespace {

constexpr const char* kWhatRead = "The painted layer could not be read";

Status checkValue(std::uint8_t value, const std::string& path) {
  if (value < kGroundTypeCount || value == kUnpaintedGround) return {};
  return badInput(kWhatRead, path, fmt::format("it holds the ground type {}", value),
                  fmt::format("Ground types are 0 to {}; {} marks what is not painted", kGroundTypeCount - 1,
                              kUnpaintedGround));
}

/// What a value means is known where it goes; here it only has to be a number.
Status checkValue(float value, const std::string& path) {
  if (!std::isinf(value)) return {};
  return badInput(kWhatRead, path, fmt::format("it holds the number {}", value),
                  "NaN marks what is not painted; all else must be finite");
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

/// By a copy from memory, the only way that GDAL writes PNG.
template <class T>
bool writePng(const TiledRaster<T>& layer, GDALDataType type, const std::string& path) {
  const DatasetPointer memory = create("MEM", "", layer.width(), layer.height(), type, nullptr);
  GDALDriver* png = GetGDALDriverManager()->GetDriverByName("PNG");
  if (!memory || !png || !fillBand(*memory, layer, type)) return false;
  // No .aux.xml beside it: the picture says all there is.
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", "NO");
  const DatasetPointer written(png->CreateCopy(path.c_str(), memory.get(), TRUE, nullptr, nullptr, nullptr));
  CPLSetThreadLocalConfigOption("GDAL_PAM_ENABLED", nullptr);
  return written != nullptr;
}

/// Grey levels for measures; black for NaN.
template <class T>
TiledRaster<T> greyLevels(const TiledRaster<float>& layer, const LayerFormat& format) {
  TiledRaster<T> grey(layer.width(), layer.height(), T{});
  constexpr double kWhite = std::numeric_limits<T>::max();
  for (int j = 0; j < layer.height(); ++j)
    for (int i = 0; i < layer.width(); ++i) {
      const double value = static_cast<double>(layer.at(i, j));
      const double share = (value - format.low) / (format.high - format.low);
      if (share > 0.0) grey.set(i, j, static_cast<T>(std::lround(std::min(share, 1.0) * kWhite)));
    }
  return grey;
}

bool writePicture(const PaintedLayer& layer, const LayerFormat& format, const std::string& path) {
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer))
    return writePng(*numbers, GDT_Byte, path);
  const auto& reals = std::get<TiledRaster<float>>(layer);
  return format.bits == 16 ? writePng(greyLevels<std::uint16_t>(reals, format), GDT_UInt16, path)
                           : writePng(greyLevels<std::uint8_t>(reals, format), GDT_Byte, path);
}

template <class T>
bool writeTiff(const TiledRaster<T>& layer, GDALDataType type, const LayerFormat& format,
               const TerrainData& terrain, const std::string& path) {
  const char* const options[] = {"COMPRESS=DEFLATE", type == GDT_Float32 ? "PREDICTOR=3" : "PREDICTOR=2",
                                 "TILED=YES", nullptr};
  const DatasetPointer file = create("GTiff", path, layer.width(), layer.height(), type, options);
  if (!file) return false;
  const Raster<float>& r = terrain.heights;
  double transform[6];
  geoTransformOf(r.originX, r.originY, r.cellSize, layer.height(), terrain.geo, transform);
  file->SetGeoTransform(transform);
  if (const auto srs = spatialReferenceOf(terrain.geo)) file->SetSpatialRef(srs.get());
  GDALRasterBand* band = file->GetRasterBand(1);
  band->SetNoDataValue(type == GDT_Float32 ? std::nan("") : static_cast<double>(layer.fill()));
  if (!format.name.empty()) band->SetDescription(format.name.c_str());
  if (!format.unit.empty()) band->SetUnitType(format.unit.c_str());
  return fillBand(*file, layer, type);
}

bool writeMeasures(const PaintedLayer& layer, const LayerFormat& format, const TerrainData& terrain,
                   const std::string& path) {
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer))
    return writeTiff(*numbers, GDT_Byte, format, terrain, path);
  return writeTiff(std::get<TiledRaster<float>>(layer), GDT_Float32, format, terrain, path);
}

Status checkFormat(const PaintedLayer& layer, const LayerFormat& format, const std::string& path) {
  const std::string ending = lowerCaseExtension(path);
  const auto refuse = [&](const char* why, const char* advice) {
    return Error{ErrorKind::Usage, "The painted layer could not be written", path, why, advice};
  };
  if (std::holds_alternative<std::monostate>(layer)) return refuse("nothing is painted", "Paint it first");
  if (ending != "png" && ending != "tif" && ending != "tiff")
    return refuse("layers go to .png and .tif files", "Choose one of these endings");
  const bool picture = ending == "png" && std::holds_alternative<TiledRaster<float>>(layer);
  if (picture && format.bits != 8 && format.bits != 16)
    return refuse("a PNG has 8 or 16 bits", "Choose one of these");
  if (picture && !(std::isfinite(format.low) && format.high > format.low && std::isfinite(format.high)))
    return refuse("black and white stand for no range of values", "Give white a larger value than black");
  return {};
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
                  "Ground types and areas are 8-bit PNG files, all other layers float GeoTIFF files");
}

Status TerrainGdalPlugin::writeLayer(const PaintedLayer& layer, const LayerFormat& format,
                                     const TerrainData& terrain, const std::string& path) {
  prepareGdal();
  const GdalMessages messages;
  if (Status status = checkFormat(layer, format, path); !status) return status;
  OutputFile file(path);
  const bool written = lowerCaseExtension(path) == "png"
                           ? writePicture(layer, format, file.temporaryPath())
                           : writeMeasures(layer, format, terrain, file.temporaryPath());
  // Compressed cells go out when the dataset closes, so a full disk may show only in the messages.
  if (!written || messages.failed())
    return cannotWrite(path, messages.reason("its cells could not be written"));
  return file.commit(64);
}

}  // namespace spin
