// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "core/fields/raster.h"
#include "core/fields/tiled_raster.h"
#include "core/math/vec.h"

namespace spin {

/// One stroke of the ground type brush: a round brush dragged over the terrain. Every cell whose centre lies
/// within the radius of the way becomes `value`, so that a fast pointer leaves no gaps; at least the cell
/// under the pointer is painted. Tiles that the stroke does not touch stay shared with the layer it began
/// with.
class BrushStroke {
 public:
  /// The layer must have the size of the grid; only the grid's geometry is read. Radius in m.
  BrushStroke(TiledRaster<std::uint8_t> layer, const Raster<float>& grid, double radius, std::uint8_t value);

  /// Paints from the last position (or at this one, for the first) to here; local metres.
  void moveTo(Vec2d position);
  const TiledRaster<std::uint8_t>& layer() const { return m_layer; }
  /// True once a cell got another value than it had.
  bool changed() const { return m_changed; }

 private:
  void paintCell(int i, int j);

  TiledRaster<std::uint8_t> m_layer;
  double m_originX, m_originY, m_cellSize;
  double m_radius;
  std::uint8_t m_value;
  std::optional<Vec2d> m_last;
  bool m_changed = false;
};

/// Next brush radius for the keys [ and ]: a quarter smaller or larger within [0.5, 500] m.
double steppedBrushRadius(double radius, int steps);

}  // namespace spin
