// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/models/node_icons.h"

#include <QHash>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QPolygonF>
#include <array>

namespace spin {
namespace {

/// Shapes on a field of 16 x 16.
using Draw = void (*)(QPainter&);

void polygon(QPainter& p, const QColor& colour, std::initializer_list<QPointF> points) {
  p.setBrush(colour);
  p.drawPolygon(QPolygonF(QList<QPointF>(points)));
}

void mountain(QPainter& p) {
  polygon(p, QColor(0x6b, 0x7f, 0x59), {{1, 14}, {6, 4}, {9, 9}, {11, 6}, {15, 14}});
  polygon(p, Qt::white, {{4.5, 7}, {6, 4}, {7.5, 6.6}, {6, 7.6}});
}
void house(QPainter& p) {
  polygon(p, QColor(0x9b, 0x5d, 0x3f), {{3, 8}, {13, 8}, {13, 14}, {3, 14}});
  polygon(p, QColor(0x7a, 0x3b, 0x2e), {{1, 8}, {8, 2}, {15, 8}});
}
void fourColours(QPainter& p) {
  const std::array<QColor, 4> colours{QColor(0x8a, 0x84, 0x7c), QColor(0x5f, 0x7d, 0x3a),
                                      QColor(0x6e, 0x4f, 0x33), QColor(0x4b, 0x7c, 0x9b)};
  for (int i = 0; i < 4; ++i) {
    p.setBrush(colours[static_cast<std::size_t>(i)]);
    p.drawRect(2 + 6 * (i % 2), 2 + 6 * (i / 2), 6, 6);
  }
}
void thermometer(QPainter& p) {
  p.setBrush(Qt::white);
  p.drawRoundedRect(QRectF(6.5, 1, 3, 10), 1.5, 1.5);
  p.setBrush(QColor(0xc8, 0x3a, 0x2c));
  p.drawEllipse(QPointF(8, 12.5), 2.6, 2.6);
}
void depthStake(QPainter& p) {
  polygon(p, QColor(0xcf, 0xe0, 0xee), {{1, 14.5}, {1, 10.5}, {5, 8}, {11, 9}, {15, 7.5}, {15, 14.5}});
  for (int band = 0; band < 4; ++band) {
    p.setBrush(band % 2 ? QColor(Qt::white) : QColor(0xc8, 0x3a, 0x2c));
    p.drawRect(QRectF(7, 1 + 2.5 * band, 2, 2.5));
  }
}
void shovel(QPainter& p) {
  p.setPen(QPen(QColor(0x8a, 0x5f, 0x38), 1.6));
  p.drawLine(QPointF(13.5, 2), QPointF(7.5, 8.5));
  p.setPen(Qt::NoPen);
  polygon(p, QColor(0x8f, 0xa3, 0xb5), {{5.2, 6.4}, {9.8, 10.6}, {6, 14.4}, {1.6, 13.8}, {1.4, 10}});
}
void cloud(QPainter& p) {
  p.setBrush(QColor(0x9f, 0xb4, 0xc8));
  p.drawEllipse(QPointF(5.5, 9), 4, 3);
  p.drawEllipse(QPointF(10.5, 9), 4, 3);
  p.drawEllipse(QPointF(8, 6.5), 3.6, 3.2);
}
void flake(QPainter& p) {
  p.setPen(QPen(QColor(0x5a, 0x8f, 0xc0), 1.4));
  p.translate(8, 8);
  for (int arm = 0; arm < 6; ++arm) {
    p.drawLine(QPointF(0, 0), QPointF(0, 6.5));
    p.drawLine(QPointF(0, 4), QPointF(1.8, 5.6));
    p.drawLine(QPointF(0, 4), QPointF(-1.8, 5.6));
    p.rotate(60);
  }
}
void crystal(QPainter& p) {
  p.translate(8, 8);
  p.setPen(QPen(QColor(0x3d, 0x6f, 0xa3), 1.1));
  p.setBrush(QColor(0xcf, 0xe0, 0xee));
  p.drawPolygon(QPolygonF({{0, -3.4}, {2.9, -1.7}, {2.9, 1.7}, {0, 3.4}, {-2.9, 1.7}, {-2.9, -1.7}}));
  for (int arm = 0; arm < 6; ++arm) {
    p.drawLine(QPointF(0, 3.4), QPointF(0, 7));
    p.rotate(60);
  }
}
void camera(QPainter& p) {
  p.setBrush(QColor(0x4a, 0x4f, 0x57));
  p.drawRoundedRect(QRectF(1, 5, 10, 7), 1.5, 1.5);
  polygon(p, QColor(0x4a, 0x4f, 0x57), {{11, 8.5}, {15, 5.5}, {15, 11.5}});
}
void picture(QPainter& p) {
  p.setBrush(QColor(0xcf, 0xe0, 0xee));
  p.drawRect(QRectF(1.5, 3, 13, 10));
  polygon(p, QColor(0x6b, 0x7f, 0x59), {{2, 13}, {6, 7}, {9, 10}, {11, 8}, {14, 13}});
}
void gear(QPainter& p) {
  p.translate(8, 8);
  p.setBrush(QColor(0x70, 0x76, 0x80));
  for (int tooth = 0; tooth < 8; ++tooth) {
    p.drawRect(QRectF(-1.3, -7, 2.6, 4));
    p.rotate(45);
  }
  p.drawEllipse(QPointF(0, 0), 5, 5);
  p.setBrush(Qt::white);
  p.drawEllipse(QPointF(0, 0), 2, 2);
}

void slab(QPainter& p) {
  polygon(p, QColor(0x8a, 0x9a, 0xa8), {{1, 14}, {9, 2}, {15, 14}});
  polygon(p, Qt::white, {{6.4, 6}, {9, 2}, {11.6, 7.2}, {9.5, 9}, {8, 7.6}});
  polygon(p, QColor(0xe0, 0x6a, 0x2a), {{5, 12}, {8, 8.6}, {9.5, 10}, {12.3, 8.6}, {13.4, 11}, {9, 13.4}});
}
void drop(QPainter& p) {
  QPainterPath path(QPointF(8, 1.5));
  path.cubicTo(11, 6, 13, 8, 13, 10.5);
  path.cubicTo(13, 13, 10.8, 14.8, 8, 14.8);
  path.cubicTo(5.2, 14.8, 3, 13, 3, 10.5);
  path.cubicTo(3, 8, 5, 6, 8, 1.5);
  p.setBrush(QColor(0x2f, 0x7f, 0xc4));
  p.drawPath(path);
}
void drain(QPainter& p) {
  p.setPen(QPen(QColor(0x4a, 0x4f, 0x57), 1.5));
  p.setBrush(QColor(0xcf, 0xe0, 0xee));
  p.drawRect(QRectF(2, 8, 12, 6));
  polygon(p, QColor(0x2f, 0x7f, 0xc4), {{6, 1.5}, {10, 1.5}, {10, 6}, {12, 6}, {8, 11}, {4, 6}, {6, 6}});
}
void boulder(QPainter& p) {
  polygon(p, QColor(0x7b, 0x76, 0x70), {{2, 12}, {4, 5}, {9, 2.5}, {13.5, 6}, {14, 12}, {9, 14.5}});
  polygon(p, QColor(0xa3, 0x9d, 0x95), {{4, 5}, {9, 2.5}, {13.5, 6}, {8.5, 7.5}});
}
void flask(QPainter& p) {
  polygon(p, QColor(0xcf, 0xe0, 0xee), {{6, 1.5}, {10, 1.5}, {10, 6}, {14, 14}, {2, 14}, {6, 6}});
  polygon(p, QColor(0x8f, 0x6f, 0xb8), {{4.6, 9}, {11.4, 9}, {14, 14}, {2, 14}});
}
void waves(QPainter& p) {
  p.setPen(QPen(QColor(0x2f, 0x7f, 0xc4), 1.7));
  p.setBrush(Qt::NoBrush);
  for (const double y : {4.0, 8.0, 12.0}) {
    QPainterPath wave(QPointF(1, y));
    wave.cubicTo(4, y - 4, 5, y + 4, 8, y);
    wave.cubicTo(11, y - 4, 12, y + 4, 15, y);
    p.drawPath(wave);
  }
}

/// Layers of snow on the ground.
void layers(QPainter& p) {
  polygon(p, QColor(0x7a, 0x6a, 0x58), {{1, 15}, {1, 12.2}, {6, 11}, {11, 12.4}, {15, 11.4}, {15, 15}});
  polygon(p, QColor(0x8f, 0xb4, 0xd6),
          {{1, 12.2}, {1, 8.8}, {6, 7.4}, {11, 9}, {15, 8}, {15, 11.4}, {11, 12.4}, {6, 11}});
  polygon(p, QColor(0xf2, 0xf7, 0xfc),
          {{1, 8.8}, {1, 6}, {5, 3}, {9, 5.2}, {12, 3.6}, {15, 5.4}, {15, 8}, {11, 9}, {6, 7.4}});
  p.setPen(QPen(QColor(0x8f, 0xb4, 0xd6), 0.8));
  p.drawPolyline(QPolygonF({{1, 6}, {5, 3}, {9, 5.2}, {12, 3.6}, {15, 5.4}}));
}
/// Warm air over bare ground.
void warmth(QPainter& p) {
  p.setBrush(QColor(0xc8, 0x4a, 0x2c));
  p.drawEllipse(QRectF(2, 11, 12, 4));
  p.setBrush(QColor(0xf2, 0xb0, 0x4a));
  p.drawEllipse(QRectF(4.5, 11.9, 7, 2.2));
  p.setBrush(Qt::NoBrush);
  p.setPen(QPen(QColor(0xe0, 0x6a, 0x2a), 1.5, Qt::SolidLine, Qt::RoundCap));
  for (const double x : {4.5, 8.0, 11.5}) {
    QPainterPath wave(QPointF(x, 9.6));
    wave.cubicTo(x - 2.6, 7.2, x + 2.6, 4.4, x, 1.6);
    p.drawPath(wave);
  }
}
/// A cloud that rises from falling water.
void mist(QPainter& p) {
  polygon(p, QColor(0x2f, 0x7f, 0xc4), {{1.5, 1}, {4.5, 1}, {5.5, 12}, {2.5, 12}});
  p.setPen(Qt::NoPen);
  p.setBrush(QColor(0x9f, 0xb6, 0xc8));
  p.drawEllipse(QRectF(5, 8.5, 10, 6.5));
  p.setBrush(QColor(0xc4, 0xd4, 0xe0));
  p.drawEllipse(QRectF(8.5, 5, 6, 6));
  p.setBrush(QColor(0xe6, 0xee, 0xf4));
  p.drawEllipse(QRectF(3.5, 10, 7, 5));
}

Draw drawingOf(const QString& type) {
  static const QHash<QString, Draw> kDrawings{{QStringLiteral("terrain"), mountain},
                                              {QStringLiteral("model"), house},
                                              {QStringLiteral("ground_type"), fourColours},
                                              {QStringLiteral("ground_temperature"), thermometer},
                                              {QStringLiteral("snow_depth"), depthStake},
                                              {QStringLiteral("keep_clear"), shovel},
                                              {QStringLiteral("weather"), cloud},
                                              {QStringLiteral("snowfall"), flake},
                                              {QStringLiteral("flake"), crystal},
                                              {QStringLiteral("camera"), camera},
                                              {QStringLiteral("render"), picture},
                                              {QStringLiteral("simulation"), gear},
                                              {QStringLiteral("avalanche_release"), slab},
                                              {QStringLiteral("water_source"), drop},
                                              {QStringLiteral("flow_sink"), drain},
                                              {QStringLiteral("rigid_body"), boulder},
                                              {QStringLiteral("snow_cover"), layers},
                                              {QStringLiteral("heat_source"), warmth},
                                              {QStringLiteral("flow_material"), flask},
                                              {QStringLiteral("flow_settings"), waves},
                                              {QStringLiteral("air"), mist}};
  return kDrawings.value(type, gear);
}

}  // namespace

namespace {

QPixmap drawn(const QString& id, int size, const QColor& plate) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.scale(size / 16.0, size / 16.0);
  painter.setBrush(plate);
  painter.drawRoundedRect(QRectF(0, 0, 16, 16), 3, 3);
  painter.setBrush(Qt::NoBrush);
  drawingOf(id)(painter);
  return pixmap;
}

}  // namespace

QIcon nodeIcon(const NodeType& type) {
  static QHash<QString, QIcon> known;
  const QString id = QString::fromUtf8(type.id);
  if (known.contains(id)) return known.value(id);
  QIcon icon;
  for (const int size : {16, 32}) {
    icon.addPixmap(drawn(id, size, Qt::transparent));
    // Blue drawings would vanish on the blue of a selected row, and still more in the style's tint.
    icon.addPixmap(drawn(id, size, QColor(20, 22, 26, 210)), QIcon::Selected);
  }
  known.insert(id, icon);
  return icon;
}

}  // namespace spin
