// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/shape_gizmo.h"

#include <algorithm>
#include <cmath>

#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "editor/viewport/place_shape.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

constexpr double kGrabPixels = 9.0;
constexpr double kSnapMetres = 1.0;
constexpr double kSmallest = 0.01;  // m, of radii and edges

double pixelDistance(const ViewFrame& view, Vec3d place, Vec2d pixel) {
  const auto at = view.project(place);
  return at ? std::hypot(at->x - pixel.x, at->y - pixel.y) : 1e9;
}

double rounded(double v, bool snap) {
  return snap ? std::round(v / kSnapMetres) * kSnapMetres : v;
}

Vec3d rounded(Vec3d v, bool snap) {
  return {rounded(v.x, snap), rounded(v.y, snap), rounded(v.z, snap)};
}

const AvalancheReleaseNode* releaseOf(const ViewportContext& context, const std::string& id) {
  const SceneNode* node = findShapeNode(context, id);
  return node ? node->as<AvalancheReleaseNode>() : nullptr;
}

/// The point of a line through `start` along `axis` that is nearest to the pointer's ray.
std::optional<Vec3d> alongAxis(const ViewRay& ray, Vec3d start, Vec3d axis) {
  const Vec3d normal = cross(axis, cross(ray.direction, axis));
  if (length(normal) < 1e-4) return std::nullopt;
  const auto hit = intersectPlane(ray, start, normal);
  if (!hit) return std::nullopt;
  return start + axis * dot(*hit - start, axis);
}

/// Where the pointer is: on the terrain, or on the level plane through the handle.
std::optional<Vec3d> groundUnder(const ViewportContext& c, Vec2d pixel, Vec3d handle) {
  const ViewRay ray = c.view.ray(pixel);
  if (c.scene && c.scene->terrain) return pickTerrain(*c.scene, ray);
  return intersectPlane(ray, handle, {0, 0, 1});
}

/// Whether the handle goes along the terrain instead of freely in space.
bool followsGround(const NodeData& data, const ShapePoint& point) {
  if (dynamic_cast<const AvalancheReleaseNode*>(&data) || dynamic_cast<const HeatSourceNode*>(&data))
    return true;
  if (dynamic_cast<const CameraNode*>(&data)) return point.index == 1;
  const auto* source = dynamic_cast<const WaterSourceNode*>(&data);
  return source && source->onGround &&
         (point.handle == ShapeHandle::End || point.handle == ShapeHandle::Centre);
}

