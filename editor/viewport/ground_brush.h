// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "editor/viewport/brush_stroke.h"
#include "editor/viewport/model_gizmo.h"

namespace spin {

/// The brush in the view: what it paints with, where it is on the terrain and the stroke in work. Each kind
/// of layer has a value of its own.
class GroundBrush {
 public:
  GroundBrush();

  const BrushTip& tip() const { return m_tip; }
  /// Radius, hardness and strength are kept within what is possible.
  void setTip(const BrushTip& tip);
  BrushMode mode() const { return m_mode; }
  void setMode(BrushMode mode) { m_mode = mode; }
  /// Which layer is painted: its kind, and the node where there may be several; an empty node is the first of
  /// the kind.
  const PaintedKind& kind() const { return *m_kind; }
  const std::string& node() const { return m_node; }
  void setLayer(const PaintedKind& kind, std::string node);
  /// SI, of the kind that is painted now.
  double value() const;
  void setValue(double si);
  bool pressesStrength() const { return m_pressesStrength; }
  void setPressesStrength(bool on) { m_pressesStrength = on; }
  bool pressesRadius() const { return m_pressesRadius; }
  void setPressesRadius(bool on) { m_pressesRadius = on; }

  /// Follows the pointer without painting.
  void hover(const ViewportContext& context, Vec2d pixel);
  void leave() { m_position.reset(); }
  const std::optional<Vec3d>& position() const { return m_position; }
  /// A circle round the brush, draped on the terrain, with a share of the radius; empty where the pointer is
  /// not over it.
  std::vector<Vec3d> ring(const ViewportContext& context, double share) const;
  /// What is painted, or else holds, under the pointer; nothing where that is not known.
  std::optional<double> valueHere(const ViewportContext& context) const;

  /// Begins a stroke on a layer of the kind and of the terrain's size; false beside the terrain. `mode` may
  /// differ from mode(); not Pick.
  bool begin(const ViewportContext& context, Vec2d pixel, BrushMode mode, PaintedLayer layer,
             double pressure = 1.0);
  /// Goes on painting; true if cells changed.
  bool drag(const ViewportContext& context, Vec2d pixel, double pressure = 1.0);
  bool painting() const { return m_stroke.has_value(); }
  /// The layer with the stroke; requires painting().
  const PaintedLayer& layer() const { return m_stroke->layer(); }
  void end() { m_stroke.reset(); }

 private:
  BrushPress pressOf(double pressure) const;
  void work(double pressure);

  BrushTip m_tip;
  BrushMode m_mode = BrushMode::Paint;
  const PaintedKind* m_kind;
  std::string m_node;
  std::map<const PaintedKind*, double> m_values;
  bool m_pressesStrength = true;
  bool m_pressesRadius = false;
  std::optional<Vec3d> m_position;
  std::optional<BrushStroke> m_stroke;
};

/// Whether a layer has a terrain's size.
bool hasSize(const PaintedLayer& layer, const Raster<float>& heights);
/// The node of a kind that is painted: the named one, else the first; null if there is none.
const SceneNode* paintedNode(const SceneSnapshot& scene, const PaintedKind& kind, const std::string& id);
/// What is painted on it; a blank layer where nothing is or its size is not the terrain's. Requires terrain.
PaintedLayer paintedLayer(const SceneSnapshot& scene, const PaintedKind& kind, const std::string& id);
/// What holds where nothing is painted: the base temperature, the old snow that painted snow replaces; 0
/// elsewhere. SI.
double unpaintedValue(const SceneSnapshot& scene, const PaintedKind& kind, double filmTime);

}  // namespace spin
