// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/place_shape.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/viewport/scene_picker.h"

namespace spin {
namespace {

constexpr int kCirclePoints = 64;
constexpr double kRingPixels = 70.0;  // radius of the compass
constexpr double kWindPixels = 40.0;  // arrow of calm air, so that its direction can be grabbed
constexpr double kWindPixelsPerSpeed = 6.0;
constexpr double kSunPixels = 150.0;
constexpr double kAbovePixels = 24.0;       // of the compass over the ground
constexpr double kFrustumShare = 0.25;      // of the way to the target
constexpr double kFrustumPixels = 90.0;     // of its length at most
constexpr double kNoGroundDistance = 50.0;  // m before the eye
constexpr double kSnapDegrees = 15.0;

double pixels(const ViewportContext& c, Vec3d at) {
  return std::max(c.view.metresPerPixel(at), 1e-6);
}

/// To whole steps, or to the finer ones that are still read with pleasure.
double snapped(double v, double step, bool snap, double fine = 0.01) {
  const double to = snap ? step : fine;
  return std::round(v / to) * to;
}

Vec3d snapped(Vec3d v, bool snap) {
  return {snapped(v.x, 1.0, snap), snapped(v.y, 1.0, snap), snapped(v.z, 1.0, snap)};
}

/// The same direction in degrees, as near to another one as possible, so that curves do not go the long way.
double nearTo(double degrees, double other) {
  return std::clamp(other + std::remainder(degrees - other, 360.0), -720.0, 720.0);
}

Vec3d windTip(const ViewportContext& c, const WeatherNode& weather, Vec3d centre) {
  const double length = (kWindPixels + kWindPixelsPerSpeed * weather.windSpeed) * pixels(c, centre);
  return centre + windVector(1.0, weather.windFromDegrees) * length;
}

void addHeat(const ViewportContext& c, const HeatSourceNode& heat, NodeShape& shape) {
  PlanPoints circle;
  for (int k = 0; k < kCirclePoints; ++k) {
    const double angle = 2.0 * kPi * k / kCirclePoints;
    circle.push_back(
        {heat.position.x + heat.radius * std::cos(angle), heat.position.y + heat.radius * std::sin(angle)});
  }
  const Vec2d rim = circle.front();
  shape.lines.push_back({draped(*c.scene, circle, true), false, false});
  shape.points.push_back({ShapeHandle::Rim, 0, {rim.x, rim.y, groundHeight(*c.scene, rim.x, rim.y)}});
  shape.points.push_back(
      {ShapeHandle::Centre,
       0,
       {heat.position.x, heat.position.y, groundHeight(*c.scene, heat.position.x, heat.position.y)}});
}

void addWeather(const ViewportContext& c, const WeatherNode& weather, NodeShape& shape) {
  shape.quiet = true;
  const Vec3d centre = weatherPlace(c);
  const double ring = kRingPixels * pixels(c, centre);
  NodeShape::Line circle{{}, true, false};
  for (int k = 0; k < kCirclePoints; ++k) {
    const double angle = 2.0 * kPi * k / kCirclePoints;
    circle.points.push_back(centre + Vec3d{ring * std::cos(angle), ring * std::sin(angle), 0.0});
  }
  shape.lines.push_back(std::move(circle));
  shape.lines.push_back({{centre + Vec3d{0, 0.9 * ring, 0}, centre + Vec3d{0, 1.1 * ring, 0}}, false, false});
  shape.north = centre + Vec3d{0, 1.25 * ring, 0};
  const Vec3d tip = windTip(c, weather, centre);
  shape.lines.push_back({{centre, tip}, false, true});
  shape.points.push_back({ShapeHandle::Wind, 0, tip});
  if (weather.lightByDate) return;
  const Vec3d sun = centre + sunDirection(weather.sunAzimuthDegrees, weather.sunElevationDegrees) *
                                 (kSunPixels * pixels(c, centre));
  shape.lines.push_back({{centre, sun}, false, false});
  shape.points.push_back({ShapeHandle::Sun, 0, sun});
}

void addCamera(const ViewportContext& c, const CameraNode& camera, NodeShape& shape) {
  const Vec3d way = camera.target - camera.position;
  const double distance = length(way);
  if (distance < 1e-6) return;
  const RenderNode picture = c.scene->settings<RenderNode>(c.filmTime);
  const ViewFrame seen({camera.position, camera.target, camera.fovDegrees},
                       static_cast<double>(std::max(picture.width, 1)),
                       static_cast<double>(std::max(picture.height, 1)));
  const double mostLength = kFrustumPixels * pixels(c, camera.position);
  const double depth = std::min(kFrustumShare * distance, mostLength);
  // A view that stands in the camera would see nothing but its lines.
  if (length(c.view.camera().position - camera.position) < 2.0 * depth) return;
  NodeShape::Line rim{{}, true, false};
  for (const Vec2d corner : {Vec2d{0, 0}, Vec2d{1, 0}, Vec2d{1, 1}, Vec2d{0, 1}}) {
    const ViewRay ray = seen.ray({corner.x * seen.width(), corner.y * seen.height()});
    const Vec3d p = ray.at(depth / std::max(dot(ray.direction, seen.forward()), 1e-3));
    rim.points.push_back(p);
    shape.lines.push_back({{camera.position, p}, false, false});
  }
  // A mark above the picture says which way is up.
  const Vec3d top = (rim.points[0] + rim.points[1]) * 0.5;
  const Vec3d side = rim.points[1] - rim.points[0];
  shape.lines.push_back(
      {{rim.points[0] + side * 0.35, top + seen.up() * (0.25 * length(side)), rim.points[0] + side * 0.65},
       true,
       false});
  shape.lines.push_back(std::move(rim));
  shape.points.push_back({ShapeHandle::End, 0, camera.position});
  shape.points.push_back({ShapeHandle::End, 1, camera.target});
}

void addDomain(const FlowSettingsNode& flow, NodeShape& shape) {
  shape.quiet = true;
  const Vec3d size = flow.domainMax - flow.domainMin;
  if (size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0) return;
  addBoxShape((flow.domainMin + flow.domainMax) * 0.5, size, shape);
}

void addBody(const ViewportContext& c, const RigidBodyNode& body, NodeShape& shape) {
  shape.quiet = true;
  if (body.motion != RigidMotion::Dynamic) return;
  for (const SceneNode* model : c.scene->all<ModelNode>()) {
    if (model->id != body.model) continue;
    const Vec3d place = c.scene->modelTransform(*model, c.filmTime).translation;
    const Vec3d tip = place + body.velocity * arrowScale(c.view, place);
    shape.lines.push_back({{place, tip}, false, true});
    // A body at rest has its handle above it, clear of the model's own handles.
    const bool rests = length(body.velocity) < 1e-9;
    shape.points.push_back(
        {ShapeHandle::Arrow, 0, rests ? place + Vec3d{0, 0, normalLength(c.view, place)} : tip});
  }
}

ShapeValues heatValues(const HeatSourceNode& heat, const ShapePoint& point, Vec3d offset, bool snap) {
  if (point.handle == ShapeHandle::Centre) {
    const Vec3d by = snapped(offset, snap);
    return {{"position_m", heat.position + Vec3d{by.x, by.y, 0.0}}};
  }
  const Vec3d rim = point.place + offset - heat.position;
  return {{"radius_m", std::clamp(snapped(std::hypot(rim.x, rim.y), 1.0, snap, 0.1), 0.1, 10000.0)}};
}

ShapeValues weatherValues(const ViewportContext& c, const WeatherNode& weather, const ShapePoint& point,
                          Vec3d offset, bool snap) {
  const Vec3d centre = weatherPlace(c);
  const Vec3d arm = point.place + offset - centre;
  if (point.handle == ShapeHandle::Sun) {
    const Vec3d to = normalized(arm);
    const double azimuth =
        std::hypot(to.x, to.y) > 1e-6 ? radiansToDegrees(std::atan2(to.x, to.y)) : weather.sunAzimuthDegrees;
    const double elevation = radiansToDegrees(std::asin(std::clamp(to.z, -1.0, 1.0)));
    return {{"sun_azimuth_deg", nearTo(snapped(azimuth, kSnapDegrees, snap, 0.5), weather.sunAzimuthDegrees)},
            {"sun_elevation_deg", std::clamp(snapped(elevation, kSnapDegrees, snap, 0.5), -20.0, 90.0)}};
  }
  const double reach = std::hypot(arm.x, arm.y);
  if (reach < 1e-9) return {};
  const double speed = (reach / pixels(c, centre) - kWindPixels) / kWindPixelsPerSpeed;
  // The arrow points with the wind, the property against it.
  const double from = radiansToDegrees(std::atan2(-arm.x, -arm.y));
  return {{"wind_speed_m_s", std::clamp(snapped(speed, 1.0, snap, 0.1), 0.0, 80.0)},
          {"wind_from_deg", nearTo(snapped(from, kSnapDegrees, snap, 0.5), weather.windFromDegrees)}};
}

ShapeValues domainValues(const FlowSettingsNode& flow, const ShapePoint& point, Vec3d offset, bool snap) {
  constexpr double kLeastEdge = 1.0;  // m
  const Vec3d by = snapped(offset, snap);
  Vec3d low = flow.domainMin, high = flow.domainMax;
  if (point.handle == ShapeHandle::Centre) return {{"domain_min_m", low + by}, {"domain_max_m", high + by}};
  double Vec3d::*const edges[] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};
  const auto edge = edges[point.index / 2];
  if (point.index % 2 == 0)
    low.*edge = std::min(low.*edge + by.*edge, high.*edge - kLeastEdge);
  else
    high.*edge = std::max(high.*edge + by.*edge, low.*edge + kLeastEdge);
  return {{"domain_min_m", low}, {"domain_max_m", high}};
}

ShapeValues bodyValues(const ViewportContext& c, const RigidBodyNode& body, const ShapePoint& point,
                       Vec3d offset, bool snap) {
  for (const SceneNode* model : c.scene->all<ModelNode>()) {
    if (model->id != body.model) continue;
    const Vec3d place = c.scene->modelTransform(*model, c.filmTime).translation;
    const bool rests = length(body.velocity) < 1e-9;
    const Vec3d arm = rests ? offset : point.place + offset - place;
    return {{"velocity_m_s", velocityOf(arm, c.view, place, snap)}};
  }
  return {};
}

}  // namespace

