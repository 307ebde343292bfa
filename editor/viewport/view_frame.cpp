// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/view_frame.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace spin {

ViewFrame::ViewFrame(const RenderCamera& camera, double widthPixels, double heightPixels)
    : m_camera(camera),
      m_width(std::max(1.0, widthPixels)),
      m_height(std::max(1.0, heightPixels)),
      m_tanHalfFov(std::tan(degreesToRadians(camera.fovDegrees) * 0.5)),
      m_forward(normalized(camera.target - camera.position)) {
  if (length(m_forward) == 0.0) m_forward = {0, 1, 0};
  m_right = cross(m_forward, Vec3d{0, 0, 1});
  // Straight up or down has no horizon: north is taken as the top of the picture.
  m_right = length(m_right) > 1e-9 ? normalized(m_right) : Vec3d{1, 0, 0};
  m_up = cross(m_right, m_forward);
}

ViewRay ViewFrame::ray(Vec2d pixel) const {
  const double x = (2.0 * pixel.x / m_width - 1.0) * m_tanHalfFov * m_width / m_height;
  const double y = (1.0 - 2.0 * pixel.y / m_height) * m_tanHalfFov;
  return {m_camera.position, normalized(m_forward + m_right * x + m_up * y)};
}

std::optional<Vec2d> ViewFrame::project(Vec3d point) const {
  const double d = depth(point);
  if (d < 1e-3) return std::nullopt;
  const Vec3d offset = point - m_camera.position;
  const double x = dot(offset, m_right) / (d * m_tanHalfFov) * m_height / m_width;
  const double y = dot(offset, m_up) / (d * m_tanHalfFov);
  return Vec2d{(x + 1.0) * 0.5 * m_width, (1.0 - y) * 0.5 * m_height};
}

double ViewFrame::metresPerPixel(Vec3d point) const {
  return std::max(0.0, depth(point)) * 2.0 * m_tanHalfFov / m_height;
}

std::optional<Vec3d> intersectPlane(const ViewRay& ray, Vec3d point, Vec3d normal) {
  const double slope = dot(ray.direction, normal);
  if (std::abs(slope) < 1e-9) return std::nullopt;
  const double t = dot(point - ray.origin, normal) / slope;
  if (t < 0.0) return std::nullopt;
  return ray.at(t);
}

std::optional<double> intersectBox(const ViewRay& ray, const Box3d& box) {
  if (box.empty()) return std::nullopt;
  double enter = 0.0;
  double leave = 1e300;
  for (int axis = 0; axis < 3; ++axis) {
    const double d = ray.direction[axis];
    const double low = box.min[axis] - ray.origin[axis];
    const double high = box.max[axis] - ray.origin[axis];
    if (std::abs(d) < 1e-12) {
      if (low > 0.0 || high < 0.0) return std::nullopt;
      continue;
    }
    enter = std::max(enter, std::min(low / d, high / d));
    leave = std::min(leave, std::max(low / d, high / d));
  }
  if (enter > leave) return std::nullopt;
  return enter;
}

std::optional<double> intersectTriangle(const ViewRay& ray, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d ab = b - a;
  const Vec3d ac = c - a;
  const Vec3d p = cross(ray.direction, ac);
  const double determinant = dot(ab, p);
  if (std::abs(determinant) < 1e-15) return std::nullopt;
  const Vec3d s = ray.origin - a;
  const double u = dot(s, p) / determinant;
  const Vec3d q = cross(s, ab);
  const double v = dot(ray.direction, q) / determinant;
  const double t = dot(ac, q) / determinant;
  if (u < 0.0 || v < 0.0 || u + v > 1.0 || t < 0.0) return std::nullopt;
  return t;
}

}  // namespace spin
