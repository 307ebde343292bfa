// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "editor/viewport/node_shape.h"

class QPainter;
class QString;

namespace spin {

/// Lines of a node; faint and broken where the terrain hides them. `selected` ones are
/// bright.
void paintShapeLines(QPainter& painter, const ViewportContext& context, const NodeShape& shape,
                     bool selected);
/// Handles; the active one (under the pointer or in the hand) is bright.
void paintShapePoints(QPainter& painter, const ViewFrame& view, const NodeShape& shape,
                      const std::optional<ShapePoint>& active);

/// What a handle stands at, in a few words ("Radius 5.0 m"); empty where its place says it all.
QString shapeText(const ViewportContext& context, const std::string& node, const ShapePoint& point);

}  // namespace spin
