// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/units.h"
#include "core/math/vec.h"
#include "core/physics/turn_sine.h"

/// Turbulent wind: a sum of plane shear waves (Kraichnan 1970), each pushing across its own direction, so
/// that the field has no divergence anywhere. The mean wind carries it along (Taylor's hypothesis) and each
/// wave turns over in about the time of an eddy of its size.
namespace spin {

/// Three octaves of three waves. The waves of an octave stand across each other, so that the three components
/// of the velocity have the same variance exactly.
inline constexpr int kGustModes = 9, kGustOctaves = 3;
inline constexpr double kGustRatio = 2.2;  ///< of the wavelengths of neighbouring octaves
inline constexpr double kEddyTurnover =
    0.5;  ///< wavelengths that an eddy goes by in the time of its own size

struct GustMode {
  Vec3d wave{};        ///< turns per metre; never points up
  Vec3d push{};        ///< m/s per m/s of strength, across the wave
  double phase = 0.0;  ///< turns
  double swept = 0.0;  ///< variance, per component and strength^2, of the waves before it, which carry it
};
using GustModes = std::array<GustMode, kGustModes>;

/// Waves of a field whose largest eddies have that length in m (> 0). The energy of an octave falls as
/// wavelength^(2/3) (Kolmogorov 1941), all together have the variance 1 per component.
GustModes makeGustModes(std::uint64_t seed, double length);

/// How far a field has come.
struct GustState {
  double strength = 0.0;  ///< root mean square of each component, m/s
  Vec3d carried{};        ///< way of the mean wind, m
  double eddyWay = 0.0;   ///< way by which eddies have changed: the integral of kEddyTurnover strength dt, m
};

/// Angle of a wave at a place, in turns.
inline double gustTurns(const GustMode& mode, const GustState& state, Vec3d p) {
  return dot(mode.wave, p - state.carried) + mode.phase + length(mode.wave) * state.eddyWay;
}

/// Velocity beside the mean wind, m/s, at a place in local metres.
inline Vec3d gustAt(const GustModes& modes, const GustState& state, Vec3d p) {
  Vec3d sum{};
  for (const GustMode& mode : modes) sum += mode.push * turnCosine(gustTurns(mode, state, p));
  return sum * state.strength;
}

/// What a body that falls through the air at a speed (m/s, >= 0) does in one wave: it swings along the push
/// with this amplitude over it, s, so that its velocity is the wave's. `relaxation`: time in which it follows
/// the wind, s. Waves never point up, so falling and turning over add up and no wave holds a body for ever.
inline double gustReach(const GustMode& mode, double strength, double fallSpeed, double relaxation) {
  const double k = length(mode.wave);
  const double own = -mode.wave.z * fallSpeed + k * kEddyTurnover * strength;
  const double rate = 2.0 * kPi * std::sqrt(own * own + mode.swept * k * k * strength * strength);
  return 1.0 / (std::fmax(rate, 1e-9) * std::sqrt(1.0 + rate * rate * relaxation * relaxation));
}

/// Place and velocity of a body on its way through the waves.
template <class V>
struct GustPoint {
  V x, y, z, vx, vy, vz;
};
/// One wave as it acts on a body; `turning`: turns per second at a place that stands still.
template <class V>
struct GustPush {
  V waveX, waveY, waveZ, reachX, reachY, reachZ, phase, turning;
};

/// Takes a body over one wave: the place moves along the push by the swing of the place's own angle, which
/// that leaves as it is. So a wave after the other makes a map that keeps volumes: flakes that are spread
/// evenly stay so, however far they are blown. The velocity is the exact derivative of the place.
template <class V>
SPIN_HD_INLINE void followGust(GustPoint<V>& b, const GustPush<V>& g) {
  const V turns = mulAdd(g.waveX, b.x, mulAdd(g.waveY, b.y, mulAdd(g.waveZ, b.z, g.phase)));
  const V rate = mulAdd(g.waveX, b.vx, mulAdd(g.waveY, b.vy, mulAdd(g.waveZ, b.vz, g.turning)));
  const V swing = turnSine(turns), speed = turnCosine(turns) * (lit<V>(2.0 * kPi) * rate);
  b.x = mulAdd(g.reachX, swing, b.x);
  b.y = mulAdd(g.reachY, swing, b.y);
  b.z = mulAdd(g.reachZ, swing, b.z);
  b.vx = mulAdd(g.reachX, speed, b.vx);
  b.vy = mulAdd(g.reachY, speed, b.vy);
  b.vz = mulAdd(g.reachZ, speed, b.vz);
}

}  // namespace spin
