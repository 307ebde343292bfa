// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/math/transform.h"

#include "core/base/check.h"
#include "core/base/units.h"

namespace spin {
namespace {

/// Cofactor matrix by rows; the inverse is its transpose over the determinant.
std::array<double, 9> cofactors(const std::array<double, 9>& m) {
  return {m[4] * m[8] - m[5] * m[7], m[5] * m[6] - m[3] * m[8], m[3] * m[7] - m[4] * m[6],
          m[2] * m[7] - m[1] * m[8], m[0] * m[8] - m[2] * m[6], m[1] * m[6] - m[0] * m[7],
          m[1] * m[5] - m[2] * m[4], m[2] * m[3] - m[0] * m[5], m[0] * m[4] - m[1] * m[3]};
}

Transform axisRotation(int axis, double degrees) {
  const double c = std::cos(degreesToRadians(degrees));
  const double s = std::sin(degreesToRadians(degrees));
  switch (axis) {
    case 0:
      return {{1, 0, 0, 0, c, -s, 0, s, c}, {}};
    case 1:
      return {{c, 0, s, 0, 1, 0, -s, 0, c}, {}};
    default:
      return {{c, -s, 0, s, c, 0, 0, 0, 1}, {}};
  }
}

}  // namespace

double Transform::determinant() const {
  const auto c = cofactors(linear);
  return linear[0] * c[0] + linear[1] * c[1] + linear[2] * c[2];
}

Vec3d Transform::normal(Vec3d n) const {
  // Cofactors are the inverse transpose times the determinant: no division, and the sign keeps orientation.
  const Transform c{cofactors(linear), {}};
  return c.vector(n);
}

Transform Transform::inverse() const {
  const double d = determinant();
  SPIN_CHECK(d != 0.0, "a singular transform has no inverse");
  const auto c = cofactors(linear);
  Transform inv{{c[0] / d, c[3] / d, c[6] / d, c[1] / d, c[4] / d, c[7] / d, c[2] / d, c[5] / d, c[8] / d},
                {}};
  inv.translation = -inv.vector(translation);
  return inv;
}

std::array<float, 16> Transform::toColumnMajor() const {
  std::array<float, 16> m{};
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) m[col * 4 + row] = static_cast<float>(linear[row * 3 + col]);
    m[12 + row] = static_cast<float>(translation[row]);
  }
  m[15] = 1.0f;
  return m;
}

Transform operator*(const Transform& a, const Transform& b) {
  Transform result;
  for (int row = 0; row < 3; ++row)
    for (int col = 0; col < 3; ++col) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += a.linear[row * 3 + k] * b.linear[k * 3 + col];
      result.linear[row * 3 + col] = sum;
    }
  result.translation = a.point(b.translation);
  return result;
}

Transform translationOf(Vec3d offset) {
  return {{1, 0, 0, 0, 1, 0, 0, 0, 1}, offset};
}
Transform scalingOf(Vec3d f) {
  return {{f.x, 0, 0, 0, f.y, 0, 0, 0, f.z}, {}};
}

Transform rotationOfDegrees(Vec3d e) {
  return axisRotation(2, e.z) * axisRotation(1, e.y) * axisRotation(0, e.x);
}

}  // namespace spin
