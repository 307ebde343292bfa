// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What the viewport says about itself: what the tool in the hand does, and where the camera's picture ends.
#include <QPainter>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "editor/viewport/overlay_painter.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"

namespace spin {

void Viewport::setShowHints(bool on) {
  m_showHints = on;
  updateOverlay();
}

QString Viewport::toolHint() const {
  const bool ground = m_scene && m_scene->terrain;
  switch (m_tool) {
    case Tool::Brush:
      if (!ground) return tr("There is no terrain to paint on: import one first");
      return tr("Drag to paint. F: radius, Shift + F: strength, Shift: smooth, Ctrl: pick, D: erase");
    case Tool::Scatter:
      if (!ground) return tr("There is no terrain to scatter on: import one first");
      if (m_scatter.node().empty()) return tr("There is no model to copy: import one first");
      return tr(
          "Drag to scatter copies, click for a single one. F: radius, Shift: take away, Ctrl: choose the "
          "model");
    case Tool::Outline: {
      if (!ground) return tr("There is no terrain to draw on: import one first");
      const SceneNode* node = findShapeNode(context(), m_selected);
      if (node && node->as<AvalancheReleaseNode>())
        return tr("Click to add corners, drag to move them, Delete takes out the one under the pointer");
      return tr("Click on the ground to begin the outline of a new avalanche release");
    }
    case Tool::Select:
      break;
    case Tool::Move:
    case Tool::Rotate:
    case Tool::Scale:
      if (m_gizmo.pose(context())) return tr("Drag a handle. Ctrl: whole steps, Escape: take it back");
      if (!nodeShape(context(), m_selected).points.empty())
        return tr("Drag a handle. Ctrl: whole steps, Shift: up and down, Escape: take it back");
      return tr("Select something that stands in the scene to get its handles");
  }
  const SceneNode* selected = selectedNode();
  if (selected && selected->as<AvalancheReleaseNode>() && ground)
    return tr("Drag a corner or the middle. O: add and delete corners, B: paint the release");
  if (!nodeShape(context(), m_selected).points.empty())
    return tr("Drag a handle. Ctrl: whole steps, Shift: up and down, Escape: take it back");
  if (selected && selected->as<ModelNode>())
    return tr("W: move, E: turn, R: scale, S: scatter copies of the selected model");
  if (selected && paintedKind(*selected->type) && ground)
    return tr("B: paint the selected layer; the right button in the list of nodes fills and imports it");
  return tr("Click to select. Middle button or Alt: turn, with Shift: shift the view, wheel: nearer");
}

const SceneNode* Viewport::selectedNode() const {
  if (!m_scene || m_selected.empty()) return nullptr;
  for (const SceneNode& node : m_scene->nodes)
    if (node.id == m_selected) return &node;
  return nullptr;
}

double Viewport::pictureAspect() const {
  const RenderNode picture = m_scene ? m_scene->settings<RenderNode>(m_filmTime) : RenderNode();
  return static_cast<double>(std::max(picture.width, 1)) / std::max(picture.height, 1);
}

QRectF Viewport::pictureFrame() const {
  const QRectF all(m_surface->rect());
  const double aspect = pictureAspect();
  QSizeF size(all.height() * aspect, all.height());
  if (size.width() > all.width()) size = QSizeF(all.width(), all.width() / aspect);
  QRectF frame(QPointF(), size);
  frame.moveCenter(all.center());
  return frame;
}

void Viewport::paintWords(QPainter& painter) const {
  const QRectF all(m_surface->rect());
  if (m_lookThrough) {
    paintFrame(painter, all, pictureFrame());
    paintBadge(painter, tr("Camera view"));
  }
  const bool empty = !m_scene || showsNothing(*m_scene);
  if (empty && !m_hintTitle.isEmpty()) paintHint(painter, all, m_hintTitle, m_hintText);
  if (!empty && m_showHints && !editing()) paintFootnote(painter, all, toolHint());
}

}  // namespace spin
