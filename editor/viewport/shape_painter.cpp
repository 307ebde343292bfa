// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/shape_painter.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/viewport/overlay_painter.h"

namespace spin {
namespace {

constexpr double kHiddenMetres = 1.0;  // behind the ground by more than this
constexpr int kHiddenAlpha = 70;

/// Whether the terrain stands between the eye and a point.
bool hidden(const ViewportContext& c, Vec3d point) {
  if (!c.scene->terrain || c.scene->terrain->heights.empty()) return false;
  const Vec3d eye = c.view.camera().position;
  const Vec3d way = point - eye;
  const double distance = length(way);
  if (distance < 1e-6) return false;
  const auto hit = TerrainSurface(c.scene->terrain->heights).raycast(eye, way * (1.0 / distance));
  return hit && length(*hit - eye) < distance - kHiddenMetres - 2e-3 * distance;
}

void paintTip(QPainter& painter, QPointF from, QPointF to) {
  const QPointF along = to - from;
  const double size = std::hypot(along.x(), along.y());
  if (size < 1.0) return;
  const QPointF u = along / size, v(-u.y(), u.x());
  painter.drawPolygon(QPolygonF({to + u * 9.0, to + v * 5.0, to - v * 5.0}));
}

struct Piece {
  QLineF line;
  bool behind = false;  ///< the ground
  bool last = false;    ///< of its line
};

/// What of a line lies before the eye.
std::vector<Piece> piecesOf(const ViewportContext& context, const NodeShape::Line& line) {
  std::vector<Piece> pieces;
  const std::size_t count = line.points.size() - (line.closed ? 0 : 1);
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3d from = line.points[k], to = line.points[(k + 1) % line.points.size()];
    const auto a = context.view.project(from), b = context.view.project(to);
    if (!a || !b) continue;
    pieces.push_back({QLineF(a->x, a->y, b->x, b->y), hidden(context, (from + to) * 0.5), k + 1 == count});
  }
  return pieces;
}

QString inWords(const char* text) {
  return QCoreApplication::translate("Viewport", text);
}

QString number(double v, int digits) {
  return QLocale().toString(v, 'f', digits);
}

QString weatherText(const WeatherNode& weather, ShapeHandle handle) {
  const auto turn = [](double degrees) { return number(degrees - 360.0 * std::floor(degrees / 360.0), 0); };
  if (handle == ShapeHandle::Sun)
    return inWords(QT_TRANSLATE_NOOP("Viewport", "Sun in %1\u00b0, %2\u00b0 high"))
        .arg(turn(weather.sunAzimuthDegrees), number(weather.sunElevationDegrees, 0));
  return inWords(QT_TRANSLATE_NOOP("Viewport", "Wind %1 m/s from %2\u00b0"))
      .arg(number(weather.windSpeed, 1), turn(weather.windFromDegrees));
}

}  // namespace

void paintShapeLines(QPainter& painter, const ViewportContext& context, const NodeShape& shape,
                     bool selected) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = selected ? QColor(255, 196, 92) : QColor(120, 190, 235);
  for (const NodeShape::Line& line : shape.lines) {
    const std::vector<Piece> pieces = piecesOf(context, line);
    // Dark rims of all pieces first, so that they do not cut the line into beads.
    painter.setPen(QPen(QColor(0, 0, 0, 120), selected ? 4.0 : 3.0, Qt::SolidLine, Qt::RoundCap));
    for (const Piece& piece : pieces)
      if (!piece.behind) painter.drawLine(piece.line);
    for (const Piece& piece : pieces) {
      QColor drawn = colour;
      if (piece.behind) drawn.setAlpha(kHiddenAlpha);
      painter.setPen(QPen(drawn, selected ? 2.2 : 1.4, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(piece.line);
      painter.setBrush(drawn);
      if (line.arrow && piece.last) paintTip(painter, piece.line.p1(), piece.line.p2());
      painter.setBrush(Qt::NoBrush);
    }
  }
  if (const auto at = shape.north ? context.view.project(*shape.north) : std::nullopt) {
    const QString letter = inWords(QT_TRANSLATE_NOOP("Viewport", "N"));
    const QRectF box(at->x - 14, at->y - 14, 28, 28);
    painter.setPen(QColor(20, 22, 26));
    painter.drawText(box.translated(1, 1), Qt::AlignCenter, letter);
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, letter);
  }
}

void paintShapePoints(QPainter& painter, const ViewFrame& view, const NodeShape& shape,
                      const std::optional<ShapePoint>& active) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const ShapePoint& point : shape.points) {
    const auto at = view.project(point.place);
    if (!at) continue;
    const bool chosen = active && active->handle == point.handle && active->index == point.index;
    painter.setPen(QPen(QColor(0, 0, 0, 170), 1.2));
    painter.setBrush(chosen ? QColor(255, 240, 150) : QColor(255, 196, 92));
    double r = chosen ? 6.5 : 5.0;
    if (point.handle == ShapeHandle::Sun) r += 4.0;
    const QPointF p(at->x, at->y);
    if (point.handle == ShapeHandle::Corner || point.handle == ShapeHandle::Face)
      painter.drawRect(QRectF(p - QPointF(r, r) * 0.85, QSizeF(2 * r, 2 * r) * 0.85));
    else
      painter.drawEllipse(p, r, r);
  }
  painter.setBrush(Qt::NoBrush);
}

QString shapeText(const ViewportContext& context, const std::string& id, const ShapePoint& point) {
  const SceneNode* node = findShapeNode(context, id);
  if (!node) return {};
  const auto data = evaluate(*node, context.filmTime);
  if (const auto* weather = dynamic_cast<const WeatherNode*>(data.get()))
    return weatherText(*weather, point.handle);
  const auto* heat = dynamic_cast<const HeatSourceNode*>(data.get());
  const auto* source = dynamic_cast<const WaterSourceNode*>(data.get());
  const auto* body = dynamic_cast<const RigidBodyNode*>(data.get());
  if (point.handle == ShapeHandle::Rim && (heat || source))
    return inWords(QT_TRANSLATE_NOOP("Viewport", "Radius %1 m"))
        .arg(number(heat ? heat->radius : source->radius, heat ? 1 : 2));
  if (point.handle == ShapeHandle::Arrow && (source || body))
    return inWords(QT_TRANSLATE_NOOP("Viewport", "%1 m/s"))
        .arg(number(length(source ? source->velocity : body->velocity), 1));
  return {};
}

}  // namespace spin
