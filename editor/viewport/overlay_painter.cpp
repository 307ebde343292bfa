// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/overlay_painter.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/nodes/ground_nodes.h"

namespace spin {
namespace {

QColor colourOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::AxisX:
    case GizmoHandle::PlaneX:
      return QColor(226, 87, 76);
    case GizmoHandle::AxisY:
    case GizmoHandle::PlaneY:
      return QColor(112, 186, 88);
    case GizmoHandle::AxisZ:
    case GizmoHandle::PlaneZ:
      return QColor(74, 144, 226);
    default:
      return QColor(230, 230, 230);
  }
}

/// A linear colour as screens want it.
QColor shown(Vec3d linear) {
  const auto code = [](double c) {
    return static_cast<float>(c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
  };
  return QColor::fromRgbF(code(linear.x), code(linear.y), code(linear.z));
}

/// Nothing if a point lies behind the eye.
std::optional<QPolygonF> projected(const ViewFrame& view, const std::vector<Vec3d>& points) {
  QPolygonF polygon;
  for (const Vec3d& point : points) {
    const auto pixel = view.project(point);
    if (!pixel) return std::nullopt;
    polygon << QPointF(pixel->x, pixel->y);
  }
  return polygon;
}

void paintTip(QPainter& painter, const QPolygonF& arm, GizmoMode mode) {
  const QPointF tip = arm.back();
  const QPointF along = tip - arm.front();
  const double length = std::hypot(along.x(), along.y());
  if (mode == GizmoMode::Scale || length < 1.0) {
    painter.drawRect(QRectF(tip - QPointF(4.5, 4.5), QSizeF(9, 9)));
    return;
  }
  const QPointF u = along / length;
  const QPointF v(-u.y(), u.x());
  painter.drawPolygon(QPolygonF({tip + u * 10.0, tip + v * 5.0, tip - v * 5.0}));
}

void paintHandle(QPainter& painter, const QPolygonF& outline, GizmoMode mode, GizmoHandle handle,
                 bool active) {
  const QColor colour = active ? QColor(255, 220, 90) : colourOf(handle);
  QColor fill = colour;
  const bool plane =
      handle == GizmoHandle::PlaneX || handle == GizmoHandle::PlaneY || handle == GizmoHandle::PlaneZ;
  painter.setPen(QPen(colour, active ? 3.0 : 2.0, Qt::SolidLine, Qt::RoundCap));
  if (handle == GizmoHandle::Centre) {
    fill.setAlpha(active ? 200 : 110);
    painter.setBrush(fill);
    painter.drawEllipse(outline.front(), 6.0, 6.0);
    return;
  }
  fill.setAlpha(plane ? 90 : 255);
  if (plane) {
    painter.setBrush(fill);
    painter.drawPolygon(outline);
    return;
  }
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(outline);
  painter.setBrush(fill);
  if (mode != GizmoMode::Rotate) paintTip(painter, outline, mode);
}

}  // namespace

void paintGizmo(QPainter& painter, const ViewFrame& view, const GizmoPose& pose, GizmoMode mode,
                GizmoHandle active) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const GizmoHandle handle : gizmoHandles(mode)) {
    const auto outline = projected(view, gizmoOutline(pose, mode, handle));
    if (outline) paintHandle(painter, *outline, mode, handle, handle == active);
  }
}

void paintLoop(QPainter& painter, const ViewFrame& view, const std::vector<Vec3d>& loop, const QColor& colour,
               bool faint) {
  const auto outline = projected(view, loop);
  if (!outline || outline->size() < 3) return;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, faint ? 90 : 140), faint ? 2.5 : 3.5));
  painter.drawPolygon(*outline);
  painter.setPen(QPen(colour, faint ? 1.0 : 1.5, faint ? Qt::DashLine : Qt::SolidLine));
  painter.drawPolygon(*outline);
}

void paintTag(QPainter& painter, QPointF at, const QString& text) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetricsF metrics(painter.font());
  const QRectF box(at + QPointF(14, 10), QSizeF(metrics.horizontalAdvance(text) + 14, metrics.height() + 6));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 190));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(QColor(230, 234, 238));
  painter.drawText(box, Qt::AlignCenter, text);
}

