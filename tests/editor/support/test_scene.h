// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/nodes/camera_node.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/scene/asset_library.h"

/// A small hill with a cube on it, for tests of the editor that need no files.
namespace spin::test {

inline std::shared_ptr<const TerrainData> hill(int side = 65, double cell = 4.0) {
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(side, side, 0.0, 0.0, cell);
  const double middle = (side - 1) * cell * 0.5;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double d = std::hypot(i * cell - middle, j * cell - middle) / middle;
      terrain->heights.at(i, j) = static_cast<float>(30.0 * std::exp(-3.0 * d * d));
    }
  return terrain;
}

/// A cube of 8 m that stands on z = 0.
inline std::shared_ptr<const ModelData> cube() {
  auto model = std::make_shared<ModelData>();
  Mesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.push_back(
        {corner & 1 ? 4.0f : -4.0f, corner & 2 ? 4.0f : -4.0f, corner & 4 ? 8.0f : 0.0f});
  mesh.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                  2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  model->meshes.push_back(mesh);
  model->materials.push_back({});
  model->instances.push_back({});
  return model;
}

/// Gives the hill for any terrain file and the cube for any model file.
class FakeReader final : public AssetReader {
 public:
  Result<TerrainImport> readTerrain(const std::string&, const ImportOptions& options,
                                    const CancelToken&) override {
    return TerrainImport{hill(),
                         {{{"Cell size", "4 m"}, {"EPSG", std::to_string(options.epsg)}}, {"a warning"}}};
  }
  Result<ModelImport> readModel(const std::string& path, const ImportOptions&, const CancelToken&) override {
    if (path.find("broken") != std::string::npos)
      return badInput("The model could not be read", path, "it is broken", "Export it again");
    return ModelImport{cube(), {{{"Triangles", "12"}}, {}}};
  }
  Result<PaintedLayer> readLayer(const std::string& path, const CancelToken&) override {
    return badInput("No layers here", path, "the reader of the tests knows none");
  }
  Result<RasterImport> readRaster(const std::string& path, const CancelToken&) override {
    if (raster.values.empty()) return badInput("No rasters here", path, "the reader of the tests knows none");
    return raster;
  }
  Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData&,
                    const std::string& path) override {
    written = {path, format, layer};
    return {};
  }

  RasterImport raster;  ///< what readRaster() answers
  struct Written {
    std::string path;
    LayerFormat format;
    PaintedLayer layer;
  };
  Written written;  ///< last
};

/// The hill with a cube on its top; the cube's node is "cube".
inline SnapshotPointer hillSnapshot() {
  auto scene = std::make_shared<SceneSnapshot>();
  scene->terrain = hill();
  SceneNode ground = makeNode(kTerrainType, "terrain", "Terrain");
  SceneNode model = makeNode(kModelType, "cube", "Cube");
  ModelNode placed;
  placed.position = {128, 128, 0};
  model.data = std::make_shared<ModelNode>(placed);
  scene->models["cube"] = cube();
  scene->nodes = {ground, model};
  return scene;
}

}  // namespace spin::test
