// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "core/property/property_table.h"

namespace spin {

/// What the painted layer of a type of node holds (SceneNode::painted).
struct PaintedKind {
  const NodeType* type;
  /// Whole numbers (uint8 raster) that are names of things, so that nothing lies between two of them;
  /// otherwise a float raster.
  bool numbers;
  float blank;         ///< value of the cells that nobody painted; may be NaN
  double least, most;  ///< SI, of painted cells, inclusive
  double low, high;    ///< SI: range that pictures and brushes begin with
  Unit unit;
  const char* label;     ///< SPIN_TR, as the user knows it
  const char* name;      ///< as files name it
  const char* fileUnit;  ///< of the values in files, which are SI: "K"

  bool holds(double value) const { return value >= least && value <= most; }
};

/// All kinds, in the order menus show them.
std::span<const PaintedKind> paintedKinds();
/// nullptr if nodes of the type carry no painted layer.
const PaintedKind* paintedKind(const NodeType& type);

}  // namespace spin