QString paintedText(const PaintedKind& kind, double si) {
  if (kind.type == &kGroundTypeLayerType)
    return QCoreApplication::translate("Properties", kGroundTypeChoices[static_cast<std::size_t>(si)].label);
  if (kind.numbers) return QCoreApplication::translate("Properties", kind.label);
  if (kind.unit == Unit::Factor) return QStringLiteral("%1 %").arg(qRound(100.0 * si));
  const int digits = kind.unit == Unit::Metre ? 2 : 1;
  return QStringLiteral("%1 %2").arg(QLocale().toString(toDisplay(kind.unit, si), 'f', digits),
                                     QString::fromUtf8(unitInfo(kind.unit).suffix));
}

void paintHint(QPainter& painter, const QRectF& area, const QString& title, const QString& text) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box(area.center() - QPointF(230, 60), QSizeF(460, 120));
  painter.setPen(QPen(QColor(120, 130, 140), 1.5, Qt::DashLine));
  painter.setBrush(QColor(30, 33, 38, 200));
  painter.drawRoundedRect(box, 10, 10);
  QFont font = painter.font();
  font.setPointSizeF(font.pointSizeF() * 1.3);
  painter.setFont(font);
  painter.setPen(QColor(225, 230, 235));
  painter.drawText(box.adjusted(16, 14, -16, -56), Qt::AlignCenter | Qt::TextWordWrap, title);
  font.setPointSizeF(font.pointSizeF() / 1.3);
  painter.setFont(font);
  painter.setPen(QColor(165, 172, 180));
  painter.drawText(box.adjusted(16, 62, -16, -12), Qt::AlignCenter | Qt::TextWordWrap, text);
}

void paintReading(QPainter& painter, const QRectF& area, const QString& text) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetricsF metrics(painter.font());
  const QSizeF size(metrics.horizontalAdvance(text) + 20, metrics.height() + 10);
  const QRectF box(QPointF(area.left() + 12, area.bottom() - 12 - size.height()), size);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 180));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(QColor(225, 230, 235));
  painter.drawText(box, Qt::AlignCenter, text);
}

QRectF paintLegend(QPainter& painter, const QRectF& area, const ValueLegend& legend) {
  constexpr double kBar = 14.0, kGap = 8.0, kMargin = 16.0, kRow = 20.0;
  const auto text = [](const std::string& source) {
    return QCoreApplication::translate("Properties", source.c_str());
  };
  const auto colour = [&](double place) { return shown(scaleColour(legend.scale, place)); };
  QString title = text(legend.title);
  if (!legend.unit.empty()) title += QStringLiteral(", ") + QString::fromStdString(legend.unit);
  const QFontMetricsF metrics(painter.font());
  double widest = metrics.horizontalAdvance(title) - kBar - kGap;
  for (const ValueLegend::Tick& tick : legend.ticks)
    widest = std::max(widest, metrics.horizontalAdvance(text(tick.text)));
  const bool classes = legend.scale.classes;
  const double rows = static_cast<double>(legend.ticks.size());
  const double height = classes ? rows * kRow : std::clamp(0.4 * area.height(), 80.0, 320.0);
  const QRectF box(area.right() - kMargin - widest - kBar - kGap - 20.0,
                   area.center().y() - 0.5 * height - 24.0, widest + kBar + kGap + 20.0, height + 44.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 170));
  painter.drawRoundedRect(box, 6, 6);
  painter.setPen(QColor(225, 230, 235));
  painter.drawText(QPointF(box.left() + 10, box.top() + 18), title);
  const QRectF bar(box.left() + 10, box.top() + 30, kBar, height);
  for (std::size_t k = 0; k < legend.ticks.size(); ++k) {
    const ValueLegend::Tick& tick = legend.ticks[k];
    const double y = classes ? bar.top() + (static_cast<double>(k) + 0.5) * kRow
                             : bar.bottom() - tick.place * bar.height();
    if (classes) painter.fillRect(QRectF(bar.left(), y - 7, kBar, kBar), colour(tick.place));
    if (!classes) painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + 4, y));
    painter.drawText(QPointF(bar.right() + kGap, y + 0.35 * metrics.ascent()), text(tick.text));
  }
  if (classes) return box;
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (std::size_t k = 0; k < kScaleStops; ++k) {
    const double place = static_cast<double>(k) / static_cast<double>(kScaleStops - 1);
    gradient.setColorAt(place, colour(place));
  }
  painter.fillRect(bar, gradient);
  return box;
}

