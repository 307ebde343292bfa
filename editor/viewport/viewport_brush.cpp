// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The brush in the viewport: strokes, picking, changing the tip by keys, pens.
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>

#include "editor/viewport/overlay_painter.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

Vec2d pixelOf(const QPointF& point) {
  return {point.x(), point.y()};
}

QColor colourOf(BrushMode mode) {
  switch (mode) {
    case BrushMode::Paint:
      return QColor(255, 235, 150);
    case BrushMode::Smooth:
      return QColor(140, 205, 255);
    case BrushMode::Erase:
      return QColor(255, 150, 130);
    case BrushMode::Pick:
      break;
  }
  return QColor(235, 235, 235);
}

}  // namespace

void Viewport::setBrushTip(const BrushTip& tip) {
  const BrushTip before = m_brush.tip();
  m_brush.setTip(tip);
  const BrushTip& now = m_brush.tip();
  if (now.radius == before.radius && now.hardness == before.hardness && now.strength == before.strength)
    return;
  updateOverlay();
  if (now.radius != before.radius) Q_EMIT brushRadiusChanged(now.radius);
  Q_EMIT brushChanged();
}

void Viewport::setBrushRadius(double metres) {
  BrushTip tip = m_brush.tip();
  tip.radius = metres;
  setBrushTip(tip);
}

void Viewport::setBrushMode(BrushMode mode) {
  if (mode == m_brush.mode()) return;
  m_brush.setMode(mode);
  updateOverlay();
  Q_EMIT brushChanged();
}

void Viewport::setBrushValue(double si) {
  if (si == m_brush.value()) return;
  m_brush.setValue(si);
  Q_EMIT brushChanged();
}

void Viewport::setBrushPressure(bool onStrength, bool onRadius) {
  m_brush.setPressesStrength(onStrength);
  m_brush.setPressesRadius(onRadius);
  Q_EMIT brushChanged();
}

void Viewport::setBrushLayer(const PaintedKind& kind, const std::string& node) {
  if (m_brush.painting()) return;
  m_chosenKind = &kind;
  if (&kind == &m_brush.kind() && node == m_brush.node()) return;
  m_brush.setLayer(kind, node);
  updateGround();
  Q_EMIT brushChanged();
}

/// Held keys change what a stroke does, without a way to the tool bar.
BrushMode Viewport::modeFor(Qt::KeyboardModifiers keys) const {
  if (keys.testFlag(Qt::ControlModifier)) return BrushMode::Pick;
  if (keys.testFlag(Qt::ShiftModifier)) return BrushMode::Smooth;
  return m_brush.mode();
}

PaintedLayer Viewport::layerToPaint() const {
  if (layerSource)
    if (std::optional<PaintedLayer> layer = layerSource(m_brush.kind(), m_brush.node())) return *layer;
  return paintedLayer(*m_scene, m_brush.kind(), m_brush.node());
}

bool Viewport::beginBrush(Vec2d pixel, Qt::KeyboardModifiers keys) {
  const ViewportContext seen = context();
  m_brush.hover(seen, pixel);
  if (!m_brush.position()) return false;
  const BrushMode mode = modeFor(keys);
  if (mode == BrushMode::Pick) return pick();
  if (!m_brush.begin(seen, pixel, mode, layerToPaint(), m_pressure)) return false;
  Q_EMIT editStarted();
  Q_EMIT layerPainted(m_brush.kind(), m_brush.node(), m_brush.layer());
  return true;
}

/// Takes the value under the pointer; what was picked is wanted for painting.
bool Viewport::pick() {
  const std::optional<double> value = m_brush.valueHere(context());
  if (!value) return false;
  setBrushValue(*value);
  if (m_brush.mode() == BrushMode::Pick) setBrushMode(BrushMode::Paint);
  return true;
}

/// F and Shift+F change the tip while the brush is the tool.
bool Viewport::brushKey(const QKeyEvent& event) {
  const bool plain = !(event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier));
  if (!hasTip() || event.key() != Qt::Key_F || !plain || editing()) return false;
  if (event.isAutoRepeat()) return true;
  if (event.type() == QEvent::KeyRelease) {
    if (m_adjust && m_adjust->moved()) endAdjust(true);
    return true;
  }
  if (event.type() == QEvent::ShortcutOverride) return true;
  if (m_adjust) {
    endAdjust(true);
    return true;
  }
  const bool strength = m_tool == Tool::Brush && event.modifiers().testFlag(Qt::ShiftModifier);
  m_adjust.emplace(strength ? BrushAdjust::What::Strength : BrushAdjust::What::Radius, m_brush.tip(),
                   m_pointer);
  updateOverlay();
  return true;
}

/// The pointer while the tip is being changed: moving changes it, a click ends it, the right button takes it
/// back.
bool Viewport::adjust(const QMouseEvent& event) {
  if (event.type() == QEvent::MouseMove)
    setBrushTip(m_adjust->at(pixelOf(event.position())));
  else if (event.button() == Qt::RightButton)
    endAdjust(false);
  else if (event.type() == QEvent::MouseButtonRelease)
    endAdjust(true);
  return true;
}

void Viewport::endAdjust(bool keep) {
  if (!m_adjust) return;
  const BrushTip before = m_adjust->start();
  m_adjust.reset();
  if (!keep) setBrushTip(before);
  m_brush.hover(context(), m_pointer);
  updateOverlay();
}

/// A pen works as the left button with pressure.
bool Viewport::tablet(const QTabletEvent& event) {
  const auto as = [&event](QEvent::Type type) {
    return QMouseEvent(type, event.position(), event.globalPosition(), event.button(), event.buttons(),
                       event.modifiers());
  };
  m_pressure = event.pressure();
  bool done = false;
  if (event.type() == QEvent::TabletPress) done = press(as(QEvent::MouseButtonPress));
  if (event.type() == QEvent::TabletMove) done = move(as(QEvent::MouseMove));
  if (event.type() == QEvent::TabletRelease) done = release(as(QEvent::MouseButtonRelease));
  m_pressure = 1.0;
  return done || event.type() == QEvent::TabletMove;
}

void Viewport::paintBrush(QPainter& painter, const ViewportContext& seen) const {
  const BrushMode mode = modeFor(m_keys);
  const QColor colour = colourOf(mode);
  const std::vector<Vec3d> rim = m_brush.ring(seen, 1.0);
  if (mode != BrushMode::Pick) paintLoop(painter, seen.view, rim, colour);
  const bool soft = !m_brush.kind().numbers && m_brush.tip().hardness < 0.99;
  if (mode != BrushMode::Pick && soft)
    paintLoop(painter, seen.view, m_brush.ring(seen, m_brush.tip().hardness), colour, true);
  if (!m_brush.position()) return;
  const auto middle = seen.view.project(*m_brush.position());
  if (!middle) return;
  const QPointF at(middle->x, middle->y);
  if (m_adjust) {
    const BrushTip& tip = m_brush.tip();
    const bool radius = m_adjust->what() == BrushAdjust::What::Radius;
    paintTag(painter, at,
             radius ? tr("Radius %1 m").arg(locale().toString(tip.radius, 'f', 1))
                    : tr("Strength %1 %").arg(qRound(100.0 * tip.strength)));
  } else if (mode == BrushMode::Pick) {
    const std::optional<double> value = m_brush.valueHere(seen);
    paintTag(painter, at, value ? paintedText(m_brush.kind(), *value) : tr("Nothing is painted here"));
  }
}

}  // namespace spin
