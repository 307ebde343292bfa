// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "editor/viewport/node_shape.h"

namespace spin {

/// How the pointer's way is read while a handle is dragged.
struct DragKeys {
  bool snap = false;  ///< whole metres
  bool lift = false;  ///< up and down instead of along the ground
};

/// Handles of the selected node that is not a model: what is grabbed and what the node's properties become.
/// Tells values; changes nothing itself. Each step of a drag is computed from its start.
class ShapeGizmo {
 public:
  using Values = ShapeValues;

  void setNode(std::string id) { m_node = std::move(id); }
  const std::string& node() const { return m_node; }

  /// The handle under the pointer.
  std::optional<ShapePoint> pointAt(const ViewportContext& context, Vec2d pixel) const;
  /// True if a handle is grabbed.
  bool begin(const ViewportContext& context, Vec2d pixel);
  /// Draws a release's outline: grabs the corner under the pointer, or puts one on the side that is there, or
  /// behind the last one where the terrain is met. False where none of these is.
  bool beginOutline(const ViewportContext& context, Vec2d pixel);
  bool dragging() const { return m_grab.has_value(); }
  /// The grabbed handle; requires dragging().
  const ShapePoint& grabbed() const { return m_grab->point; }
  /// Values for the pointer; requires dragging(). Where its ray tells nothing, those of the start.
  Values drag(const ViewportContext& context, Vec2d pixel, DragKeys keys);
  void end() { m_grab.reset(); }

  /// The outline without the corner under the pointer; nothing where there is none.
  std::optional<Values> withoutCorner(const ViewportContext& context, Vec2d pixel) const;

 private:
  struct Grab {
    ShapePoint point;
    std::shared_ptr<const NodeData> start;
    PlanPoints outline;  ///< of a release, with a corner that was put in
    Vec3d offset{};      ///< from the pointer's place to the handle's
  };
  void grab(const ViewportContext& context, const ShapePoint& point, PlanPoints outline, Vec2d pixel);

  std::string m_node;
  std::optional<Grab> m_grab;
};

}  // namespace spin
