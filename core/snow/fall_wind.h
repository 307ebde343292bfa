// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/sim/flakes_part.h"
#include "core/snow/snow_ground.h"
#include "core/snow/wind_field.h"

namespace spin {

/// Solves the winds over a scene's land and models where they stand when the film begins. The columns lie
/// round the models, where there are any on it, else over the whole terrain. Null where there is no terrain,
/// or when cancelled.
std::shared_ptr<const WindTable> makeFallWindTable(const SceneSnapshot& scene, const SnowGround& ground,
                                                   CpuBackend& backend, const CancelToken& cancel = {});

/// Where the wind round land and models takes falling flakes, beside their way in the mean wind: the change
/// of the wind summed up along that way, d(p) = integral of u'(p - V s) ds over s > 0, V being the velocity
/// of a flake that falls at kMiddleFall. It is a function of the place alone, so flakes need no memory of
/// where they came from; and as u' loses no air, d keeps volumes to first order: flakes that are spread
/// evenly stay so.
///
/// It cannot do what WindField cannot: wakes, eddies behind houses, stagnant corners smaller than a column.
/// Flakes of all sizes are taken along alike, moving models do not count, and where a wind changes, its whole
/// way is that of the present wind.
class FallWind {
 public:
  static constexpr double kMiddleFall = 1.2;  ///< m/s
  /// Wind up to which nothing changes, m/s. The change grows to its whole up to five times that.
  static constexpr double kCalm = 0.1;

  /// wind: m/s, more than kCalm.
  FallWind(std::shared_ptr<const WindTable> table, Vec2d wind, CpuBackend& backend);
  /// The same for a frame's flakes; null where nothing changes their wind.
  static std::shared_ptr<const FallWind> of(const FallingFlakes& flakes, CpuBackend& backend);
  /// Whether a frame's flakes would get the same one.
  bool holdsFor(const FallingFlakes& flakes) const;

  /// How far a flake that would be at p is beside it, m.
  Vec3d shiftAt(Vec3d p) const;
  /// What this adds to the velocity, m/s, of a flake that would go with `velocity` at p: the rate of its
  /// shift along its own way.
  Vec3d velocityAt(Vec3d p, Vec3d velocity) const;
  /// The place without this wind of a flake that is at p with it, as near as a few steps come.
  Vec3d before(Vec3d p) const;
  /// By how much shifts within a box round p differ from that at p, about the most, m.
  double spread(Vec3d p, double halfBox) const;

 private:
  Vec3d sample(const std::vector<Vec3f>& values, Vec3d p) const;
  double windowAt(double x, double y) const;
  Vec3d arrive(Vec3d p, const std::vector<Vec3f>& change) const;

  WindField m_field;
  Vec2d m_wind;
  double m_strength = 1.0;       ///< share of the change that shows
  std::vector<double> m_levels;  ///< shares of the air's depth
  std::vector<Vec3f> m_shift;    ///< by column, levels within
};

}  // namespace spin
