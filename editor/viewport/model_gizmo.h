// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "core/sim/snapshot.h"
#include "editor/viewport/gizmo.h"

namespace spin {

/// What the tools see when they handle the pointer.
struct ViewportContext {
  SnapshotPointer scene;
  double filmTime = 0.0;
  ViewFrame view;
};

/// The gizmo on a model node: it reads the node's placement from the snapshot and knows that a model on the
/// ground moves along the terrain and stores its height above it.
class ModelGizmo {
 public:
  void setMode(GizmoMode mode) { m_mode = mode; }
  GizmoMode mode() const { return m_mode; }
  void setAxes(GizmoAxes axes) { m_axes = axes; }
  GizmoAxes axes() const { return m_axes; }
  void setNode(std::string id) { m_node = std::move(id); }
  const std::string& node() const { return m_node; }

  /// Where the gizmo stands; nothing where the node is not an enabled model.
  std::optional<GizmoPose> pose(const ViewportContext& context) const;
  GizmoHandle handleAt(const ViewportContext& context, Vec2d pixel) const;

  /// True if the pointer grabs a handle.
  bool begin(const ViewportContext& context, Vec2d pixel);
  bool dragging() const { return m_drag.has_value(); }
  GizmoHandle activeHandle() const { return m_drag ? m_drag->handle() : GizmoHandle::None; }
  /// Placement of the node for the pointer; requires dragging().
  GizmoPlacement drag(const ViewportContext& context, Vec2d pixel, bool snap);
  /// The placement before the drag; requires dragging().
  const GizmoPlacement& start() const { return m_drag->start(); }
  void end() { m_drag.reset(); }

 private:
  GizmoPlacement onGround(const ViewportContext& context, Vec2d pixel, GizmoPlacement free, bool snap) const;

  GizmoMode m_mode = GizmoMode::Move;
  GizmoAxes m_axes = GizmoAxes::World;
  std::string m_node;
  std::optional<GizmoDrag> m_drag;
  std::optional<Vec3d> m_groundGrab;
  bool m_onGround = false;
};

}  // namespace spin
