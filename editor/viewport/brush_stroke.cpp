// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/brush_stroke.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

constexpr double kLeastWeight = 1.0 / 512.0;
/// A cell that is erased by more than this is unpainted again.
constexpr double kErased = 0.995;
constexpr int kMostReach = 16;

/// Squared distance of p from the segment a..b.
double squaredDistance(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d ab = b - a;
  const Vec2d ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double t = square > 0.0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / square, 0.0, 1.0) : 0.0;
  const Vec2d d = ap - ab * t;
  return d.x * d.x + d.y * d.y;
}

int widthOf(const PaintedLayer& layer) {
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer)) return numbers->width();
  return std::get<TiledRaster<float>>(layer).width();
}

int heightOf(const PaintedLayer& layer) {
  if (const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&layer)) return numbers->height();
  return std::get<TiledRaster<float>>(layer).height();
}

}  // namespace

BrushStroke::BrushStroke(PaintedLayer layer, const Raster<float>& grid, const PaintedKind& kind,
                         const StrokeTask& task)
    : m_before(layer),
      m_layer(std::move(layer)),
      m_kind(kind),
      m_originX(grid.originX),
      m_originY(grid.originY),
      m_cellSize(grid.cellSize),
      m_width(grid.width),
      m_height(grid.height),
      m_task(task),
      m_covered(grid.width, grid.height, 0.0f) {
  SPIN_CHECK_EQ(widthOf(m_layer), grid.width);
  SPIN_CHECK_EQ(heightOf(m_layer), grid.height);
  SPIN_CHECK(kind.numbers == std::holds_alternative<TiledRaster<std::uint8_t>>(m_layer), "layer's kind");
  if (task.mode != BrushMode::Smooth) return;
  const int reach =
      static_cast<int>(std::clamp(std::round(0.25 * task.tip.radius / m_cellSize), 1.0, double{kMostReach}));
  if (kind.numbers)
    m_smoothNumbers =
        std::make_unique<LayerSmoother<std::uint8_t>>(std::get<TiledRaster<std::uint8_t>>(m_before), reach);
  else
    m_smoothMeasures = std::make_unique<LayerSmoother<float>>(std::get<TiledRaster<float>>(m_before), reach);
}

void BrushStroke::moveTo(Vec2d position, const BrushPress& press) {
  const Vec2d from = m_last.value_or(position);
  m_last = position;
  BrushTip tip = m_task.tip;
  tip.radius *= press.radius;
  const double strength = std::clamp(tip.strength * press.strength, 0.0, 1.0);
  const auto cellOf = [&](double p, double origin) { return (p - origin) / m_cellSize; };
  const auto clampTo = [](double cell, int count) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count)));
  };
  const int i0 = clampTo(std::ceil(cellOf(std::min(from.x, position.x) - tip.radius, m_originX)), m_width);
  const int i1 =
      clampTo(std::floor(cellOf(std::max(from.x, position.x) + tip.radius, m_originX)) + 1, m_width);
  const int j0 = clampTo(std::ceil(cellOf(std::min(from.y, position.y) - tip.radius, m_originY)), m_height);
  const int j1 =
      clampTo(std::floor(cellOf(std::max(from.y, position.y) + tip.radius, m_originY)) + 1, m_height);
  const double radius = tip.radius * tip.radius;
  const auto most = static_cast<float>(strength);
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) {
      // Most cells under a wide brush had all of it a moment ago.
      if (!m_kind.numbers && m_covered.at(i, j) >= most) continue;
      const Vec2d centre{m_originX + i * m_cellSize, m_originY + j * m_cellSize};
      const double square = squaredDistance(centre, from, position);
      if (square <= radius) visit(i, j, m_kind.numbers ? 1.0 : strength * tip.weight(std::sqrt(square)));
    }
  visit(static_cast<int>(std::lround(std::clamp(cellOf(position.x, m_originX), -1.0, 1e8))),
        static_cast<int>(std::lround(std::clamp(cellOf(position.y, m_originY), -1.0, 1e8))), strength);
}

void BrushStroke::visit(int i, int j, double weight) {
  if (i < 0 || j < 0 || i >= m_width || j >= m_height) return;
  if (m_kind.numbers)
    paintNumber(i, j);
  else
    paintMeasure(i, j, weight);
}

void BrushStroke::paintNumber(int i, int j) {
  auto& layer = std::get<TiledRaster<std::uint8_t>>(m_layer);
  auto value = static_cast<std::uint8_t>(m_task.value);
  if (m_task.mode == BrushMode::Erase) value = static_cast<std::uint8_t>(m_kind.blank);
  if (m_task.mode == BrushMode::Smooth) value = m_smoothNumbers->at(i, j);
  if (layer.at(i, j) == value) return;
  layer.set(i, j, value);
  m_changed = true;
}

void BrushStroke::paintMeasure(int i, int j, double weight) {
  if (weight < kLeastWeight || static_cast<float>(weight) <= m_covered.at(i, j)) return;
  m_covered.set(i, j, static_cast<float>(weight));
  auto& layer = std::get<TiledRaster<float>>(m_layer);
  const float old = std::get<TiledRaster<float>>(m_before).at(i, j);
  const float value = worked(old, i, j, weight);
  const float now = layer.at(i, j);
  if (value == now || (std::isnan(value) && std::isnan(now))) return;
  layer.set(i, j, value);
  m_changed = true;
}

/// What a cell becomes that had `old` before the stroke and is covered by so much of it.
float BrushStroke::worked(float old, int i, int j, double covered) {
  const bool blank = std::isnan(old) || old == m_kind.blank;
  const double before = std::isnan(old) ? m_task.base : static_cast<double>(old);
  double goal = m_task.value;
  if (m_task.mode == BrushMode::Smooth) {
    if (std::isnan(old)) return old;
    goal = static_cast<double>(m_smoothMeasures->at(i, j));
  }
  if (m_task.mode == BrushMode::Erase) {
    if (blank || covered > kErased) return m_kind.blank;
    goal = m_task.base;
  }
  return static_cast<float>(std::clamp(before + covered * (goal - before), m_kind.least, m_kind.most));
}

}  // namespace spin
