// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cmath>
#include <fstream>
#include <string>

#include "core/scene/asset_library.h"

namespace spin {

/// An AssetReader without foreign libraries. A terrain file is text "W H cell" and W x H heights from the
/// south; a model file is any text, its first number the size of a box; a layer file is what writeLayer()
/// wrote. A file that begins with "crash" fails as a crashed helper does.
class FakeAssetReader : public AssetReader {
 public:
  std::atomic<int> reads{0};
  std::atomic<int> layerWrites{0};
  ImportOptions lastOptions;
  LayerFormat lastFormat;
  /// What readRaster() answers; without values it fails.
  RasterImport raster;

  Result<TerrainImport> readTerrain(const std::string& path, const ImportOptions& options,
                                    const CancelToken&) override {
    ++reads;
    lastOptions = options;
    std::ifstream in(path);
    int width = 0, height = 0;
    double cell = 0.0;
    if (!(in >> width >> height >> cell)) return crash(path);
    auto terrain = std::make_shared<TerrainData>();
    terrain->heights = Raster<float>(width, height, 0, 0, cell);
    for (float& value : terrain->heights.values) in >> value;
    return TerrainImport{terrain, {}};
  }

  Result<ModelImport> readModel(const std::string& path, const ImportOptions& options,
                                const CancelToken&) override {
    ++reads;
    lastOptions = options;
    std::ifstream in(path);
    float size = 0.0f;
    if (!(in >> size)) return crash(path);
    auto model = std::make_shared<ModelData>();
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    mesh.indices = {0, 1, 2};
    model->meshes.push_back(mesh);
    model->instances.push_back({});
    return ModelImport{model, {}};
  }

  Result<PaintedLayer> readLayer(const std::string& path, const CancelToken&) override {
    ++reads;
    std::ifstream in(path);
    std::string kind;
    int width = 0, height = 0;
    in >> kind >> width >> height;
    if (kind == "types") return readCells<std::uint8_t>(in, width, height, 255);
    if (kind == "kelvin") return readCells<float>(in, width, height, std::nanf(""));
    return crash(path);
  }

  Result<RasterImport> readRaster(const std::string& path, const CancelToken&) override {
    ++reads;
    if (raster.values.empty()) return crash(path);
    return raster;
  }

  Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData&,
                    const std::string& path) override {
    ++layerWrites;
    lastFormat = format;
    std::ofstream out(path);
    if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&layer)) writeCells(out, "types", *types);
    if (const auto* kelvin = std::get_if<TiledRaster<float>>(&layer)) writeCells(out, "kelvin", *kelvin);
    out.close();
    return out ? Status() : Status(crash(path));
  }

 private:
  static Error crash(const std::string& path) {
    return badInput("The file could not be read", path, "the import helper crashed");
  }
  template <class T>
  static PaintedLayer readCells(std::istream& in, int width, int height, T fill) {
    TiledRaster<T> raster(width, height, fill);
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        double cell = 0.0;
        in >> cell;
        raster.set(i, j, static_cast<T>(cell));
      }
    return raster;
  }
  template <class T>
  static void writeCells(std::ostream& out, const char* kind, const TiledRaster<T>& raster) {
    out << kind << ' ' << raster.width() << ' ' << raster.height() << '\n';
    for (int j = 0; j < raster.height(); ++j)
      for (int i = 0; i < raster.width(); ++i) out << static_cast<double>(raster.at(i, j)) << ' ';
  }
};

}  // namespace spin
