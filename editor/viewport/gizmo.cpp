// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr double kArmPixels = 90.0;
constexpr double kGrabPixels = 8.0;
constexpr double kPlaneFrom = 0.25, kPlaneTo = 0.5;  // of the arm's length
constexpr int kRingSegments = 64;

int axisOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::AxisX:
    case GizmoHandle::PlaneX:
      return 0;
    case GizmoHandle::AxisY:
    case GizmoHandle::PlaneY:
      return 1;
    default:
      return 2;
  }
}

bool isAxis(GizmoHandle handle) {
  return handle == GizmoHandle::AxisX || handle == GizmoHandle::AxisY || handle == GizmoHandle::AxisZ;
}

/// Distance in pixels of the pointer from an outline; closed outlines count as filled where `filled`.
double outlineDistance(const ViewFrame& view, const std::vector<Vec3d>& outline, Vec2d pixel, bool filled) {
  double best = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
    const auto a = view.project(outline[k]);
    const auto b = view.project(outline[k + 1]);
    if (!a || !b) return std::numeric_limits<double>::infinity();
    best = std::min(best, segmentDistance(pixel, *a, *b));
    if ((a->y > pixel.y) != (b->y > pixel.y) &&
        pixel.x < a->x + (b->x - a->x) * (pixel.y - a->y) / (b->y - a->y))
      inside = !inside;
  }
  return filled && inside ? 0.0 : best;
}

double rounded(double value, double step) {
  return std::round(value / step) * step;
}

}  // namespace

double segmentDistance(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d ab = b - a;
  const Vec2d ap = p - a;
  const double square = ab.x * ab.x + ab.y * ab.y;
  const double t = square > 0.0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(ap.x - ab.x * t, ap.y - ab.y * t);
}

GizmoPose GizmoPose::of(const ViewFrame& view, Vec3d pivot, Vec3d rotationDegrees, GizmoMode mode,
                        GizmoAxes axes) {
  GizmoPose pose;
  pose.pivot = pivot;
  pose.size = std::max(1e-6, view.metresPerPixel(pivot) * kArmPixels);
  if (mode == GizmoMode::Scale || axes == GizmoAxes::Local) {
    const Transform rotation = rotationOfDegrees(rotationDegrees);
    for (Vec3d& axis : pose.axes) axis = normalized(rotation.vector(axis));
  }
  return pose;
}

std::vector<GizmoHandle> gizmoHandles(GizmoMode mode) {
  using enum GizmoHandle;
  if (mode == GizmoMode::Move) return {Centre, PlaneX, PlaneY, PlaneZ, AxisX, AxisY, AxisZ};
  if (mode == GizmoMode::Scale) return {Centre, AxisX, AxisY, AxisZ};
  return {AxisX, AxisY, AxisZ};
}

std::vector<Vec3d> gizmoOutline(const GizmoPose& pose, GizmoMode mode, GizmoHandle handle) {
  const auto axis = static_cast<std::size_t>(axisOf(handle));
  const Vec3d along = pose.axes[axis] * pose.size;
  const Vec3d u = pose.axes[(axis + 1) % 3] * pose.size;
  const Vec3d v = pose.axes[(axis + 2) % 3] * pose.size;
  if (handle == GizmoHandle::Centre) return {pose.pivot, pose.pivot};
  if (isAxis(handle) && mode == GizmoMode::Rotate) {
    std::vector<Vec3d> ring;
    for (int k = 0; k <= kRingSegments; ++k) {
      const double angle = 2.0 * kPi * k / kRingSegments;
      ring.push_back(pose.pivot + u * std::cos(angle) + v * std::sin(angle));
    }
    return ring;
  }
  if (isAxis(handle)) return {pose.pivot + along * 0.12, pose.pivot + along};
  return {pose.pivot + u * kPlaneFrom + v * kPlaneFrom, pose.pivot + u * kPlaneTo + v * kPlaneFrom,
          pose.pivot + u * kPlaneTo + v * kPlaneTo, pose.pivot + u * kPlaneFrom + v * kPlaneTo,
          pose.pivot + u * kPlaneFrom + v * kPlaneFrom};
}

GizmoHandle pickGizmo(const ViewFrame& view, const GizmoPose& pose, GizmoMode mode, Vec2d pixel) {
  GizmoHandle best = GizmoHandle::None;
  double bestDistance = kGrabPixels;
  for (const GizmoHandle handle : gizmoHandles(mode)) {
    const bool filled = !isAxis(handle);
    const double distance = outlineDistance(view, gizmoOutline(pose, mode, handle), pixel, filled);
    if (distance < bestDistance) {
      best = handle;
      bestDistance = distance;
      if (filled && handle == GizmoHandle::Centre) return best;
    }
  }
  return best;
}

GizmoDrag::GizmoDrag(GizmoPose pose, GizmoMode mode, GizmoHandle handle, const GizmoPlacement& start,
                     const ViewFrame& view, Vec2d pixel)
    : m_pose(pose), m_mode(mode), m_handle(handle), m_start(start), m_last(start), m_startPixel(pixel) {
  m_grabbed = grabbedPoint(view, pixel);
  if (mode == GizmoMode::Rotate) m_lastAngle = angleOf(view, pixel);
}

