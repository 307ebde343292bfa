// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The pointer and keys of the viewport.
#include <QKeyEvent>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>

#include "core/nodes/flow_nodes.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

constexpr double kWheelUnitsPerStep = 120.0;
constexpr double kClickPixels = 4.0;

Vec2d pixelOf(const QPointF& point) {
  return {point.x(), point.y()};
}

}  // namespace

bool Viewport::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_surface) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return release(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
      if (!tablet(*static_cast<QTabletEvent*>(event))) return false;
      event->accept();
      return true;
    case QEvent::KeyRelease:
      followKeys(*static_cast<QKeyEvent*>(event), false);
      return brushKey(*static_cast<QKeyEvent*>(event));
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
      followKeys(*static_cast<QKeyEvent*>(event), true);
      if (!keyPress(*static_cast<QKeyEvent*>(event))) return false;
      event->accept();
      return true;
    case QEvent::Leave:
      m_pointerInside = false;
      scheduleReading();
      m_brush.leave();
      m_hovered = GizmoHandle::None;
      updateOverlay();
      return false;
    default:
      return false;
  }
}

/// What a held key makes of a brush shows at once, not when the pointer moves next.
void Viewport::followKeys(const QKeyEvent& event, bool down) {
  const Qt::KeyboardModifier key = event.key() == Qt::Key_Shift     ? Qt::ShiftModifier
                                   : event.key() == Qt::Key_Control ? Qt::ControlModifier
                                                                    : Qt::NoModifier;
  if (key == Qt::NoModifier || !hasTip()) return;
  m_keys.setFlag(key, down);
  updateOverlay();
}

/// True for keys that mean something here; others go on to the window's shortcuts.
bool Viewport::keyPress(const QKeyEvent& event) {
  if (event.key() == Qt::Key_Escape) return cancelEdit();
  if (brushKey(event)) return true;
  if (event.key() != Qt::Key_Delete && event.key() != Qt::Key_Backspace) return false;
  if (m_tool != Tool::Outline || editing() || !m_shape.withoutCorner(context(), m_pointer)) return false;
  // The announcement of a shortcut comes first; the press that follows does the work.
  return event.type() == QEvent::ShortcutOverride || removeCorner();
}

bool Viewport::removeCorner() {
  const auto values = m_shape.withoutCorner(context(), m_pointer);
  if (!values) return false;
  Q_EMIT editStarted();
  Q_EMIT shapeEdited(m_shape.node(), *values);
  Q_EMIT editFinished();
  updateOverlay();
  return true;
}

bool Viewport::press(const QMouseEvent& event) {
  if (editing()) return true;
  if (m_adjust) return adjust(event);
  if (m_navigator.press(event)) {
    leaveLookThrough();
    return true;
  }
  if (event.button() != Qt::LeftButton) return false;
  m_pressed = event.position();
  m_clicking = !beginEdit(event);
  return true;
}

bool Viewport::beginEdit(const QMouseEvent& event) {
  const Vec2d pixel = pixelOf(event.position());
  const ViewportContext seen = context();
  if (m_tool == Tool::Brush) return beginBrush(pixel, event.modifiers());
  if (m_tool == Tool::Scatter) return beginScatter(pixel, event.modifiers());
  if (beginShape(pixel)) return true;
  if (m_tool == Tool::Select || m_tool == Tool::Outline || !m_gizmo.begin(seen, pixel)) return false;
  Q_EMIT editStarted();
  return true;
}

/// Grabs a handle of the selected node that is not a model; the outline tool also adds corners.
bool Viewport::beginShape(Vec2d pixel) {
  const ViewportContext seen = context();
  if (m_tool != Tool::Outline) {
    if (!m_shape.begin(seen, pixel)) return false;
    Q_EMIT editStarted();
    return true;
  }
  if (m_shape.beginOutline(seen, pixel)) {
    Q_EMIT editStarted();
    Q_EMIT shapeEdited(m_shape.node(), m_shape.drag(seen, pixel, {}));
    return true;
  }
  const auto hit = m_scene ? pickTerrain(*m_scene, seen.view.ray(pixel)) : std::nullopt;
  const SceneNode* node = findShapeNode(seen, m_selected);
  if (!hit || (node && node->as<AvalancheReleaseNode>())) return false;
  Q_EMIT outlineWanted({hit->x, hit->y});
  return true;
}

