// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"

namespace spin {
namespace {

constexpr double kDegreesPerPixel = 0.35;
constexpr double kZoomPerStep = 0.85;
// The ground may rise faster than the eye: the way up is searched in steps, its end by halving.
constexpr double kTurnStepDegrees = 1.0;
constexpr int kTurnHalvings = 10;

Vec3d directionOf(double yawDegrees, double pitchDegrees) {
  const double yaw = degreesToRadians(yawDegrees);
  const double pitch = degreesToRadians(pitchDegrees);
  return {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
}

}  // namespace

OrbitCamera OrbitCamera::from(const RenderCamera& camera) {
  OrbitCamera orbit;
  const Vec3d offset = camera.position - camera.target;
  const double distance = length(offset);
  orbit.m_pivot = camera.target;
  orbit.m_fov = camera.fovDegrees;
  if (distance < kMinDistance) return orbit;
  orbit.m_distance = std::min(distance, kMaxDistance);
  orbit.m_pitch = std::clamp(radiansToDegrees(std::asin(std::clamp(offset.z / distance, -1.0, 1.0))),
                             -kMaxPitchDegrees, kMaxPitchDegrees);
  if (std::hypot(offset.x, offset.y) > 1e-9) orbit.m_yaw = radiansToDegrees(std::atan2(offset.y, offset.x));
  return orbit;
}

RenderCamera OrbitCamera::camera() const {
  return {m_pivot + directionOf(m_yaw, m_pitch) * m_distance, m_pivot, m_fov};
}

void OrbitCamera::orbit(double dxPixels, double dyPixels) {
  m_yaw = std::remainder(m_yaw - dxPixels * kDegreesPerPixel, 360.0);
  m_pitch = std::clamp(m_pitch + dyPixels * kDegreesPerPixel, -kMaxPitchDegrees, kMaxPitchDegrees);
}

void OrbitCamera::pan(double dxPixels, double dyPixels, double viewHeightPixels) {
  const ViewFrame view(camera(), viewHeightPixels, viewHeightPixels);
  const double scale = view.metresPerPixel(m_pivot);
  m_pivot = m_pivot - view.right() * (dxPixels * scale) + view.up() * (dyPixels * scale);
}

void OrbitCamera::zoom(double steps, Vec3d anchor) {
  const double wanted = m_distance * std::pow(kZoomPerStep, steps);
  const double factor = std::clamp(wanted, kMinDistance, kMaxDistance) / m_distance;
  m_distance *= factor;
  m_pivot = anchor + (m_pivot - anchor) * factor;
}

void OrbitCamera::frame(const Box3d& box) {
  if (box.empty()) return;
  const double radius = std::max(0.5 * length(box.size()), 0.5);
  m_pivot = box.centre();
  m_pitch = std::max(m_pitch, kMinFramePitchDegrees);
  m_distance = std::clamp(1.1 * radius / std::sin(degreesToRadians(m_fov) * 0.5), kMinDistance, kMaxDistance);
}

double OrbitCamera::missing(const EyeFloor& floor) const {
  const Vec3d eye = camera().position;
  return floor(eye.x, eye.y) - eye.z;
}

void OrbitCamera::turnAbove(const EyeFloor& floor) {
  double below = m_pitch;
  while (m_pitch < kMaxPitchDegrees && missing(floor) > 0.0) {
    below = m_pitch;
    m_pitch = std::min(m_pitch + kTurnStepDegrees, kMaxPitchDegrees);
  }
  double above = m_pitch;
  for (int k = 0; k < kTurnHalvings && below < above; ++k) {
    m_pitch = 0.5 * (below + above);
    (missing(floor) > 0.0 ? below : above) = m_pitch;
  }
  m_pitch = above;
  liftAbove(floor);
}

void OrbitCamera::liftAbove(const EyeFloor& floor) {
  const double rise = missing(floor);
  if (rise > 0.0) m_pivot.z += rise;
}

OrbitCamera OrbitCamera::between(const OrbitCamera& a, const OrbitCamera& b, double t) {
  const double s = std::clamp(t, 0.0, 1.0);
  const double eased = s * s * (3.0 - 2.0 * s);
  OrbitCamera c = b;
  c.m_pivot = a.m_pivot + (b.m_pivot - a.m_pivot) * eased;
  c.m_distance = a.m_distance * std::pow(b.m_distance / a.m_distance, eased);
  c.m_yaw = a.m_yaw + std::remainder(b.m_yaw - a.m_yaw, 360.0) * eased;
  c.m_pitch = a.m_pitch + (b.m_pitch - a.m_pitch) * eased;
  c.m_fov = a.m_fov + (b.m_fov - a.m_fov) * eased;
  return c;
}

}  // namespace spin
