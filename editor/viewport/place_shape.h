// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "editor/viewport/node_shape.h"

namespace spin {

/// Lines and handles of nodes that have a place or a direction but no material: heat sources, the weather
/// (wind and sun), the camera, the domain of flow, what a rigid body starts with. Nothing for other nodes.
void addPlaceShape(const ViewportContext& context, const NodeData& data, NodeShape& shape);
/// Properties of such a node after one of its handles was moved by so much from its place.
ShapeValues placeValues(const ViewportContext& context, const NodeData& start, const ShapePoint& point,
                        Vec3d offset, bool snap);

/// Where wind and sun are shown: above the ground in the middle of the view, or before the eye where there is
/// none.
Vec3d weatherPlace(const ViewportContext& context);
/// Where a ray meets the sphere on which the sun is shown, on the side of `start`; beside it the nearest
/// point of its rim.
Vec3d sunUnder(const ViewportContext& context, const ViewRay& ray, Vec3d start);

}  // namespace spin