/// Where the pointer takes the handle before the grab's offset; nothing where its ray tells nothing.
std::optional<Vec3d> placeUnder(const ViewportContext& c, const NodeData& data, const ShapePoint& point,
                                Vec2d pixel, bool lift) {
  const ViewRay ray = c.view.ray(pixel);
  if (point.handle == ShapeHandle::Sun) return sunUnder(c, ray, point.place);
  if (point.handle == ShapeHandle::Wind) return intersectPlane(ray, point.place, {0, 0, 1});
  if (point.handle == ShapeHandle::Face) {
    const std::size_t axis = point.index / 2;
    return alongAxis(ray, point.place, {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
  }
  if (lift) return alongAxis(ray, point.place, {0, 0, 1});
  if (followsGround(data, point)) return groundUnder(c, pixel, point.place);
  if (point.handle == ShapeHandle::Rim) return intersectPlane(ray, point.place, c.view.forward());
  return intersectPlane(ray, point.place, {0, 0, 1});
}

ShapeGizmo::Values outlineValues(PlanPoints outline, const ShapePoint& point, Vec3d offset, bool snap) {
  const Vec2d by{rounded(offset.x, snap), rounded(offset.y, snap)};
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (point.handle == ShapeHandle::Centre || k == point.index) outline[k] = toCentimetres(outline[k] + by);
  return {{"outline_m", std::move(outline)}};
}

ShapeGizmo::Values sourceValues(const ViewportContext& c, const WaterSourceNode& source,
                                const ShapePoint& point, Vec3d offset, bool snap) {
  // On the ground heights count from the terrain: they stay unless lifted.
  Vec3d by = rounded(offset, snap);
  if (source.onGround && (by.x != 0.0 || by.y != 0.0)) by.z = 0.0;
  switch (point.handle) {
    case ShapeHandle::End:
      return point.index == 0 ? ShapeGizmo::Values{{"position_m", source.position + by}}
                              : ShapeGizmo::Values{{"end_m", source.end + by}};
    case ShapeHandle::Centre:
      if (source.shape == WaterSourceShape::Disc) return {{"position_m", source.position + by}};
      return {{"position_m", source.position + by}, {"end_m", source.end + by}};
    case ShapeHandle::Rim: {
      Vec3d centre = source.position;
      if (source.onGround) centre.z += groundHeight(*c.scene, centre.x, centre.y);
      return {
          {"radius_m", std::clamp(rounded(length(point.place + offset - centre), snap), kSmallest, 100.0)}};
    }
    default:
      break;
  }
  Vec3d middle = source.position;
  if (source.onGround) middle.z += groundHeight(*c.scene, middle.x, middle.y);
  if (source.shape == WaterSourceShape::Line) {
    Vec3d end = source.end;
    if (source.onGround) end.z += groundHeight(*c.scene, end.x, end.y);
    middle = (middle + end) * 0.5;
  }
  const Vec3d arrow = source.velocity * arrowScale(c.view, middle) + offset;
  return {{"velocity_m_s", velocityOf(arrow, c.view, middle, snap)}};
}

ShapeGizmo::Values sinkValues(const ViewportContext& c, const FlowSinkNode& sink, const ShapePoint& point,
                              Vec3d offset, bool snap) {
  if (point.handle == ShapeHandle::Centre) return {{"position_m", sink.position + rounded(offset, snap)}};
  if (point.handle == ShapeHandle::Arrow) {
    const Vec3d arm = point.place + offset - sink.position;
    if (length(arm) < 1e-3 * normalLength(c.view, sink.position)) return {{"normal", sink.normal}};
    return {{"normal", normalized(arm)}};
  }
  // A face moves, the one across stays.
  const std::size_t axis = point.index / 2;
  const double side = point.index % 2 == 0 ? -1.0 : 1.0;
  Vec3d size = sink.size, centre = sink.position;
  double& edge = axis == 0 ? size.x : axis == 1 ? size.y : size.z;
  double& middle = axis == 0 ? centre.x : axis == 1 ? centre.y : centre.z;
  const double before = edge;
  edge = std::max(edge + side * rounded(offset[static_cast<int>(axis)], snap), kSmallest);
  middle += 0.5 * side * (edge - before);
  return {{"position_m", centre}, {"size_m", size}};
}

}  // namespace

std::optional<ShapePoint> ShapeGizmo::pointAt(const ViewportContext& context, Vec2d pixel) const {
  std::optional<ShapePoint> best;
  double nearest = kGrabPixels;
  for (const ShapePoint& point : nodeShape(context, m_node).points) {
    const double distance = pixelDistance(context.view, point.place, pixel);
    if (distance >= nearest) continue;
    nearest = distance;
    best = point;
  }
  return best;
}

void ShapeGizmo::grab(const ViewportContext& context, const ShapePoint& point, PlanPoints outline,
                      Vec2d pixel) {
  const SceneNode* node = findShapeNode(context, m_node);
  Grab made{
      point, std::shared_ptr<const NodeData>(evaluate(*node, context.filmTime)), std::move(outline), {}};
  const auto under = placeUnder(context, *made.start, point, pixel, false);
  if (under) made.offset = point.place - *under;
  m_grab = std::move(made);
}

bool ShapeGizmo::begin(const ViewportContext& context, Vec2d pixel) {
  const auto point = pointAt(context, pixel);
  if (!point) return false;
  const AvalancheReleaseNode* release = releaseOf(context, m_node);
  grab(context, *point, release ? release->outline : PlanPoints{}, pixel);
  return true;
}

bool ShapeGizmo::beginOutline(const ViewportContext& context, Vec2d pixel) {
  const AvalancheReleaseNode* release = releaseOf(context, m_node);
  if (!release) return false;
  if (begin(context, pixel)) return true;
  const auto hit = pickTerrain(*context.scene, context.view.ray(pixel));
  if (!hit) return false;
  PlanPoints outline = release->outline;
  // On a side: the corner is put between its two.
  std::size_t at = outline.size();
  double nearest = kGrabPixels;
  for (std::size_t k = 0; outline.size() > 2 && k < outline.size(); ++k)
    for (const Vec3d& p : draped(*context.scene, {outline[k], outline[(k + 1) % outline.size()]}, false)) {
      const double distance = pixelDistance(context.view, p, pixel);
      if (distance >= nearest) continue;
      nearest = distance;
      at = k + 1;
    }
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(at), toCentimetres({hit->x, hit->y}));
  grab(context, {ShapeHandle::Corner, at, *hit}, std::move(outline), pixel);
  return true;
}

ShapeGizmo::Values ShapeGizmo::drag(const ViewportContext& context, Vec2d pixel, DragKeys keys) {
  const Grab& g = *m_grab;
  const auto under = placeUnder(context, *g.start, g.point, pixel, keys.lift);
  // Lifted, the handle's own place counts: the pointer has left the plane that it grabbed.
  const Vec3d offset = !under ? Vec3d{} : *under + (keys.lift ? Vec3d{} : g.offset) - g.point.place;
  if (dynamic_cast<const AvalancheReleaseNode*>(g.start.get()))
    return outlineValues(g.outline, g.point, offset, keys.snap);
  if (const auto* source = dynamic_cast<const WaterSourceNode*>(g.start.get()))
    return sourceValues(context, *source, g.point, offset, keys.snap);
  if (const auto* sink = dynamic_cast<const FlowSinkNode*>(g.start.get()))
    return sinkValues(context, *sink, g.point, offset, keys.snap);
  return placeValues(context, *g.start, g.point, offset, keys.snap);
}

std::optional<ShapeGizmo::Values> ShapeGizmo::withoutCorner(const ViewportContext& context,
                                                            Vec2d pixel) const {
  const auto point = pointAt(context, pixel);
  if (!point || point->handle != ShapeHandle::Corner) return std::nullopt;
  const AvalancheReleaseNode* release = releaseOf(context, m_node);
  if (!release) return std::nullopt;
  PlanPoints outline = release->outline;
  outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(point->index));
  return Values{{"outline_m", std::move(outline)}};
}

}  // namespace spin
