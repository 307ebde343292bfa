// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "editor/viewport/view_frame.h"

namespace spin {

/// Lowest height, m, that the eye may have above a place.
using EyeFloor = std::function<double(double x, double y)>;

/// The working camera: it looks at a pivot from a distance. Turning keeps the horizon level; the eye never
/// passes the zenith.
class OrbitCamera {
 public:
  static constexpr double kMaxPitchDegrees = 89.0;
  static constexpr double kMinFramePitchDegrees = 15.0;
  static constexpr double kMinDistance = 0.05;  ///< m
  static constexpr double kMaxDistance = 1e6;   ///< m

  OrbitCamera() = default;
  /// Takes over the eye, the direction and the field of view of another camera.
  static OrbitCamera from(const RenderCamera& camera);
  RenderCamera camera() const;

  Vec3d pivot() const { return m_pivot; }
  double distance() const { return m_distance; }
  double pitchDegrees() const { return m_pitch; }

  /// Turns about the pivot by a pointer move in pixels (to the right: the scene turns right; down: the eye
  /// rises).
  void orbit(double dxPixels, double dyPixels);
  /// Shifts eye and pivot so that what lies at the pivot's depth follows the pointer.
  void pan(double dxPixels, double dyPixels, double viewHeightPixels);
  /// Scales the distance about an anchor, which keeps its place in the picture; steps > 0 comes nearer.
  void zoom(double steps, Vec3d anchor);
  /// Looks from the same side so that the box fills most of the picture; from above it, though the camera
  /// looked upward before.
  void frame(const Box3d& box);
  /// Turns an eye below the floor up about the pivot, as far as that goes, and lifts it by the rest.
  void turnAbove(const EyeFloor& floor);
  /// Shifts eye and pivot straight up until the eye is not below the floor.
  void liftAbove(const EyeFloor& floor);
  /// Way from a to b for a flight, t in 0..1 eased at both ends; turns the short way round.
  static OrbitCamera between(const OrbitCamera& a, const OrbitCamera& b, double t);

 private:
  /// How far the eye lies below the floor, m; 0 or less where it does not.
  double missing(const EyeFloor& floor) const;

  Vec3d m_pivot{};
  double m_distance = 54.0;
  double m_yaw = -90.0;   ///< degrees, where the eye lies from the pivot: 0 east, 90 north
  double m_pitch = 22.0;  ///< degrees, how high the eye lies above the pivot
  double m_fov = 45.0;
};

}  // namespace spin
