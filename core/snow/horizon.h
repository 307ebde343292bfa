// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"
#include "core/fields/raster.h"
#include "core/math/vec.h"

namespace spin {

/// What terrain hides of the sky, cell by cell: the height of the horizon in even steps of azimuth, and from
/// it shadow and sky view. A cell without data has a free horizon.
class HorizonMap {
 public:
  static constexpr int kSectors = 32;

  /// reach: m, how far terrain is looked for. Steps grow with the distance, a tenth of it at most.
  static HorizonMap make(const Raster<float>& heights, double reach, CpuBackend& backend);

  std::size_t size() const { return m_normals.size(); }
  /// Unit normal of the cell's ground, by central differences.
  Vec3d normal(std::size_t cell) const { return m_normals[cell].to<double>(); }
  /// Tangent of the horizon's height towards an azimuth (rad from north through east).
  double horizonTangent(std::size_t cell, double azimuth) const;
  /// Direct light over that on level ground, 0 in shadow.
  double beamFactor(std::size_t cell, Vec3d towardsSun) const;
  /// Share of the diffuse light that reaches the slope (Dozier and Frew 1990): 1 on a free plane.
  double skyView(std::size_t cell) const;

 private:
  std::vector<float> m_tangents;  ///< cell by cell, kSectors each
  std::vector<Vec3f> m_normals;
};

}  // namespace spin
