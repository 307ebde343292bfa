// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/check.h"
#include "core/math/vec.h"

namespace spin {

/// Regular grid of values at cell centres, in local metres: column i runs east (x), row j runs NORTH (y), so
/// row 0 is the southern one (files with the north row first are flipped by their reader). Value (i, j)
/// stands at (originX + i cellSize, originY + j cellSize).
template <class T>
struct Raster {
  int width = 0;
  int height = 0;
  double originX = 0.0;   ///< local x of the centre of cell (0, 0), m
  double originY = 0.0;   ///< local y of the centre of cell (0, 0), m
  double cellSize = 1.0;  ///< m
  std::vector<T> values;

  Raster() = default;
  Raster(int w, int h, double x0, double y0, double cell, T fill = T{})
      : width(w),
        height(h),
        originX(x0),
        originY(y0),
        cellSize(cell),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

  template <class U>
  Raster<U> sameShape(U fill = U{}) const {
    return Raster<U>(width, height, originX, originY, cellSize, fill);
  }
  template <class U>
  bool hasShapeOf(const Raster<U>& o) const {
    return width == o.width && height == o.height && originX == o.originX && originY == o.originY &&
           cellSize == o.cellSize;
  }
  bool empty() const { return values.empty(); }
  std::size_t size() const { return values.size(); }
  bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < width && j < height; }
  std::size_t index(int i, int j) const {
    SPIN_DCHECK(contains(i, j), "raster index out of range");
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }
  T& at(int i, int j) { return values[index(i, j)]; }
  const T& at(int i, int j) const { return values[index(i, j)]; }
  double x(int i) const { return originX + i * cellSize; }
  double y(int j) const { return originY + j * cellSize; }
  /// Nearest cell of a local position; may lie outside.
  int column(double px) const { return static_cast<int>(std::lround((px - originX) / cellSize)); }
  int row(double py) const { return static_cast<int>(std::lround((py - originY) / cellSize)); }
};

/// Where local coordinates lie in the world: world = local + origin. Kept through to exports.
struct GeoReference {
  Vec3d origin{};   ///< world coordinates of the local origin, m
  int epsg = 0;     ///< 0 = unknown
  std::string wkt;  ///< full text of the coordinate system where the file had one
  friend bool operator==(const GeoReference&, const GeoReference&) = default;
};

/// Height in m at cell centres, NaN where the source has no data.
struct TerrainData {
  Raster<float> heights;  ///< local z = world z - geo.origin.z
  GeoReference geo;
  std::string credit;  ///< credit line found in or beside the file, may be empty
};

}  // namespace spin
