// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/node_shape.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/viewport/place_shape.h"

namespace spin {
namespace {

constexpr double kArrowPixels = 12.0;  // per m/s
constexpr double kNormalPixels = 90.0;
constexpr double kPlanePixels = 70.0;  // half the side of the square that stands for a plane
constexpr int kDiscPoints = 48;
constexpr int kMostDrapes = 64;  // points of a side
constexpr double kLift = 0.15;   // m above the ground
constexpr double kClickPixels = 5.0;

Vec3d onGround(const SceneSnapshot& scene, Vec3d p, bool counts) {
  if (counts) p.z += groundHeight(scene, p.x, p.y);
  return p;
}

/// Two directions across an axis.
void across(Vec3d axis, Vec3d& u, Vec3d& v) {
  const Vec3d other = std::abs(axis.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  u = normalized(cross(other, axis));
  v = cross(axis, u);
}

Vec3d directionOf(Vec3d v) {
  return length(v) > 1e-9 ? normalized(v) : Vec3d{0, 0, 1};
}

void addRelease(const ViewportContext& c, const AvalancheReleaseNode& release, NodeShape& shape) {
  const PlanPoints& outline = release.outline;
  if (outline.size() > 1)
    shape.lines.push_back({draped(*c.scene, outline, outline.size() > 2), false, false});
  Vec2d sum{};
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec2d p = outline[k];
    shape.points.push_back({ShapeHandle::Corner, k, {p.x, p.y, groundHeight(*c.scene, p.x, p.y) + kLift}});
    sum = sum + p;
  }
  if (outline.size() < 3) return;
  const Vec2d middle = sum * (1.0 / static_cast<double>(outline.size()));
  shape.points.push_back(
      {ShapeHandle::Centre, 0, {middle.x, middle.y, groundHeight(*c.scene, middle.x, middle.y) + kLift}});
}

void addSource(const ViewportContext& c, const WaterSourceNode& source, NodeShape& shape) {
  const Vec3d a = onGround(*c.scene, source.position, source.onGround);
  Vec3d middle = a;
  if (source.shape == WaterSourceShape::Line) {
    const Vec3d b = onGround(*c.scene, source.end, source.onGround);
    shape.lines.push_back({{a, b}, false, false});
    shape.points.push_back({ShapeHandle::End, 0, a});
    shape.points.push_back({ShapeHandle::End, 1, b});
    middle = (a + b) * 0.5;
  } else {
    Vec3d u{}, v{};
    across(directionOf(source.velocity), u, v);
    NodeShape::Line rim{{}, true, false};
    for (int k = 0; k < kDiscPoints; ++k) {
      const double angle = 2.0 * kPi * k / kDiscPoints;
      rim.points.push_back(a + (u * std::cos(angle) + v * std::sin(angle)) * source.radius);
    }
    shape.lines.push_back(std::move(rim));
    shape.points.push_back({ShapeHandle::Rim, 0, a + u * source.radius});
  }
  const Vec3d tip = middle + source.velocity * arrowScale(c.view, middle);
  shape.lines.push_back({{middle, tip}, false, true});
  shape.points.push_back({ShapeHandle::Arrow, 0, tip});
  shape.points.push_back({ShapeHandle::Centre, 0, middle});
}

void addPlane(const ViewportContext& c, const FlowSinkNode& sink, NodeShape& shape) {
  const Vec3d normal = directionOf(sink.normal);
  Vec3d u{}, v{};
  across(normal, u, v);
  const double half = kPlanePixels * c.view.metresPerPixel(sink.position);
  const auto corner = [&](double a, double b) { return sink.position + u * (a * half) + v * (b * half); };
  shape.lines.push_back({{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)}, true, false});
  const Vec3d tip = sink.position + normal * normalLength(c.view, sink.position);
  shape.lines.push_back({{sink.position, tip}, false, true});
  shape.points.push_back({ShapeHandle::Arrow, 0, tip});
  shape.points.push_back({ShapeHandle::Centre, 0, sink.position});
}

bool mayHaveShape(const SceneNode& node) {
  return node.as<AvalancheReleaseNode>() || node.as<WaterSourceNode>() || node.as<FlowSinkNode>() ||
         node.as<HeatSourceNode>() || node.as<WeatherNode>() || node.as<CameraNode>() ||
         node.as<FlowSettingsNode>() || node.as<RigidBodyNode>();
}

}  // namespace

double groundHeight(const SceneSnapshot& scene, double x, double y) {
  return scene.terrain && !scene.terrain->heights.empty()
             ? TerrainSurface(scene.terrain->heights).nearestHeight(x, y)
             : 0.0;
}

