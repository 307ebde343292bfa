// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/math/vec.h"

namespace spin {

/// Unit quaternion w + xi + yj + zk: body axes to world axes.
struct Quaternion {
  double w = 1.0, x = 0.0, y = 0.0, z = 0.0;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
  Quaternion conjugate() const { return {w, -x, -y, -z}; }
  Vec3d rotate(Vec3d v) const {
    const Vec3d u{x, y, z}, t = cross(u, v) * 2.0;
    return v + t * w + cross(u, t);
  }
};
inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline Quaternion normalized(const Quaternion& q) {
  const double s = 1.0 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w * s, q.x * s, q.y * s, q.z * s};
}
/// Turned by the vector `turn`, rad, in world axes.
inline Quaternion turnedBy(const Quaternion& q, Vec3d turn) {
  const double angle = length(turn), half = 0.5 * angle;
  const double s = angle > 1e-12 ? std::sin(half) / angle : 0.5;
  return normalized(Quaternion{std::cos(half), turn.x * s, turn.y * s, turn.z * s} * q);
}

/// Symmetric 3 x 3 matrix.
struct SymmetricMatrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  Vec3d operator*(Vec3d v) const {
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
  }
  SymmetricMatrix scaled(double s) const { return {xx * s, yy * s, zz * s, xy * s, xz * s, yz * s}; }
  /// Requires that it can be inverted.
  SymmetricMatrix inverse() const {
    const double cxx = yy * zz - yz * yz, cxy = xz * yz - xy * zz, cxz = xy * yz - xz * yy;
    const double s = 1.0 / (xx * cxx + xy * cxy + xz * cxz);
    return SymmetricMatrix{cxx, xx * zz - xz * xz, xx * yy - xy * xy, cxy, cxz, xy * xz - xx * yz}.scaled(s);
  }
};

/// Everything about a body that changes, as plain data: copied into checkpoints and back, a run goes on bit
/// for bit.
struct RigidState {
  Vec3d position{};  ///< centre of mass, world m
  Quaternion orientation;
  Vec3d velocity{};          ///< of the centre of mass, m/s
  Vec3d angularVelocity{};   ///< rad/s, world axes
  double calmSeconds = 0.0;  ///< how long it has hardly moved; from kSleepAfter on it sleeps
  friend bool operator==(const RigidState&, const RigidState&) = default;

  Vec3d toWorld(Vec3d body) const { return position + orientation.rotate(body); }
  Vec3d toBody(Vec3d world) const { return orientation.conjugate().rotate(world - position); }
  Vec3d velocityAt(Vec3d world) const { return velocity + cross(angularVelocity, world - position); }
};
inline constexpr double kSleepAfter = 0.5;  ///< s

inline bool isFinite(const RigidState& s) {
  const Quaternion& q = s.orientation;
  return isFinite(s.position) && isFinite(s.velocity) && isFinite(s.angularVelocity) &&
         std::isfinite(s.calmSeconds) && std::isfinite(q.w + q.x + q.y + q.z);
}

}  // namespace spin