Vec3d weatherPlace(const ViewportContext& context) {
  const ViewRay ray = context.view.ray({0.5 * context.view.width(), 0.5 * context.view.height()});
  Vec3d place = ray.at(kNoGroundDistance);
  if (context.scene)
    if (const auto ground = pickTerrain(*context.scene, ray)) place = *ground;
  return place + Vec3d{0, 0, kAbovePixels * context.view.metresPerPixel(place)};
}

Vec3d sunUnder(const ViewportContext& context, const ViewRay& ray, Vec3d start) {
  const Vec3d centre = weatherPlace(context);
  const double radius = kSunPixels * pixels(context, centre);
  const Vec3d to = centre - ray.origin;
  const double along = dot(to, ray.direction);
  const Vec3d nearest = ray.at(along);
  const double miss = length(nearest - centre);
  if (miss >= radius) return centre + (nearest - centre) * (radius / miss);
  const double half = std::sqrt(radius * radius - miss * miss);
  const bool far = dot(start - centre, ray.direction) > 0.0;
  return ray.at(far ? along + half : along - half);
}

void addPlaceShape(const ViewportContext& context, const NodeData& data, NodeShape& shape) {
  if (const auto* heat = dynamic_cast<const HeatSourceNode*>(&data)) addHeat(context, *heat, shape);
  if (const auto* weather = dynamic_cast<const WeatherNode*>(&data)) addWeather(context, *weather, shape);
  if (const auto* camera = dynamic_cast<const CameraNode*>(&data)) addCamera(context, *camera, shape);
  if (const auto* flow = dynamic_cast<const FlowSettingsNode*>(&data)) addDomain(*flow, shape);
  if (const auto* body = dynamic_cast<const RigidBodyNode*>(&data)) addBody(context, *body, shape);
}

ShapeValues placeValues(const ViewportContext& context, const NodeData& start, const ShapePoint& point,
                        Vec3d offset, bool snap) {
  if (const auto* heat = dynamic_cast<const HeatSourceNode*>(&start))
    return heatValues(*heat, point, offset, snap);
  if (const auto* weather = dynamic_cast<const WeatherNode*>(&start))
    return weatherValues(context, *weather, point, offset, snap);
  if (const auto* flow = dynamic_cast<const FlowSettingsNode*>(&start))
    return domainValues(*flow, point, offset, snap);
  if (const auto* body = dynamic_cast<const RigidBodyNode*>(&start))
    return bodyValues(context, *body, point, offset, snap);
  if (const auto* camera = dynamic_cast<const CameraNode*>(&start)) {
    const Vec3d by = snapped(offset, snap);
    if (point.index == 0) return {{"position_m", camera->position + by}};
    return {{"target_m", camera->target + by}};
  }
  return {};
}

}  // namespace spin
