// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// The brush for copies of a model in the viewport.
#include <QLocale>
#include <QPainter>

#include "core/fields/terrain_surface.h"
#include "core/nodes/terrain_node.h"
#include "editor/viewport/overlay_painter.h"
#include "editor/viewport/picture_view.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

constexpr std::size_t kMostDots = 4000;

}  // namespace

void Viewport::setScatterDensity(double perSquareMetre) {
  m_scatter.setDensity(perSquareMetre);
  Q_EMIT scatterChanged();
}

void Viewport::setScatterDistance(double metres) {
  m_scatter.setDistance(metres);
  Q_EMIT scatterChanged();
}

void Viewport::setScatterErases(bool on) {
  m_scatter.setErases(on);
  updateOverlay();
  Q_EMIT scatterChanged();
}

/// Copies are of the selected model, else of the last one that was, else of any.
void Viewport::followModel() {
  if (m_scatter.scattering()) return;
  const SceneNode* node = nullptr;
  if (m_scene) {
    node = modelToCopy(*m_scene, m_selected);
    if (node && node->id != m_selected) node = modelToCopy(*m_scene, m_scatter.node());
  }
  m_scatter.setNode(node ? node->id : std::string());
  Q_EMIT scatterChanged();
}

PlanPoints Viewport::copiesToPaint() const {
  if (copiesSource)
    if (std::optional<PlanPoints> copies = copiesSource(m_scatter.node())) return *copies;
  const SceneNode* node = m_scene ? modelToCopy(*m_scene, m_scatter.node()) : nullptr;
  const auto* model = node ? node->as<ModelNode>() : nullptr;
  return model ? model->copies : PlanPoints();
}

bool Viewport::scatterErases(Qt::KeyboardModifiers keys) const {
  return m_scatter.erases() != keys.testFlag(Qt::ShiftModifier);
}

bool Viewport::beginScatter(Vec2d pixel, Qt::KeyboardModifiers keys) {
  const ViewportContext seen = context();
  m_brush.hover(seen, pixel);
  if (keys.testFlag(Qt::ControlModifier)) {
    const auto hit = m_scene ? pickScene(*m_scene, m_filmTime, seen.view.ray(pixel)) : std::nullopt;
    const SceneNode* model = hit ? modelToCopy(*m_scene, hit->node) : nullptr;
    if (!model || model->id != hit->node) return false;
    Q_EMIT nodeClicked(hit->node);
    return true;
  }
  if (!m_brush.position()) return false;
  const Vec2d place{m_brush.position()->x, m_brush.position()->y};
  if (!m_scatter.begin(seen, place, m_brush.tip().radius, scatterErases(keys), copiesToPaint())) return false;
  Q_EMIT editStarted();
  if (m_scatter.stroke().change() != 0) Q_EMIT copiesScattered(m_scatter.node(), m_scatter.stroke().copies());
  updateOverlay();
  return true;
}

void Viewport::dragScatter(Vec2d pixel) {
  m_brush.hover(context(), pixel);
  if (m_brush.position() && m_scatter.drag({m_brush.position()->x, m_brush.position()->y})) {
    m_surface->setMoving(true);
    Q_EMIT copiesScattered(m_scatter.node(), m_scatter.stroke().copies());
  }
  updateOverlay();
}

/// The ring, dots where copies stand near it, and how many there are.
void Viewport::paintScatter(QPainter& painter, const ViewportContext& seen) const {
  if (!m_brush.position()) return;
  const bool erases = scatterErases(m_keys);
  const QColor colour = erases ? QColor(255, 150, 130) : QColor(160, 235, 150);
  const bool picks = m_keys.testFlag(Qt::ControlModifier);
  if (!picks) paintLoop(painter, seen.view, m_brush.ring(seen, 1.0), colour);
  const auto middle = seen.view.project(*m_brush.position());
  if (!middle) return;
  const QPointF at(middle->x, middle->y);
  if (m_adjust)
    return paintTag(painter, at, tr("Radius %1 m").arg(locale().toString(m_brush.tip().radius, 'f', 1)));
  if (m_scatter.node().empty())
    return paintTag(painter, at, tr("There is no model to copy: import one first"));
  if (picks) return paintTag(painter, at, tr("Click on the model to copy"));
  const bool works = m_scatter.scattering();
  const PlanPoints copies = works ? m_scatter.stroke().copies() : copiesToPaint();
  paintCopies(painter, seen, copies, colour);
  QString text = tr("Copies: %1").arg(copies.size());
  if (works) {
    const int change = m_scatter.stroke().change();
    text += QStringLiteral(" (%1%2)").arg(change < 0 ? QString() : QStringLiteral("+")).arg(change);
  }
  if (works && m_scatter.stroke().full()) text = tr("Copies: %1, no more are possible").arg(copies.size());
  paintTag(painter, at, text);
}

void Viewport::paintCopies(QPainter& painter, const ViewportContext& seen, const PlanPoints& copies,
                           const QColor& colour) const {
  if (!seen.scene || !seen.scene->terrain) return;
  const TerrainSurface surface(seen.scene->terrain->heights);
  const double reach = 2.0 * m_brush.tip().radius;
  painter.setPen(QPen(QColor(0, 0, 0, 160), 1.0));
  painter.setBrush(colour);
  std::size_t drawn = 0;
  for (const Vec2d& p : copies) {
    const Vec2d d{p.x - m_brush.position()->x, p.y - m_brush.position()->y};
    if (d.x * d.x + d.y * d.y > reach * reach || ++drawn > kMostDots) continue;
    const auto at = seen.view.project({p.x, p.y, surface.nearestHeight(p.x, p.y)});
    if (at) painter.drawEllipse(QPointF(at->x, at->y), 2.6, 2.6);
  }
  painter.setBrush(Qt::NoBrush);
}

}  // namespace spin
