// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/brush_stroke.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Squared distance of p from the segment a..b.
double squaredDistance(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d ab = b - a;
  const Vec2d ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double t = square > 0.0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / square, 0.0, 1.0) : 0.0;
  const Vec2d d = ap - ab * t;
  return d.x * d.x + d.y * d.y;
}

}  // namespace

BrushStroke::BrushStroke(TiledRaster<std::uint8_t> layer, const Raster<float>& grid, double radius,
                         std::uint8_t value)
    : m_layer(std::move(layer)),
      m_originX(grid.originX),
      m_originY(grid.originY),
      m_cellSize(grid.cellSize),
      m_radius(std::max(0.0, radius)),
      m_value(value) {
  SPIN_CHECK_EQ(m_layer.width(), grid.width);
  SPIN_CHECK_EQ(m_layer.height(), grid.height);
}

void BrushStroke::moveTo(Vec2d position) {
  const Vec2d from = m_last.value_or(position);
  m_last = position;
  const auto cellOf = [&](double p, double origin) { return (p - origin) / m_cellSize; };
  const auto clampTo = [](double cell, int count) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count)));
  };
  const int i0 =
      clampTo(std::ceil(cellOf(std::min(from.x, position.x) - m_radius, m_originX)), m_layer.width());
  const int i1 =
      clampTo(std::floor(cellOf(std::max(from.x, position.x) + m_radius, m_originX)) + 1, m_layer.width());
  const int j0 =
      clampTo(std::ceil(cellOf(std::min(from.y, position.y) - m_radius, m_originY)), m_layer.height());
  const int j1 =
      clampTo(std::floor(cellOf(std::max(from.y, position.y) + m_radius, m_originY)) + 1, m_layer.height());
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) {
      const Vec2d centre{m_originX + i * m_cellSize, m_originY + j * m_cellSize};
      if (squaredDistance(centre, from, position) <= m_radius * m_radius) paintCell(i, j);
    }
  paintCell(static_cast<int>(std::lround(std::clamp(cellOf(position.x, m_originX), -1.0, 1e8))),
            static_cast<int>(std::lround(std::clamp(cellOf(position.y, m_originY), -1.0, 1e8))));
}

void BrushStroke::paintCell(int i, int j) {
  if (i < 0 || j < 0 || i >= m_layer.width() || j >= m_layer.height()) return;
  if (m_layer.at(i, j) == m_value) return;
  m_layer.set(i, j, m_value);
  m_changed = true;
}

double steppedBrushRadius(double radius, int steps) {
  return std::clamp(radius * std::pow(1.25, steps), 0.5, 500.0);
}

}  // namespace spin
