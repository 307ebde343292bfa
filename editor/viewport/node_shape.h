// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/property/scene_node.h"
#include "editor/viewport/model_gizmo.h"

namespace spin {

/// What a point of a node's shape stands for.
enum class ShapeHandle : std::uint8_t {
  Corner,  ///< of a release's outline
  Centre,  ///< moves the whole
  End,     ///< of a source's line; the camera's eye (0) and target (1)
  Rim,     ///< of a source's disc or of what a heat source warms
  Arrow,   ///< tip: direction and speed, or the normal of a plane
  Face,    ///< of a box
  Wind,    ///< tip of the weather's arrow
  Sun
};

struct ShapePoint {
  ShapeHandle handle = ShapeHandle::Centre;
  std::size_t index = 0;  ///< of the corner, the end or the face (-x, +x, -y, +y, -z, +z)
  Vec3d place{};
};

/// What a drag makes of a node's properties.
using ShapeValues = std::vector<std::pair<std::string, Value>>;

/// Lines and handles of a node that is not a model, in local metres.
struct NodeShape {
  struct Line {
    std::vector<Vec3d> points;
    bool closed = false;
    bool arrow = false;  ///< a tip at the last point
  };
  std::vector<Line> lines;
  std::vector<ShapePoint> points;
  std::optional<Vec3d> north;  ///< where the letter of the compass stands
  bool quiet = false;          ///< shown only while its node is selected
};

/// The shape of a release, source, sink, heat source, camera, of the weather, the domain of flow or a rigid
/// body in a view; empty for other nodes and for disabled ones.
NodeShape nodeShape(const ViewportContext& context, const std::string& node);
/// The node if it has such a shape.
const SceneNode* findShapeNode(const ViewportContext& context, const std::string& node);

/// Id of the node whose lines pass the pointer, of those that are always shown; empty where none does.
std::string shapeNodeAt(const ViewportContext& context, Vec2d pixel);

/// Places that are set by hand have no more digits than anybody reads or a scene file needs.
Vec2d toCentimetres(Vec2d place);
/// Lines and handles of a box.
void addBoxShape(Vec3d centre, Vec3d size, NodeShape& shape);
/// The velocity that an arrow from `at` stands for, within +-100 m/s.
Vec3d velocityOf(Vec3d arrow, const ViewFrame& view, Vec3d at, bool snap);
/// Height of the terrain, 0 where there is none.
double groundHeight(const SceneSnapshot& scene, double x, double y);
/// Length of arrows, m per m/s: about 12 pixels of the view at that place.
double arrowScale(const ViewFrame& view, Vec3d at);
/// Length of the arrow of a plane's normal, m.
double normalLength(const ViewFrame& view, Vec3d at);
/// A way in plan draped on the terrain, with a point at least every few cells; `closed` adds the way back.
std::vector<Vec3d> draped(const SceneSnapshot& scene, const PlanPoints& way, bool closed);

}  // namespace spin
