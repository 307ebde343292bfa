// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "plugins/sdk/importer.h"

namespace spin {

/// Elevation models and painted layers by GDAL: ESRI ASCII, GeoTIFF, 16-bit PNG, XYZ.
class TerrainGdalPlugin final : public QObject, public TerrainImporter {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID SPIN_TERRAIN_IMPORTER_IID FILE "terrain_gdal.json")
  Q_INTERFACES(spin::TerrainImporter)

 public:
  std::vector<std::string> extensions() const override { return {"asc", "tif", "tiff", "png", "xyz", "hgt"}; }
  Result<TerrainImport> read(const std::string& path, const ImportOptions& options) override;
  Result<PaintedLayer> readLayer(const std::string& path) override;
  Result<RasterImport> readRaster(const std::string& path) override;
  Status writeLayer(const PaintedLayer& layer, const LayerFormat& format, const TerrainData& terrain,
                    const std::string& path) override;
};

}  // namespace spin
