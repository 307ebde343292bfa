// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/math/vec.h"

namespace spin {

/// Snow that came down at a place.
struct SnowGrain {
  Vec3d position{};        ///< m, local
  double kilograms = 0.0;  ///< > 0
  double density = 100.0;  ///< kg/m3 as it lies
};

/// What settled out of the air since the cover last took it: rime of mist, dust of powder. The cover puts one
/// into the Exchange; whoever lets snow settle adds to it and keeps it in checkpoints. What lies beyond the
/// cover's cells is given back.
struct SnowFallout {
  std::vector<SnowGrain> falling;
  std::vector<SnowGrain> refused;  ///< found no cell
};

}  // namespace spin
