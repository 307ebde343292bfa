// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/math/transform.h"
#include "editor/viewport/view_frame.h"

namespace spin {

enum class GizmoMode { Move, Rotate, Scale };
enum class GizmoAxes { World, Local };
/// What the pointer can grab. Planes are named by their normal; Centre moves in the picture plane (or along
/// the terrain) and scales all axes alike.
enum class GizmoHandle { None, AxisX, AxisY, AxisZ, PlaneX, PlaneY, PlaneZ, Centre };

/// What a gizmo changes: the placement of a model node. The pivot in local metres is kept apart, because a
/// node on the ground stores its height above the ground.
struct GizmoPlacement {
  Vec3d position{};
  Vec3d rotationDegrees{};
  Vec3d scale{1, 1, 1};
  friend bool operator==(const GizmoPlacement&, const GizmoPlacement&) = default;
};

/// Where the gizmo stands and which way its axes point. Scaling always follows the model's own axes.
struct GizmoPose {
  Vec3d pivot{};
  std::array<Vec3d, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double size = 1.0;  ///< length of the arms, m

  /// Arms about 90 pixels long wherever it stands.
  static GizmoPose of(const ViewFrame& view, Vec3d pivot, Vec3d rotationDegrees, GizmoMode mode,
                      GizmoAxes axes);
};

/// Outline of a handle in local metres for drawing and picking: an arm, a small square or a ring.
std::vector<Vec3d> gizmoOutline(const GizmoPose& pose, GizmoMode mode, GizmoHandle handle);
/// Handles of a mode, those that are grabbed first come first.
std::vector<GizmoHandle> gizmoHandles(GizmoMode mode);
/// Distance of a point from a straight piece in the picture.
double segmentDistance(Vec2d p, Vec2d a, Vec2d b);
/// The handle under the pointer.
GizmoHandle pickGizmo(const ViewFrame& view, const GizmoPose& pose, GizmoMode mode, Vec2d pixel);

/// One drag of a handle, from press to release. Each update is computed from the start, so that rounding and
/// snapping never add up.
class GizmoDrag {
 public:
  static constexpr double kSnapMetres = 1.0;
  static constexpr double kSnapDegrees = 15.0;
  static constexpr double kSnapScale = 0.1;
  static constexpr double kMinScale = 0.01;

  GizmoDrag(GizmoPose pose, GizmoMode mode, GizmoHandle handle, const GizmoPlacement& start,
            const ViewFrame& view, Vec2d pixel);

  GizmoMode mode() const { return m_mode; }
  GizmoHandle handle() const { return m_handle; }
  const GizmoPose& pose() const { return m_pose; }
  const GizmoPlacement& start() const { return m_start; }
  /// Placement for the pointer's position; snap rounds the change to whole steps. Where the pointer's ray
  /// tells nothing (parallel to the handle) the last placement stays.
  GizmoPlacement update(const ViewFrame& view, Vec2d pixel, bool snap);

 private:
  std::optional<Vec3d> grabbedPoint(const ViewFrame& view, Vec2d pixel) const;
  GizmoPlacement moved(Vec3d offset, bool snap) const;
  GizmoPlacement rotated(const ViewFrame& view, Vec2d pixel, bool snap);
  GizmoPlacement scaled(Vec2d pixel, Vec3d point, bool snap) const;
  double angleOf(const ViewFrame& view, Vec2d pixel) const;

  GizmoPose m_pose;
  GizmoMode m_mode;
  GizmoHandle m_handle;
  GizmoPlacement m_start;
  GizmoPlacement m_last;
  std::optional<Vec3d> m_grabbed;
  Vec2d m_startPixel;
  double m_lastAngle = 0.0;  ///< rad
  double m_turned = 0.0;     ///< rad since the press, over full turns
};

/// Euler angles (about fixed x, then y, then z) of a rotation matrix by rows; inverse of
/// rotationOfDegrees().
Vec3d eulerDegreesOf(const std::array<double, 9>& rotation);
/// Rotation by an angle about a unit axis through the origin (Rodrigues 1840).
Transform rotationAbout(Vec3d axis, double radians);

}  // namespace spin
