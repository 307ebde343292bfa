// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <vector>

#include "core/nodes/painted_kinds.h"
#include "editor/render/ground_scale.h"
#include "editor/render/value_scale.h"
#include "editor/viewport/gizmo.h"

class QPainter;

namespace spin {

/// Handles of the gizmo; the one under the pointer or in the hand is bright.
void paintGizmo(QPainter& painter, const ViewFrame& view, const GizmoPose& pose, GizmoMode mode,
                GizmoHandle active);
/// A closed line through points in local metres, e.g. the brush draped on the terrain; a faint one is thin
/// and broken.
void paintLoop(QPainter& painter, const ViewFrame& view, const std::vector<Vec3d>& loop, const QColor& colour,
               bool faint = false);
/// A few words beside a point of the view.
void paintTag(QPainter& painter, QPointF at, const QString& text);
/// A value of a painted layer with its unit, or its name.
QString paintedText(const PaintedKind& kind, double si);
/// What the colours of a painted layer mean: at the left rim of the area.
void paintGroundLegend(QPainter& painter, const QRectF& area, const GroundScale& scale);
/// A calm message in the middle of the view.
void paintHint(QPainter& painter, const QRectF& area, const QString& title, const QString& text);
/// A line at the lower left of the area: what lies under the pointer.
void paintReading(QPainter& painter, const QRectF& area, const QString& text);
/// What the colours of the picture mean: at the right rim of the area. Returns the box that it takes.
QRectF paintLegend(QPainter& painter, const QRectF& area, const ValueLegend& legend);
/// A small label in a corner: top left.
void paintBadge(QPainter& painter, const QString& text);

/// A line of words in the middle of the lower edge.
void paintFootnote(QPainter& painter, const QRectF& area, const QString& text);
/// Dims what lies beside a picture's frame.
void paintFrame(QPainter& painter, const QRectF& area, const QRectF& frame);

}  // namespace spin