void Viewport::dragShape(const QMouseEvent& event) {
  const DragKeys keys{event.modifiers().testFlag(Qt::ControlModifier),
                      event.modifiers().testFlag(Qt::ShiftModifier)};
  m_surface->setMoving(true);
  Q_EMIT shapeEdited(m_shape.node(), m_shape.drag(context(), pixelOf(event.position()), keys));
  updateOverlay();
}

bool Viewport::move(const QMouseEvent& event) {
  const Vec2d pixel = pixelOf(event.position());
  m_pointer = pixel;
  m_pointerInside = true;
  scheduleReading();
  m_keys = event.modifiers();
  if (m_adjust) return adjust(event);
  if (m_navigator.move(event, m_surface->height())) {
    cameraMoved();
    return true;
  }
  if (m_gizmo.dragging()) {
    const bool snap = event.modifiers().testFlag(Qt::ControlModifier);
    m_surface->setMoving(true);
    Q_EMIT placementEdited(m_gizmo.node(), m_gizmo.drag(context(), pixel, snap));
    return true;
  }
  if (m_shape.dragging()) {
    dragShape(event);
    return true;
  }
  if (m_scatter.scattering()) {
    dragScatter(pixel);
    return true;
  }
  if (m_brush.painting()) {
    m_surface->setMoving(true);
    if (m_brush.drag(context(), pixel, m_pressure))
      Q_EMIT layerPainted(m_brush.kind(), m_brush.node(), m_brush.layer());
    updateOverlay();
    return true;
  }
  hover(pixel);
  return false;
}

void Viewport::hover(Vec2d pixel) {
  if (hasTip()) {
    m_brush.hover(context(), pixel);
    updateOverlay();
  } else {
    const GizmoHandle handle =
        m_tool == Tool::Select ? GizmoHandle::None : m_gizmo.handleAt(context(), pixel);
    if (handle != m_hovered || findShapeNode(context(), m_selected)) updateOverlay();
    m_hovered = handle;
  }
}

bool Viewport::release(const QMouseEvent& event) {
  if (m_adjust) return adjust(event);
  if (m_navigator.release(event)) {
    m_surface->setMoving(false);
    return true;
  }
  if (event.button() != Qt::LeftButton) return false;
  if (editing()) {
    endEdit();
    return true;
  }
  const QPointF travel = event.position() - m_pressed;
  const bool selects = !hasTip() && m_tool != Tool::Outline;
  if (m_clicking && travel.manhattanLength() <= kClickPixels && selects && m_scene) {
    const ViewportContext seen = context();
    const Vec2d pixel = pixelOf(event.position());
    std::string clicked = shapeNodeAt(seen, pixel);
    if (clicked.empty())
      if (const auto hit = pickScene(*m_scene, m_filmTime, seen.view.ray(pixel))) clicked = hit->node;
    Q_EMIT nodeClicked(clicked);
  }
  m_clicking = false;
  return true;
}

void Viewport::letGo() {
  m_gizmo.end();
  m_brush.end();
  m_shape.end();
  m_scatter.end();
  m_surface->setMoving(false);
  updateOverlay();
}

void Viewport::endEdit() {
  letGo();
  Q_EMIT editFinished();
}

bool Viewport::cancelEdit() {
  if (m_adjust) {
    endAdjust(false);
    return true;
  }
  if (!editing()) return false;
  letGo();
  Q_EMIT editCancelled();
  return true;
}

bool Viewport::wheel(const QWheelEvent& event) {
  const double steps = event.angleDelta().y() / kWheelUnitsPerStep;
  if (steps == 0.0) return false;
  if (hasTip() && event.modifiers().testFlag(Qt::ControlModifier)) {
    setBrushRadius(steppedBrushRadius(m_brush.tip().radius, steps > 0 ? 1 : -1));
    return true;
  }
  leaveLookThrough();
  Vec3d anchor = m_navigator.camera().pivot();
  const ViewportContext seen = context();
  const ViewRay ray = seen.view.ray(pixelOf(event.position()));
  const auto hit = m_scene ? pickScene(*m_scene, m_filmTime, ray) : std::nullopt;
  // Without a hit the point at the pivot's depth under the pointer keeps its place.
  if (hit)
    anchor = hit->point;
  else if (const auto plane = intersectPlane(ray, anchor, seen.view.forward()))
    anchor = *plane;
  m_navigator.wheel(steps, anchor);
  cameraMoved();
  return true;
}

}  // namespace spin
