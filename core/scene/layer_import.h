// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/nodes/painted_kinds.h"
#include "core/scene/asset_library.h"

namespace spin {

/// What the numbers of a raster mean to a layer.
struct LayerImportOptions {
  /// Of files with 8 or 16 bits: SI values that black and white stand for. Numbers of types are taken as they
  /// are.
  double black = 0.0, white = 1.0;
};

struct LaidRaster {
  PaintedLayer layer;                ///< of the terrain's size
  std::vector<std::string> remarks;  ///< what was changed on the way, English, whole sentences
};

/// A raster as a painted layer of a kind. One with georeference lies where it says; another one of the
/// terrain's size cell on cell, and of any other size stretched over the whole terrain. Measures are
/// interpolated, or averaged where the raster is finer than the terrain; names are taken from the nearest
/// cell. What the raster does not cover, and its cells without data, are unpainted. Temperatures that can
/// only be degrees Celsius are taken as such; measures beyond what the kind holds are set to its limits;
/// numbers of no type are an error, as is a raster elsewhere.
Result<LaidRaster> laidOver(const RasterImport& raster, const TerrainData& terrain, const PaintedKind& kind,
                            const LayerImportOptions& options, const std::string& path);

}  // namespace spin
