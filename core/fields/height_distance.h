// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/scalar_ops.h"

/// Distance from the triangulated surface of a height field (core/fields/terrain_surface.h). A view has
/// heights, width, height, originX, originY and cell; T is float in kernels, double for bodies.
namespace spin {

/// A vector whose operations are always inlined: this text is compiled for several instruction sets.
template <class T>
struct HeightVector {
  T x{}, y{}, z{};
  SPIN_HD_INLINE HeightVector operator+(const HeightVector& o) const { return {x + o.x, y + o.y, z + o.z}; }
  SPIN_HD_INLINE HeightVector operator-(const HeightVector& o) const { return {x - o.x, y - o.y, z - o.z}; }
  SPIN_HD_INLINE HeightVector operator*(T s) const { return {x * s, y * s, z * s}; }
  SPIN_HD_INLINE T dot(const HeightVector& o) const { return x * o.x + y * o.y + z * o.z; }
  SPIN_HD_INLINE HeightVector cross(const HeightVector& o) const {
    return {y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x};
  }
};

/// Where the ground is nearest.
template <class T>
struct HeightContact {
  T distance{};              ///< m, below 0 under the ground
  HeightVector<T> normal{};  ///< unit, out of the ground
  std::size_t quad{};        ///< index of the quad's south-west cell
};

/// Squares of lengths may be compared: the nearest point to 0 of a triangle (Ericson 2005, 5.1.5).
template <class T>
SPIN_HD_INLINE HeightVector<T> nearestToOrigin(HeightVector<T> a, HeightVector<T> b, HeightVector<T> c) {
  const HeightVector<T> ab = b - a, ac = c - a;
  const T d1 = -ab.dot(a), d2 = -ac.dot(a), d3 = -ab.dot(b), d4 = -ac.dot(b), d5 = -ab.dot(c),
          d6 = -ac.dot(c);
  const T vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (d1 <= T(0) && d2 <= T(0)) return a;
  if (d3 >= T(0) && d4 <= d3) return b;
  if (vc <= T(0) && d1 >= T(0) && d3 <= T(0)) return a + ab * (d1 / (d1 - d3));
  if (d6 >= T(0) && d5 <= d6) return c;
  if (vb <= T(0) && d2 >= T(0) && d6 <= T(0)) return a + ac * (d2 / (d2 - d6));
  if (va <= T(0) && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  const T scale = T(1) / (va + vb + vc);
  return a + ab * (vb * scale) + ac * (vc * scale);
}

/// The nine quads round a point and the plane of the facet under it.
template <class T, class View>
struct HeightWindow {
  const View& g;
  std::int32_t i, j;
  T u, v, z;

  SPIN_HD_INLINE T at(std::int32_t a, std::int32_t b) const {
    return static_cast<T>(g.heights[static_cast<std::size_t>(b) * static_cast<std::size_t>(g.width) +
                                    static_cast<std::size_t>(a)]);
  }
  /// Corner relative to the point.
  SPIN_HD_INLINE HeightVector<T> corner(std::int32_t a, std::int32_t b) const {
    return {(static_cast<T>(a - i) - u) * g.cell, (static_cast<T>(b - j) - v) * g.cell, at(a, b) - z};
  }

  /// Corners of the quads that come within `reach` sideways.
  struct Corners {
    std::int32_t i0, i1, j0, j1;
  };
  SPIN_HD_INLINE Corners within(T reach) const {
    const T m = reach / g.cell;
    return {u < m && i > 0 ? i - 1 : i, u + m > T(1) && i + 2 < g.width ? i + 2 : i + 1,
            v < m && j > 0 ? j - 1 : j, v + m > T(1) && j + 2 < g.height ? j + 2 : j + 1};
  }

  /// Whether all corners of the quads within `reach` lie in the plane through `own` with normal `n`, up to
  /// `most`.
  SPIN_HD_INLINE bool flat(HeightVector<T> own, HeightVector<T> n, T reach, T most) const {
    const Corners c = within(reach);
    for (std::int32_t b = c.j0; b <= c.j1; ++b)
      for (std::int32_t a = c.i0; a <= c.i1; ++a) {
        const T off = (corner(a, b) - own).dot(n);
        if (off > most || off < -most) return false;  // a hole is not counted
      }
    return true;
  }

  /// The nearest of all facets within `reach`, where there is one.
  SPIN_HD_INLINE bool nearest(T reach, HeightVector<T>& point, HeightVector<T>& normal,
                              std::size_t& quad) const {
    T best = reach * reach;
    bool found = false;
    const Corners c = within(reach);
    for (std::int32_t b = c.j0; b < c.j1; ++b)
      for (std::int32_t a = c.i0; a < c.i1; ++a) {
        const HeightVector<T> p = corner(a, b), q = corner(a + 1, b + 1);
        // How far the diagonal that parts the quad's facets lies to the north-west of the point.
        const T away = ((static_cast<T>(b - j) - v) - (static_cast<T>(a - i) - u)) * g.cell * T(0.70710678);
        for (int half = 0; half < 2; ++half) {
          if ((half == 0 ? -away : away) > reach) continue;
          const HeightVector<T> r = half == 0 ? corner(a + 1, b) : corner(a, b + 1);
          const HeightVector<T> near = half == 0 ? nearestToOrigin(p, r, q) : nearestToOrigin(p, q, r);
          const T squared = near.dot(near);
          if (!(squared < best)) continue;  // nor where a height is NaN
          best = squared;
          found = true;
          point = near;
          normal = half == 0 ? (r - p).cross(q - p) : (q - p).cross(r - p);
          quad =
              static_cast<std::size_t>(b) * static_cast<std::size_t>(g.width) + static_cast<std::size_t>(a);
        }
      }
    return found;
  }
};

/// Finds the nearest ground within `reach` of a point above it, or under it. Of what is farther than a quad
/// sideways nothing is seen. Where the ground within reach is plane (to a twentieth of the reach) that plane
/// is taken, which is cheap; at steps, ridges and valleys the nearest facet is searched.
template <class T, class View>
SPIN_HD_INLINE bool nearestGround(const View& g, T x, T y, T z, T reach, HeightContact<T>& contact) {
  const T gx = (x - g.originX) / g.cell, gy = (y - g.originY) / g.cell;
  if (!(gx >= T(0) && gy >= T(0) && gx < static_cast<T>(g.width - 1) && gy < static_cast<T>(g.height - 1)))
    return false;
  const std::int32_t i = static_cast<std::int32_t>(gx), j = static_cast<std::int32_t>(gy);
  const HeightWindow<T, View> w{g, i, j, gx - static_cast<T>(i), gy - static_cast<T>(j), z};
  const T z00 = w.at(i, j), z10 = w.at(i + 1, j), z01 = w.at(i, j + 1), z11 = w.at(i + 1, j + 1);
  const T du = w.u >= w.v ? z10 - z00 : z11 - z01, dv = w.u >= w.v ? z11 - z10 : z01 - z00;
  const T sx = du / g.cell, sy = dv / g.cell;
  const T above = z - (z00 + du * w.u + dv * w.v);
  const T nz = T(1) / squareRoot(T(1) + sx * sx + sy * sy);
  contact = {above * nz,
             {-sx * nz, -sy * nz, nz},
             static_cast<std::size_t>(j) * static_cast<std::size_t>(g.width) + static_cast<std::size_t>(i)};
  const T sideways = above < T(0) ? -above : above;
  // Nothing can be nearer than the ground straight below, nor is what lies deep worth a search.
  if (above < -reach) return true;
  const T seen = sideways < reach ? sideways : reach;
  const bool ground = above == above;  // else a hole
  if (ground && w.flat({T(0), T(0), -above}, contact.normal, seen, T(0.05) * reach))
    return contact.distance < reach;
  HeightVector<T> point{}, normal{};
  const T radius = seen < reach ? seen * T(1.0001) + T(1e-6) * g.cell : reach;
  if (!w.nearest(radius, point, normal, contact.quad)) return false;
  const T distance = squareRoot(point.dot(point)), size = squareRoot(normal.dot(normal));
  const bool under = above < T(0);
  contact.normal =
      distance > T(1e-4) * g.cell ? point * ((under ? T(1) : T(-1)) / distance) : normal * (T(1) / size);
  contact.distance = under ? -distance : distance;
  return contact.distance < reach;
}

}  // namespace spin