void addBoxShape(Vec3d centre, Vec3d size, NodeShape& shape) {
  const Vec3d h = size * 0.5;
  const auto at = [&](int x, int y, int z) { return centre + Vec3d{x * h.x, y * h.y, z * h.z}; };
  for (const int z : {-1, 1})
    shape.lines.push_back({{at(-1, -1, z), at(1, -1, z), at(1, 1, z), at(-1, 1, z)}, true, false});
  for (const int x : {-1, 1})
    for (const int y : {-1, 1}) shape.lines.push_back({{at(x, y, -1), at(x, y, 1)}, false, false});
  for (int face = 0; face < 6; ++face) {
    Vec3d p = centre;
    const double side = face % 2 == 0 ? -1.0 : 1.0;
    if (face / 2 == 0) p.x += side * h.x;
    if (face / 2 == 1) p.y += side * h.y;
    if (face / 2 == 2) p.z += side * h.z;
    shape.points.push_back({ShapeHandle::Face, static_cast<std::size_t>(face), p});
  }
  shape.points.push_back({ShapeHandle::Centre, 0, centre});
}

Vec2d toCentimetres(Vec2d place) {
  return {std::round(100.0 * place.x) / 100.0, std::round(100.0 * place.y) / 100.0};
}

Vec3d velocityOf(Vec3d arrow, const ViewFrame& view, Vec3d at, bool snap) {
  constexpr double kMost = 100.0;
  Vec3d velocity = arrow * (1.0 / arrowScale(view, at));
  for (double* part : {&velocity.x, &velocity.y, &velocity.z})
    *part = std::clamp(snap ? std::round(*part) : *part, -kMost, kMost);
  return velocity;
}

double arrowScale(const ViewFrame& view, Vec3d at) {
  return std::max(kArrowPixels * view.metresPerPixel(at), 1e-6);
}

double normalLength(const ViewFrame& view, Vec3d at) {
  return std::max(kNormalPixels * view.metresPerPixel(at), 1e-6);
}

std::vector<Vec3d> draped(const SceneSnapshot& scene, const PlanPoints& way, bool closed) {
  std::vector<Vec3d> points;
  const double cell = scene.terrain ? scene.terrain->heights.cellSize : 1e9;
  const std::size_t sides = closed ? way.size() : way.size() - 1;
  for (std::size_t k = 0; k < sides; ++k) {
    const Vec2d a = way[k], b = way[(k + 1) % way.size()];
    const double distance = std::hypot(b.x - a.x, b.y - a.y);
    const int parts = std::clamp(static_cast<int>(std::ceil(distance / cell)), 1, kMostDrapes);
    for (int part = 0; part < parts; ++part) {
      const Vec2d p = a + (b - a) * (static_cast<double>(part) / parts);
      points.push_back({p.x, p.y, groundHeight(scene, p.x, p.y) + kLift});
    }
  }
  const Vec2d last = closed ? way.front() : way.back();
  points.push_back({last.x, last.y, groundHeight(scene, last.x, last.y) + kLift});
  return points;
}

const SceneNode* findShapeNode(const ViewportContext& context, const std::string& id) {
  if (!context.scene || id.empty()) return nullptr;
  for (const SceneNode& node : context.scene->nodes)
    if (node.id == id && node.enabled && mayHaveShape(node)) return &node;
  return nullptr;
}

NodeShape nodeShape(const ViewportContext& context, const std::string& id) {
  NodeShape shape;
  const SceneNode* node = findShapeNode(context, id);
  if (!node) return shape;
  const auto data = evaluate(*node, context.filmTime);
  if (const auto* release = dynamic_cast<const AvalancheReleaseNode*>(data.get()))
    addRelease(context, *release, shape);
  if (const auto* source = dynamic_cast<const WaterSourceNode*>(data.get()))
    addSource(context, *source, shape);
  const auto* sink = dynamic_cast<const FlowSinkNode*>(data.get());
  if (sink && sink->shape == FlowSinkShape::Plane) addPlane(context, *sink, shape);
  if (sink && sink->shape == FlowSinkShape::Box) addBoxShape(sink->position, sink->size, shape);
  addPlaceShape(context, *data, shape);
  return shape;
}

std::string shapeNodeAt(const ViewportContext& context, Vec2d pixel) {
  std::string found;
  if (!context.scene) return found;
  double nearest = kClickPixels;
  for (const SceneNode& node : context.scene->nodes) {
    const NodeShape shape = nodeShape(context, node.id);
    if (shape.quiet) continue;
    for (const NodeShape::Line& line : shape.lines)
      for (std::size_t k = 0; k + (line.closed ? 0 : 1) < line.points.size(); ++k) {
        const auto a = context.view.project(line.points[k]);
        const auto b = context.view.project(line.points[(k + 1) % line.points.size()]);
        const double distance = a && b ? segmentDistance(pixel, *a, *b) : nearest;
        if (distance >= nearest) continue;
        nearest = distance;
        found = node.id;
      }
  }
  return found;
}

}  // namespace spin
