// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "editor/viewport/flow_shape.h"

class QPainter;

namespace spin {

/// Lines of a release, source or sink; faint and broken where the terrain hides them. `selected` ones are
/// bright.
void paintShapeLines(QPainter& painter, const ViewportContext& context, const FlowShape& shape,
                     bool selected);
/// Handles; the active one (under the pointer or in the hand) is bright.
void paintShapePoints(QPainter& painter, const ViewFrame& view, const FlowShape& shape,
                      const std::optional<ShapePoint>& active);

}  // namespace spin
