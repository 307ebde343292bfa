// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "editor/render/renderer.h"

namespace spin {

/// Half-line from the eye through a pixel; the direction has length 1.
struct ViewRay {
  Vec3d origin{};
  Vec3d direction{};
  Vec3d at(double t) const { return origin + direction * t; }
};

/// A pinhole camera over a widget: maps local metres to pixels (from the top left) and back. The same
/// projection as the Renderer's.
class ViewFrame {
 public:
  ViewFrame() : ViewFrame(RenderCamera{}, 1.0, 1.0) {}
  ViewFrame(const RenderCamera& camera, double widthPixels, double heightPixels);

  double width() const { return m_width; }
  double height() const { return m_height; }
  const RenderCamera& camera() const { return m_camera; }
  Vec3d forward() const { return m_forward; }
  Vec3d right() const { return m_right; }
  Vec3d up() const { return m_up; }

  ViewRay ray(Vec2d pixel) const;
  /// Nothing for points that are not at least 1 mm in front of the eye.
  std::optional<Vec2d> project(Vec3d point) const;
  /// Distance in front of the eye, m.
  double depth(Vec3d point) const { return dot(point - m_camera.position, m_forward); }
  /// Size of one pixel at the depth of a point, m; 0 behind the eye.
  double metresPerPixel(Vec3d point) const;

 private:
  RenderCamera m_camera;
  double m_width;
  double m_height;
  double m_tanHalfFov;
  Vec3d m_forward, m_right, m_up;
};

/// Where a ray meets the plane through `point` with `normal`; nothing if it is parallel or behind the eye.
std::optional<Vec3d> intersectPlane(const ViewRay& ray, Vec3d point, Vec3d normal);
/// Smallest t >= 0 at which the ray enters the box; nothing if it misses.
std::optional<double> intersectBox(const ViewRay& ray, const Box3d& box);
/// t of the hit with a triangle (Moeller and Trumbore 1997), both sides count; nothing if it misses.
std::optional<double> intersectTriangle(const ViewRay& ray, Vec3d a, Vec3d b, Vec3d c);

}  // namespace spin
