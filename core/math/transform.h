// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "core/math/vec.h"

namespace spin {

/// Affine map p -> L p + t, L by rows.
struct Transform {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};
  Vec3d translation{};

  friend bool operator==(const Transform&, const Transform&) = default;
  Vec3d vector(Vec3d v) const {
    return {linear[0] * v.x + linear[1] * v.y + linear[2] * v.z,
            linear[3] * v.x + linear[4] * v.y + linear[5] * v.z,
            linear[6] * v.x + linear[7] * v.y + linear[8] * v.z};
  }
  Vec3d point(Vec3d p) const { return vector(p) + translation; }
  double determinant() const;
  /// Maps normals: the inverse transpose of the linear part, not normalised.
  Vec3d normal(Vec3d n) const;
  /// Requires a non-zero determinant.
  Transform inverse() const;
  /// Column-major 4 x 4 for OpenGL.
  std::array<float, 16> toColumnMajor() const;
};

/// First b, then a.
Transform operator*(const Transform& a, const Transform& b);

Transform translationOf(Vec3d offset);
Transform scalingOf(Vec3d factors);
/// Rotations about x, then y, then z (fixed axes), in degrees.
Transform rotationOfDegrees(Vec3d eulerDegrees);

}  // namespace spin
