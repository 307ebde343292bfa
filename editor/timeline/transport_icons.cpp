// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/timeline/transport_icons.h"

#include <QPainter>
#include <QPixmap>

namespace spin {
namespace {

constexpr int kSide = 64;  // drawn in units of a 32 x 32 grid

void triangle(QPainter& painter, double from, double to) {
  painter.drawPolygon(QPolygonF({{from, 8}, {to, 16}, {from, 24}}));
}

void bar(QPainter& painter, double x) {
  painter.drawRect(QRectF(x, 8, 3.5, 16));
}

/// Stands for the simulation, as against the film.
void ring(QPainter& painter, const QColor& colour) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 2.0));
  painter.drawEllipse(QPointF(16, 16), 10.5, 10.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
}

}  // namespace

QIcon transportIcon(TransportIcon icon, const QColor& colour) {
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kSide / 32.0, kSide / 32.0);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  switch (icon) {
    case TransportIcon::First:
      bar(painter, 7);
      triangle(painter, 25, 12);
      break;
    case TransportIcon::Previous:
      triangle(painter, 21, 10);
      bar(painter, 21.5);
      break;
    case TransportIcon::Play:
      triangle(painter, 10, 24);
      break;
    case TransportIcon::Pause:
      bar(painter, 10.5);
      bar(painter, 18);
      break;
    case TransportIcon::Next:
      triangle(painter, 11, 22);
      bar(painter, 7);
      break;
    case TransportIcon::Last:
      triangle(painter, 7, 20);
      bar(painter, 21.5);
      break;
    case TransportIcon::HoldRun:
      ring(painter, colour);
      painter.drawRect(QRectF(12, 11, 3, 10));
      painter.drawRect(QRectF(17, 11, 3, 10));
      break;
    case TransportIcon::StepRun:
      ring(painter, colour);
      painter.drawPolygon(QPolygonF({{11.5, 11}, {17.5, 16}, {11.5, 21}}));
      painter.drawRect(QRectF(18, 11, 2.6, 10));
      break;
    case TransportIcon::Reset:
      painter.setBrush(Qt::NoBrush);
      painter.setPen(QPen(colour, 2.4, Qt::SolidLine, Qt::RoundCap));
      painter.drawArc(QRectF(7.5, 7.5, 17, 17), 150 * 16, -290 * 16);
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      painter.drawPolygon(QPolygonF({{4.5, 7.5}, {12.5, 8.5}, {7, 14.5}}));
      break;
  }
  return QIcon(pixmap);
}

}  // namespace spin
