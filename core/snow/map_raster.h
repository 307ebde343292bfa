// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace spin {

struct MapView;

/// Draws occlusion maps of one set of triangles elsewhere than on the processor's threads; it holds a copy
/// of them.
class MapRaster {
 public:
  virtual ~MapRaster() = default;
  /// Depths by texel, infinite where nothing is drawn.
  virtual std::vector<float> draw(const MapView& view) = 0;
};

}  // namespace spin
