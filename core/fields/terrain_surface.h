// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/fields/raster.h"

namespace spin {

/// The terrain as one triangulated surface through the cell centres, the only definition that ray casting,
/// cover, placement and drawing share. A quad (i, j) spans cells (i, j) .. (i+1, j+1) and is cut along the
/// diagonal from (i, j) to (i+1, j+1); it exists only where all four corners have data.
class TerrainSurface {
 public:
  /// Keeps a reference: the raster must outlive the surface.
  explicit TerrainSurface(const Raster<float>& heights) : m_heights(&heights) {}

  const Raster<float>& heights() const { return *m_heights; }
  bool quadExists(int i, int j) const;
  /// Height of the surface at a local position; nothing outside or in a hole.
  std::optional<double> heightAt(double x, double y) const;
  /// The same, beyond the rim and in holes that of the nearest cell with data (by the raster's rows and
  /// columns); 0 where there is none at all.
  double nearestHeight(double x, double y) const;
  /// Unit upward normal at a local position; (0, 0, 1) outside or in a hole.
  Vec3d normalAt(double x, double y) const;
  /// Horizontal area of the part of the surface that belongs to cell (i, j): a quarter quad for each existing
  /// quad round it, m2.
  double cellArea(int i, int j) const;
  /// First hit of the ray from `from` along `direction` (any length) with the surface, from either side;
  /// nothing if it misses. Exact: every triangle the ray passes is asked.
  std::optional<Vec3d> raycast(Vec3d from, Vec3d direction) const;

 private:
  const Raster<float>* m_heights;
};

/// Lowest and highest value that is not NaN; {0, 0} if there is none.
Vec2d valueRange(const Raster<float>& raster);
/// Local bounding box of all cells with data.
Box3d boundsOf(const Raster<float>& heights);

}  // namespace spin
