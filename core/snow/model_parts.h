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

/// Connected up-facing parts of a model, the largest first. A triangle faces up if its upward normal's z is
/// above minUpward. Where a connected surface is closed its inside does not count as a side (whichever way
/// it is wound); an open surface counts with whichever side is up. Triangles connect by edges whose ends
/// coincide within 1e-6 of the model's size.
std::vector<ModelPart> upFacingParts(const std::vector<PlacedTriangle>& triangles, double minUpward);

}  // namespace spin
