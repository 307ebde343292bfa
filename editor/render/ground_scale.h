// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/property/property_table.h"
#include "editor/render/renderer.h"

namespace spin {

struct PaintedKind;

/// A colour that a number or a name of a painted layer has.
struct GroundStop {
  double value;  ///< SI, or the number of a name
  Vec3d colour;  ///< linear RGB
};

/// How the values of a painted layer become colours: straight between stops, which ascend; beyond the ends
/// the end's colour.
struct GroundScale {
  const PaintedKind* kind;
  std::vector<GroundStop> stops;
  Vec3d unpainted;                 ///< colour of what nobody painted, unless a base value holds there
  std::vector<const char*> names;  ///< of names, by stop, context "Properties"; empty for measures

  Vec3d colour(double value) const;
};

/// The scale of a display; null for Natural.
const GroundScale* groundScale(GroundDisplay display);
/// The display that shows what nodes of a kind paint; Natural for those that no display shows.
GroundDisplay displayOf(const PaintedKind& kind);
/// Colour of a bare ground type among false colours: lighter than in nature, where types are too dark to tell
/// apart.
Vec3d falseTypeColour(int type);

}  // namespace spin
