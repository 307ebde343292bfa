// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/hash.h"
#include "core/fields/mesh.h"
#include "core/fields/raster.h"
#include "core/fields/weather_series.h"

namespace spin {

/// What a simulation sees of an asset: the same heights or the same geometry give the same key, wherever the
/// file lies and whatever its pictures, names and coordinate system are.
Hash128 contentHash(const TerrainData& terrain);
Hash128 contentHash(const ModelData& model);
Hash128 contentHash(const WeatherSeries& weather);

}  // namespace spin
