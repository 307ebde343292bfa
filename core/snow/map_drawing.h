// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/atomic_extent.h"
#include "core/math/vec.h"

namespace spin {

/// Texels of an occlusion map that are drawn, [from, to).
struct DrawnTexels {
  int fromColumn = 0, toColumn = 0, fromRow = 0, toRow = 0;
};

/// A place (m) to texels whose centres are at whole numbers, z its depth in m.
struct MapProjection {
  Vec3f s{}, t{}, n{};
  float scale = 1.0f;  ///< texels a m
  float u = 0.0f, v = 0.0f;

  SPIN_HD_INLINE Vec3f operator()(const Vec3f& p) const {
    return {dot(p, s) * scale - u, dot(p, t) * scale - v, dot(p, n)};
  }
};

/// Texels within [low, high], clamped to [from, to).
struct TexelRange {
  int first = 0, last = -1;

  SPIN_HD_INLINE static TexelRange in(float low, float high, int from, int to) {
    const float least = static_cast<float>(from), most = static_cast<float>(to);
    const auto held = [](float x, float a, float b) { return x < a ? a : (x > b ? b : x); };
    return {static_cast<int>(ceilf(held(low, least, most))),
            static_cast<int>(floorf(held(high, least - 1.0f, most - 1.0f)))};
  }
};

/// A triangle in texels by its edge functions (Pineda 1988): weights of its second and third corner grow
/// linearly over the map.
struct DrawnTriangle {
  Vec3f a{};
  float bu = 0.0f, bv = 0.0f, cu = 0.0f, cv = 0.0f, db = 0.0f, dc = 0.0f;
  TexelRange columns, rows;

  /// False where it covers no texel that is drawn.
  SPIN_HD_INLINE bool set(const Vec3f& p, const Vec3f& q, const Vec3f& r, const DrawnTexels& texels) {
    const auto least = [](float x, float y, float z) { return x < y ? (x < z ? x : z) : (y < z ? y : z); };
    const auto most = [](float x, float y, float z) { return x > y ? (x > z ? x : z) : (y > z ? y : z); };
    columns = TexelRange::in(least(p.x, q.x, r.x), most(p.x, q.x, r.x), texels.fromColumn, texels.toColumn);
    if (columns.first > columns.last) return false;
    rows = TexelRange::in(least(p.y, q.y, r.y), most(p.y, q.y, r.y), texels.fromRow, texels.toRow);
    if (rows.first > rows.last) return false;
    const float doubled = (q.x - p.x) * (r.y - p.y) - (r.x - p.x) * (q.y - p.y);
    if (doubled == 0.0f) return false;
    const float inverse = 1.0f / doubled;
    a = p;
    bu = (r.y - p.y) * inverse, bv = (p.x - r.x) * inverse;
    cu = (p.y - q.y) * inverse, cv = (q.x - p.x) * inverse;
    db = q.z - p.z, dc = r.z - p.z;
    return true;
  }
  /// Whether it covers a texel, with its depth there. On the border within rounding counts as inside, so that
  /// neighbours leave no gap.
  SPIN_HD_INLINE bool at(float column, float row, float& depth) const {
    constexpr float kEdge = -1e-5f;
    const float x = column - a.x, y = row - a.y;
    const float b = bu * x + bv * y, c = cu * x + cv * y;
    depth = a.z + b * db + c * dc;
    return b >= kEdge && c >= kEdge && b + c <= 1.0f - kEdge;
  }
};

/// Depths as whole numbers of the same order, for a minimum by many threads.
SPIN_HD_INLINE std::int32_t orderedDepth(float depth) {
  const auto bits = std::bit_cast<std::int32_t>(depth);
  return bits < 0 ? bits ^ INT32_MAX : bits;
}
SPIN_HD_INLINE float depthOf(std::int32_t ordered) {
  return std::bit_cast<float>(ordered < 0 ? ordered ^ INT32_MAX : ordered);
}

/// Draws one triangle of a list into a map, beside others.
struct DrawKernel {
  const Vec3f* corners;  ///< three of a triangle after each other, m
  MapProjection project;
  DrawnTexels texels;
  int columns;          ///< of the map
  std::int32_t* depth;  ///< ordered, by texel

  SPIN_HD_INLINE void operator()(std::size_t i) const {
    DrawnTriangle triangle;
    if (!triangle.set(project(corners[3 * i]), project(corners[3 * i + 1]), project(corners[3 * i + 2]),
                      texels))
      return;
    for (int row = triangle.rows.first; row <= triangle.rows.last; ++row)
      for (int column = triangle.columns.first; column <= triangle.columns.last; ++column) {
        float z = 0.0f;
        if (triangle.at(static_cast<float>(column), static_cast<float>(row), z))
          lowerTo(depth[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column)],
                  orderedDepth(z));
      }
  }
};

}  // namespace spin
