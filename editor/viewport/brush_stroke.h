// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "core/fields/raster.h"
#include "core/math/vec.h"
#include "core/nodes/painted_kinds.h"
#include "core/property/scene_node.h"
#include "editor/viewport/brush_tip.h"
#include "editor/viewport/layer_smoother.h"

namespace spin {

/// What one stroke works with.
struct StrokeTask {
  BrushMode mode = BrushMode::Paint;  ///< not Pick
  BrushTip tip;
  double value = 0.0;  ///< SI, that is painted
  double base = 0.0;   ///< what holds where nothing is painted: soft edges lead there
};

/// One stroke of a brush: a round tip dragged over a painted layer. A cell gets the largest weight that any
/// point of the way gives it, and what it had before the stroke is led towards the value by that share: going
/// over it again within a stroke, or slowly, changes nothing, so the result does not depend on how often the
/// pointer reports. Names are painted whole within the radius. At least the cell under the pointer is
/// painted. Tiles that the stroke does not touch stay shared with the layer it began with.
class BrushStroke {
 public:
  /// The layer must have the size of the grid and be of the kind; only the grid's geometry is read.
  BrushStroke(PaintedLayer layer, const Raster<float>& grid, const PaintedKind& kind, const StrokeTask& task);

  /// Paints from the last position (or at this one, for the first) to here; local metres.
  void moveTo(Vec2d position, const BrushPress& press = {});
  const PaintedLayer& layer() const { return m_layer; }
  /// True once a cell got another value than it had.
  bool changed() const { return m_changed; }

 private:
  void visit(int i, int j, double weight);
  void paintNumber(int i, int j);
  void paintMeasure(int i, int j, double weight);
  float worked(float old, int i, int j, double covered);

  PaintedLayer m_before, m_layer;
  const PaintedKind& m_kind;
  double m_originX, m_originY, m_cellSize;
  int m_width, m_height;
  StrokeTask m_task;
  TiledRaster<float> m_covered;  ///< of measures: largest weight so far
  std::unique_ptr<LayerSmoother<float>> m_smoothMeasures;
  std::unique_ptr<LayerSmoother<std::uint8_t>> m_smoothNumbers;
  std::optional<Vec2d> m_last;
  bool m_changed = false;
};

}  // namespace spin