void paintGroundLegend(QPainter& painter, const QRectF& area, const GroundScale& scale) {
  constexpr double kPatch = 14.0, kGap = 8.0, kMargin = 16.0, kRow = 20.0;
  const QString title = QCoreApplication::translate("Properties", scale.kind->label);
  const QFontMetricsF metrics(painter.font());
  const bool names = !scale.names.empty();
  const auto textOf = [&](std::size_t k) {
    if (names) return QCoreApplication::translate("Properties", scale.names[k]);
    if (scale.kind->unit == Unit::Factor) return paintedText(*scale.kind, scale.stops[k].value);
    const double value = toDisplay(scale.kind->unit, scale.stops[k].value);
    return QStringLiteral("%1 %2").arg(QLocale().toString(std::round(100.0 * value) / 100.0, 'g', 4),
                                       QString::fromUtf8(unitInfo(scale.kind->unit).suffix));
  };
  const std::size_t count = scale.stops.size();
  double widest = metrics.horizontalAdvance(title);
  for (std::size_t k = 0; k < count; ++k)
    widest = std::max(widest, kPatch + kGap + metrics.horizontalAdvance(textOf(k)));
  const double height = static_cast<double>(count) * kRow;
  const QRectF box(area.left() + kMargin, area.center().y() - 0.5 * height - 20.0, widest + 20.0,
                   height + 40.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 170));
  painter.drawRoundedRect(box, 6, 6);
  painter.setPen(QColor(225, 230, 235));
  painter.drawText(QPointF(box.left() + 10, box.top() + 18), title);
  const auto middleOf = [&](std::size_t k) {
    // Measures grow upwards, names are listed downwards.
    const std::size_t row = names ? k : count - 1 - k;
    return box.top() + 30.0 + (static_cast<double>(row) + 0.5) * kRow;
  };
  const double left = box.left() + 10;
  if (!names) {
    QLinearGradient gradient(0, middleOf(0), 0, middleOf(count - 1));
    for (std::size_t k = 0; k < count; ++k)
      gradient.setColorAt(static_cast<double>(k) / static_cast<double>(count - 1),
                          shown(scale.stops[k].colour));
    painter.fillRect(QRectF(QPointF(left, middleOf(count - 1)), QPointF(left + kPatch, middleOf(0))),
                     gradient);
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double y = middleOf(k);
    if (names) painter.fillRect(QRectF(left, y - 0.5 * kPatch, kPatch, kPatch), shown(scale.stops[k].colour));
    painter.drawText(QPointF(left + kPatch + kGap, y + 0.35 * metrics.ascent()), textOf(k));
  }
}

void paintBadge(QPainter& painter, const QString& text) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bounds = painter.boundingRect(QRectF(20, 16, 600, 20), Qt::AlignLeft, text);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 170));
  painter.drawRoundedRect(bounds.adjusted(-8, -4, 8, 4), 5, 5);
  painter.setPen(QColor(215, 220, 226));
  painter.drawText(bounds, Qt::AlignLeft, text);
}

void paintFootnote(QPainter& painter, const QRectF& area, const QString& text) {
  painter.setRenderHint(QPainter::Antialiasing);
  const QFontMetricsF metrics(painter.font());
  const double width = std::min(metrics.horizontalAdvance(text) + 20.0, area.width() - 8.0);
  const QRectF box(area.center().x() - 0.5 * width, area.bottom() - metrics.height() - 16.0, width,
                   metrics.height() + 8.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(20, 22, 26, 150));
  painter.drawRoundedRect(box, 5, 5);
  painter.setPen(QColor(215, 220, 226));
  painter.drawText(box.adjusted(8, 0, -8, 0), Qt::AlignCenter,
                   metrics.elidedText(text, Qt::ElideRight, width - 16.0));
}

void paintFrame(QPainter& painter, const QRectF& area, const QRectF& frame) {
  QPainterPath beside;
  beside.addRect(area);
  beside.addRect(frame);
  painter.fillPath(beside, QColor(14, 16, 20, 170));
  painter.setPen(QPen(QColor(235, 238, 242, 150), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
}

}  // namespace spin
