// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/tool_icons.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace spin {
namespace {

constexpr int kSide = 64;  // drawn in units of a 32 x 32 grid

void drawSelect(QPainter& painter) {
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(QPolygonF({{9, 5}, {9, 26}, {14, 21}, {18, 28}, {21, 26}, {17, 19}, {24, 19}}));
}

void drawMove(QPainter& painter) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    painter.drawLine(QPointF(16, 16), QPointF(16, 6));
    painter.drawPolyline(QPolygonF({{12, 9}, {16, 5}, {20, 9}}));
    painter.translate(16, 16);
    painter.rotate(90);
    painter.translate(-16, -16);
  }
}

void drawRotate(QPainter& painter) {
  painter.drawArc(QRectF(6, 6, 20, 20), 40 * 16, 290 * 16);
  painter.drawPolyline(QPolygonF({{19, 8.5}, {24.5, 9.5}, {25, 4}}));
}

void drawScale(QPainter& painter) {
  painter.drawRect(QRectF(6, 18, 8, 8));
  painter.drawLine(QPointF(15, 17), QPointF(25, 7));
  painter.drawPolyline(QPolygonF({{18, 6.5}, {25.5, 6.5}, {25.5, 14}}));
}

void drawBrush(QPainter& painter) {
  painter.drawLine(QPointF(25, 6), QPointF(15, 17));
  painter.setBrush(painter.pen().color());
  QPainterPath head;
  head.moveTo(16, 16);
  head.cubicTo(18, 24, 12, 27, 6, 26);
  head.cubicTo(10, 24, 8, 18, 16, 16);
  painter.drawPath(head);
}

void drawSmooth(QPainter& painter) {
  QPainterPath wave(QPointF(4, 13));
  wave.cubicTo(8, 3, 11, 23, 15, 13);
  wave.cubicTo(18, 6, 22, 12, 28, 12);
  painter.drawPath(wave);
  painter.drawLine(QPointF(4, 24), QPointF(28, 24));
}

void drawErase(QPainter& painter) {
  painter.drawPolygon(QPolygonF({{12, 25}, {5, 18}, {18, 5}, {26, 13}, {14, 25}}));
  painter.drawLine(QPointF(11, 12), QPointF(19, 20));
  painter.drawLine(QPointF(12, 26), QPointF(27, 26));
}

void drawPick(QPainter& painter) {
  painter.drawPolyline(QPolygonF({{7, 25}, {8, 20}, {18, 10}}));
  painter.drawPolyline(QPolygonF({{7, 25}, {12, 24}, {22, 14}}));
  painter.setBrush(painter.pen().color());
  painter.drawPolygon(QPolygonF({{16, 8}, {24, 16}, {22, 11}, {27, 7}, {25, 5}, {21, 10}}));
}

void drawOutline(QPainter& painter) {
  const QPolygonF corners({{6, 11}, {19, 5}, {27, 17}, {17, 27}, {7, 23}});
  painter.drawPolygon(corners);
  painter.setBrush(painter.pen().color());
  for (const QPointF& corner : corners) painter.drawRect(QRectF(corner - QPointF(2, 2), QSizeF(4, 4)));
}

void drawScatter(QPainter& painter) {
  for (const QPointF& foot : {QPointF(9, 17), QPointF(22, 14), QPointF(17, 28)}) {
    painter.drawLine(foot, foot - QPointF(0, 3));
    painter.drawPolygon(
        QPolygonF({foot + QPointF(-4.5, -3), foot + QPointF(4.5, -3), foot + QPointF(0, -11)}));
  }
}

/// A drawing in units of a 32 x 32 grid with a pen of the colour.
template <class Draw>
QIcon drawn(const QColor& colour, const Draw& draw) {
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kSide / 32.0, kSide / 32.0);
  painter.setPen(QPen(colour, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  draw(painter);
  return QIcon(pixmap);
}

}  // namespace

QIcon toolIcon(Viewport::Tool tool, const QColor& colour) {
  switch (tool) {
    case Viewport::Tool::Select:
      return drawn(colour, drawSelect);
    case Viewport::Tool::Move:
      return drawn(colour, drawMove);
    case Viewport::Tool::Rotate:
      return drawn(colour, drawRotate);
    case Viewport::Tool::Scale:
      return drawn(colour, drawScale);
    case Viewport::Tool::Brush:
      return drawn(colour, drawBrush);
    case Viewport::Tool::Outline:
      return drawn(colour, drawOutline);
    case Viewport::Tool::Scatter:
      break;
  }
  return drawn(colour, drawScatter);
}

QIcon brushIcon(BrushMode mode, const QColor& colour) {
  switch (mode) {
    case BrushMode::Paint:
      return drawn(colour, drawBrush);
    case BrushMode::Smooth:
      return drawn(colour, drawSmooth);
    case BrushMode::Erase:
      return drawn(colour, drawErase);
    case BrushMode::Pick:
      break;
  }
  return drawn(colour, drawPick);
}

QIcon programIcon() {
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kSide / 32.0, kSide / 32.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(48, 92, 132));
  painter.drawRoundedRect(QRectF(1, 1, 30, 30), 7, 7);
  painter.setBrush(QColor(236, 243, 250));
  painter.drawPolygon(QPolygonF({{3, 27}, {13, 13}, {18, 19}, {22, 15}, {29, 27}}));
  for (const QPointF& flake :
       {QPointF(8, 8), QPointF(16, 6), QPointF(24, 9), QPointF(20, 12), QPointF(7, 15)})
    painter.drawEllipse(flake, 1.4, 1.4);
  return QIcon(pixmap);
}

}  // namespace spin
