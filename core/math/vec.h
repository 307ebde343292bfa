// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/base/host_device.h"

namespace spin {

/// Small vectors usable on host and device. Eigen serves linear algebra on the host; these serve kernels and
/// data.
template <class T>
struct Vec2 {
  T x{}, y{};
  SPIN_HD friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

template <class T>
struct Vec3 {
  T x{}, y{}, z{};
  SPIN_HD friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  SPIN_HD constexpr T operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  template <class U>
  SPIN_HD constexpr Vec3<U> to() const {
    return {static_cast<U>(x), static_cast<U>(y), static_cast<U>(z)};
  }
};

template <class T>
struct Vec4 {
  T x{}, y{}, z{}, w{};
  SPIN_HD friend constexpr bool operator==(const Vec4&, const Vec4&) = default;
};

using Vec2f = Vec2<float>;
using Vec2d = Vec2<double>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
using Vec4f = Vec4<float>;

template <class T>
SPIN_HD constexpr Vec2<T> operator+(Vec2<T> a, Vec2<T> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class T>
SPIN_HD constexpr Vec2<T> operator-(Vec2<T> a, Vec2<T> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class T>
SPIN_HD constexpr Vec2<T> operator*(Vec2<T> a, T s) {
  return {a.x * s, a.y * s};
}

template <class T>
SPIN_HD constexpr Vec3<T> operator+(Vec3<T> a, Vec3<T> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
SPIN_HD constexpr Vec3<T> operator-(Vec3<T> a, Vec3<T> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
SPIN_HD constexpr Vec3<T> operator-(Vec3<T> a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
SPIN_HD constexpr Vec3<T> operator*(Vec3<T> a, T s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class T>
SPIN_HD constexpr Vec3<T> operator*(T s, Vec3<T> a) {
  return a * s;
}
template <class T>
SPIN_HD constexpr Vec3<T> operator/(Vec3<T> a, T s) {
  return {a.x / s, a.y / s, a.z / s};
}
template <class T>
SPIN_HD constexpr Vec3<T>& operator+=(Vec3<T>& a, Vec3<T> b) {
  return a = a + b;
}
template <class T>
SPIN_HD constexpr T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
SPIN_HD constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
SPIN_HD T length(Vec3<T> a) {
  return std::sqrt(dot(a, a));
}
/// The zero vector stays the zero vector.
template <class T>
SPIN_HD Vec3<T> normalized(Vec3<T> a) {
  const T l = length(a);
  return l > T(0) ? a / l : a;
}
template <class T>
SPIN_HD bool isFinite(Vec3<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Axis-aligned box; empty while min > max.
struct Box3d {
  Vec3d min{1e300, 1e300, 1e300};
  Vec3d max{-1e300, -1e300, -1e300};

  friend bool operator==(const Box3d&, const Box3d&) = default;
  bool empty() const { return min.x > max.x; }
  void extend(Vec3d p) {
    min = {std::fmin(min.x, p.x), std::fmin(min.y, p.y), std::fmin(min.z, p.z)};
    max = {std::fmax(max.x, p.x), std::fmax(max.y, p.y), std::fmax(max.z, p.z)};
  }
  void extend(const Box3d& b) {
    if (!b.empty()) extend(b.min), extend(b.max);
  }
  Vec3d centre() const { return (min + max) * 0.5; }
  Vec3d size() const { return empty() ? Vec3d{} : max - min; }
};

}  // namespace spin
