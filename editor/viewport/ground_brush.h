// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/nodes/ground_nodes.h"
#include "editor/viewport/brush_stroke.h"
#include "editor/viewport/model_gizmo.h"

namespace spin {

/// The brush in the view: where it is on the terrain and the stroke in work. It paints ground types, or the
/// area of a release.
class GroundBrush {
 public:
  double radius() const { return m_radius; }  ///< m
  void setRadius(double metres) { m_radius = metres; }
  /// Number of a GroundType, or kUnpaintedGround to rub out.
  std::uint8_t value() const { return m_value; }
  void setValue(std::uint8_t value) { m_value = value; }
  /// Id of the release whose area is painted; empty = ground types.
  const std::string& release() const { return m_release; }
  void setRelease(std::string node) { m_release = std::move(node); }
  /// Whether the brush takes painted area of a release away.
  bool rubsOut() const { return m_rubsOut; }
  void setRubsOut(bool on) { m_rubsOut = on; }

  /// Follows the pointer without painting.
  void hover(const ViewportContext& context, Vec2d pixel);
  void leave() { m_position.reset(); }
  const std::optional<Vec3d>& position() const { return m_position; }
  /// The brush's rim draped on the terrain; empty where the pointer is not over it.
  std::vector<Vec3d> rim(const ViewportContext& context) const;

  /// Begins a stroke on the release's or the scene's ground type layer, or on a fresh one; false beside the
  /// terrain.
  bool begin(const ViewportContext& context, Vec2d pixel);
  /// Goes on painting; true if cells changed.
  bool drag(const ViewportContext& context, Vec2d pixel);
  bool painting() const { return m_stroke.has_value(); }
  /// The layer with the stroke; requires painting().
  const TiledRaster<std::uint8_t>& layer() const { return m_stroke->layer(); }
  void end() { m_stroke.reset(); }

 private:
  double m_radius = 12.0;
  std::uint8_t m_value = static_cast<std::uint8_t>(GroundType::Rock);
  std::string m_release;
  bool m_rubsOut = false;
  std::optional<Vec3d> m_position;
  std::optional<BrushStroke> m_stroke;
};

/// The painted ground types of a scene; unpainted where there is no layer yet. Requires terrain.
TiledRaster<std::uint8_t> groundTypeLayer(const SceneSnapshot& scene);
/// The painted area of a release; unpainted where there is none yet. Requires terrain.
TiledRaster<std::uint8_t> releaseLayer(const SceneSnapshot& scene, const std::string& node);

}  // namespace spin
