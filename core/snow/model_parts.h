// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/snow/snow_ground.h"

namespace spin {

/// A connected set of triangles that face up, and its area in plan, m2.
struct ModelPart {
  std::vector<std::uint32_t> triangles;
  double planArea = 0.0;
};

/// How a model's triangles stand to the air.
struct ModelSurface {
  std::vector<ModelPart> parts;  ///< connected parts that face up, the largest first
  std::vector<signed char>
      outward;                ///< per triangle: +1 or -1, the side of the winding that is outside a closed
                              ///< surface; 0 where the surface is open and both sides are outside
  std::vector<char> doubled;  ///< per triangle: 1 where another one stands in the same place already
};

/// A triangle faces up if its upward normal's z is above minUpward. Where a connected surface is closed its
/// inside does not count as a side, whichever way its triangles are wound, one by one; an open surface counts
/// with whichever side is up, and so does one without sides (a Moebius strip) or without volume. Triangles
/// connect by edges whose ends coincide within 1e-6 of the model's size; of triangles that coincide only the
/// first counts.
ModelSurface modelSurface(const std::vector<PlacedTriangle>& triangles, double minUpward);
/// Its parts alone.
std::vector<ModelPart> upFacingParts(const std::vector<PlacedTriangle>& triangles, double minUpward);

}  // namespace spin
