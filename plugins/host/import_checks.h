// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/fields/mesh.h"
#include "core/fields/raster.h"
#include "plugins/sdk/import_limits.h"

/// What imported data must fulfil before the rest of the program sees it. The readers check the same for
/// better messages; these checks run on the answer of the import helper, which nobody trusts.
namespace spin {

/// Sizes that fit together, finite numbers, heights within range; the error says what is wrong.
Status checkTerrain(const TerrainData& terrain, const std::string& path);
/// The same for a raster of plain numbers, whose values are finite or NaN and may all be NaN.
Status checkRaster(const Raster<float>& values, const GeoReference& geo, const std::string& path);
Status checkModel(const ModelData& model, const std::string& path);

}  // namespace spin
