// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/parallel.h"
#include "core/fields/raster.h"
#include "core/fields/tiled_raster.h"

/// Filling painted layers by the shape of the terrain.
namespace spin {

/// A range of a measure with soft edges: 1 from low to high, falling smoothly to 0 over `soft` on either
/// side. A range that is off is 1 everywhere.
struct SoftRange {
  bool on = false;
  double low = 0.0, high = 0.0;
  double soft = 0.0;  ///< same unit as low and high, >= 0

  /// Weight 0..1; 0 for NaN while on.
  double weight(double value) const;
  /// The same for directions in degrees: from low clockwise to high, so that 300 to 60 passes north.
  double weightOfDirection(double degrees) const;
};

/// Which parts of the terrain are filled: the product of the three.
struct FillRule {
  SoftRange altitude;  ///< m above sea (height of the terrain plus the height of its origin)
  SoftRange slope;     ///< degrees from level
  SoftRange aspect;    ///< degrees, the way the ground faces: 0 north, 90 east
};

/// How the ground stands at each point of the terrain, in degrees; NaN where there is no ground. The aspect
/// of level ground is NaN too.
struct TerrainShape {
  Raster<float> slope, aspect;
};

/// By central differences, at rims and beside holes by one-sided ones (Zevenbergen and Thorne 1987).
TerrainShape terrainShape(const Raster<float>& heights, CpuBackend& backend);

/// Weight 0..1 at each point, 0 in holes. `seaLevel` is the height above sea of the terrain's local zero.
Raster<float> fillWeights(const Raster<float>& heights, const TerrainShape& shape, const FillRule& rule,
                          double seaLevel, CpuBackend& backend);

/// What a fill does to what is painted there.
enum class FillCombine : std::uint8_t { Replace, Max, Add };

struct LayerFill {
  FillCombine combine = FillCombine::Replace;
  double value = 0.0;
  double base = 0.0;                ///< what holds where nothing is painted: soft edges lead there
  double least = 0.0, most = 1e30;  ///< results are kept between
};

/// A layer filled with the weights; both have the same size. Replace leads from what is there to the value,
/// Add adds the weighted value, Max keeps what is there where that is more. Points whose weight is below
/// 1/512 keep what they have; untouched tiles stay shared.
TiledRaster<float> filled(TiledRaster<float> layer, const Raster<float>& weights, const LayerFill& fill);
/// The same for a layer of names: each point takes the value with the probability of its weight, by a dice
/// throw that belongs to the point, so that soft edges become a scatter and a repeated fill is the same.
TiledRaster<std::uint8_t> filled(TiledRaster<std::uint8_t> layer, const Raster<float>& weights,
                                 std::uint8_t value);

}  // namespace spin