std::optional<Vec3d> GizmoDrag::grabbedPoint(const ViewFrame& view, Vec2d pixel) const {
  const ViewRay ray = view.ray(pixel);
  if (m_handle == GizmoHandle::Centre) return intersectPlane(ray, m_pose.pivot, view.forward());
  const Vec3d axis = m_pose.axes[static_cast<std::size_t>(axisOf(m_handle))];
  if (!isAxis(m_handle)) return intersectPlane(ray, m_pose.pivot, axis);
  // The point of the axis nearest to the ray: the ray meets the plane that holds the axis and faces the eye.
  const Vec3d normal = cross(axis, cross(ray.direction, axis));
  if (length(normal) < 1e-4) return std::nullopt;
  const auto hit = intersectPlane(ray, m_pose.pivot, normal);
  if (!hit) return std::nullopt;
  return m_pose.pivot + axis * dot(*hit - m_pose.pivot, axis);
}

GizmoPlacement GizmoDrag::update(const ViewFrame& view, Vec2d pixel, bool snap) {
  if (m_mode == GizmoMode::Rotate) return m_last = rotated(view, pixel, snap);
  const std::optional<Vec3d> point = grabbedPoint(view, pixel);
  if (!point || !m_grabbed) return m_last;
  m_last = m_mode == GizmoMode::Move ? moved(*point - *m_grabbed, snap) : scaled(pixel, *point, snap);
  return m_last;
}

GizmoPlacement GizmoDrag::moved(Vec3d offset, bool snap) const {
  GizmoPlacement placement = m_start;
  if (snap) {
    Vec3d steps{};
    for (const Vec3d& axis : m_pose.axes) steps += axis * rounded(dot(offset, axis), kSnapMetres);
    offset = steps;
  }
  placement.position += offset;
  return placement;
}

double GizmoDrag::angleOf(const ViewFrame& view, Vec2d pixel) const {
  const auto axis = static_cast<std::size_t>(axisOf(m_handle));
  const auto hit = intersectPlane(view.ray(pixel), m_pose.pivot, m_pose.axes[axis]);
  if (!hit) return m_lastAngle;
  const Vec3d offset = *hit - m_pose.pivot;
  return std::atan2(dot(offset, m_pose.axes[(axis + 2) % 3]), dot(offset, m_pose.axes[(axis + 1) % 3]));
}

GizmoPlacement GizmoDrag::rotated(const ViewFrame& view, Vec2d pixel, bool snap) {
  const double angle = angleOf(view, pixel);
  m_turned += std::remainder(angle - m_lastAngle, 2.0 * kPi);
  m_lastAngle = angle;
  double turn = m_turned;
  if (snap) turn = degreesToRadians(rounded(radiansToDegrees(turn), kSnapDegrees));
  const Vec3d axis = m_pose.axes[static_cast<std::size_t>(axisOf(m_handle))];
  GizmoPlacement placement = m_start;
  placement.rotationDegrees =
      eulerDegreesOf((rotationAbout(axis, turn) * rotationOfDegrees(m_start.rotationDegrees)).linear);
  return placement;
}

GizmoPlacement GizmoDrag::scaled(Vec2d pixel, Vec3d point, bool snap) const {
  GizmoPlacement placement = m_start;
  const auto limited = [&](double start, double factor) {
    if (snap) factor = rounded(factor, kSnapScale);
    return start * std::max(factor, kMinScale);
  };
  if (m_handle == GizmoHandle::Centre) {
    // To the right and up is larger: one arm's length doubles.
    const double travel = (pixel.x - m_startPixel.x) - (pixel.y - m_startPixel.y);
    const double factor = std::pow(2.0, travel / kArmPixels);
    placement.scale = {limited(m_start.scale.x, factor), limited(m_start.scale.y, factor),
                       limited(m_start.scale.z, factor)};
    return placement;
  }
  const int index = axisOf(m_handle);
  const Vec3d axis = m_pose.axes[static_cast<std::size_t>(index)];
  const double before = dot(*m_grabbed - m_pose.pivot, axis);
  if (std::abs(before) < 1e-9) return m_last;
  double& component = index == 0 ? placement.scale.x : index == 1 ? placement.scale.y : placement.scale.z;
  component = limited(component, dot(point - m_pose.pivot, axis) / before);
  return placement;
}

Vec3d eulerDegreesOf(const std::array<double, 9>& r) {
  // R = Rz Ry Rx; r[6] = -sin(y).
  const double y = std::asin(std::clamp(-r[6], -1.0, 1.0));
  if (std::abs(r[6]) < 1.0 - 1e-10)
    return {radiansToDegrees(std::atan2(r[7], r[8])), radiansToDegrees(y),
            radiansToDegrees(std::atan2(r[3], r[0]))};
  // Gimbal lock: only the difference of the other two counts, all of it goes to z.
  return {0.0, radiansToDegrees(y), radiansToDegrees(std::atan2(-r[1], r[4]))};
}

Transform rotationAbout(Vec3d axis, double radians) {
  const double c = std::cos(radians);
  const double s = std::sin(radians);
  const Vec3d k = axis * (1.0 - c);
  Transform t;
  t.linear = {c + axis.x * k.x,          axis.x * k.y - s * axis.z, axis.x * k.z + s * axis.y,
              axis.y * k.x + s * axis.z, c + axis.y * k.y,          axis.y * k.z - s * axis.x,
              axis.z * k.x - s * axis.y, axis.z * k.y + s * axis.x, c + axis.z * k.z};
  return t;
}

}  // namespace spin
