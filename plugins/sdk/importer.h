// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtPlugin>
#include <string>
#include <vector>

#include "core/scene/asset_library.h"

namespace spin {

/// Reads one family of foreign files. Runs only inside the import helper process, never in the editor itself.
class TerrainImporter {
 public:
  virtual ~TerrainImporter() = default;
  /// Lower-case endings without the dot.
  virtual std::vector<std::string> extensions() const = 0;
  virtual Result<TerrainImport> read(const std::string& path, const ImportOptions& options) = 0;
  virtual Result<PaintedLayer> readLayer(const std::string& path) = 0;
  virtual Result<RasterImport> readRaster(const std::string& path) = 0;
  virtual Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData& terrain,
                            const std::string& path) = 0;
};

class ModelImporter {
 public:
  virtual ~ModelImporter() = default;
  virtual std::vector<std::string> extensions() const = 0;
  virtual Result<ModelImport> read(const std::string& path, const ImportOptions& options) = 0;
};

}  // namespace spin

#define SPIN_TERRAIN_IMPORTER_IID "org.spindrift.TerrainImporter/1"
#define SPIN_MODEL_IMPORTER_IID "org.spindrift.ModelImporter/1"
Q_DECLARE_INTERFACE(spin::TerrainImporter, SPIN_TERRAIN_IMPORTER_IID)
Q_DECLARE_INTERFACE(spin::ModelImporter, SPIN_MODEL_IMPORTER_IID)
