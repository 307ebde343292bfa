// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/property/scene_node.h"
#include "editor/viewport/model_gizmo.h"

namespace spin {

/// What a point of a flow node's shape stands for.
enum class ShapeHandle : std::uint8_t {
  Corner,  ///< of a release's outline
  Centre,  ///< moves the whole
  End,     ///< of a source's line
  Rim,     ///< of a source's disc
  Arrow,   ///< tip: direction and speed, or the normal of a plane
  Face     ///< of a box
};

struct ShapePoint {
  ShapeHandle handle = ShapeHandle::Centre;
  std::size_t index = 0;  ///< of the corner, the end or the face (-x, +x, -y, +y, -z, +z)
  Vec3d place{};
};

/// Lines and handles of a node that feeds or takes out flow, in local metres.
struct FlowShape {
  struct Line {
    std::vector<Vec3d> points;
    bool closed = false;
    bool arrow = false;  ///< a tip at the last point
  };
  std::vector<Line> lines;
  std::vector<ShapePoint> points;
};

/// The shape of a release, source or sink in a view; empty for other nodes and for disabled ones.
FlowShape flowShape(const ViewportContext& context, const std::string& node);
/// The node if it has such a shape.
const SceneNode* findShapeNode(const ViewportContext& context, const std::string& node);

/// Id of the release, source or sink whose lines pass the pointer; empty where none does.
std::string shapeNodeAt(const ViewportContext& context, Vec2d pixel);

/// Height of the terrain, 0 where there is none.
double groundHeight(const SceneSnapshot& scene, double x, double y);
/// Length of arrows, m per m/s: about 12 pixels of the view at that place.
double arrowScale(const ViewFrame& view, Vec3d at);
/// Length of the arrow of a plane's normal, m.
double normalLength(const ViewFrame& view, Vec3d at);
/// A way in plan draped on the terrain, with a point at least every few cells; `closed` adds the way back.
std::vector<Vec3d> draped(const SceneSnapshot& scene, const PlanPoints& way, bool closed);

}  // namespace spin
