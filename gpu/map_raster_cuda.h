// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/snow/map_raster.h"

namespace spin {

class Occluders;

/// Occlusion maps on the card; null where there is none (see cudaDevice()).
std::unique_ptr<MapRaster> makeMapRasterCuda(const Occluders& occluders);

}  // namespace spin
