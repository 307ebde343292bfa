// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/math/sampling.h"
#include "core/nodes/weather_nodes.h"
#include "core/physics/size_spectrum.h"
#include "core/sim/snapshot.h"

namespace spin {

const FlakeFallLaw& fallLaw(FlakeType type);

/// What weather and snowfall say at one film time; a scene without a weather node has its defaults.
struct SnowWeather {
  Vec3d wind{};                 ///< m/s
  double precipitation = 0.0;   ///< kg/(m2 s) of snow on level ground, rate factor included
  double rainfall = 0.0;        ///< kg/(m2 s) that falls as rain
  double airTemperature = 0.0;  ///< K
  SnowfallNode snowfall;
  SizeSpectrum spectrum;
};
SnowWeather snowWeatherAt(const SceneSnapshot& scene, double filmTime);
/// Sizes that rule the directions of fall: those at the weather's rate, or at the mean rate of a station's
/// record, lest every hour asks for new rays.
SizeSpectrum directingSpectrum(const SceneSnapshot& scene, const SnowWeather& weather);

/// Directions that snow comes down in: uniform in solid angle within a cone about the mean fall velocity.
struct FallCone {
  Frame3d frame{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}};  ///< n: mean direction of fall
  double oneMinusCos = 0.0;                          ///< of the half angle
  double halfAngle = 0.0;                            ///< rad

  /// Unit direction of fall for u, v in [0, 1); its z is negative.
  Vec3d direction(double u, double v) const { return coneDirection(frame, oneMinusCos, u, v); }

  friend bool operator==(const FallCone&, const FallCone&) = default;
};

/// Cone for a wind and a fall speed (> 0), m/s. Where the cone would hold directions that do not come down
/// (strong wind, wide spread) it is narrowed to 3/4 of the mean direction's angle below the horizon. The
/// drift wind/fallSpeed is rounded to steps of 0.002 so that a slow change does not ask for new rays every
/// frame.
FallCone fallCone(Vec3d wind, double fallSpeed, double spreadRadians);

/// Flux that one direction of fall w brings through a surface with unit normal n, per flux through a level
/// plane: -(n.w)/|w_z|; negative where it comes from behind. On a slope of normal n, divided by n_z, it is
/// the arrival per horizontal area.
inline double levelFluxFactor(Vec3d n, Vec3d w) {
  return -dot(n, w) / std::abs(w.z);
}

}  // namespace spin
