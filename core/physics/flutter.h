// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/math/vec.h"
#include "core/physics/turn_sine.h"

namespace spin {

/// How a flake swings about its mean path. Either is a function of time alone: it needs no state, adds no
/// drift and leaves the fall speed as it is.
enum class FlutterLaw : std::uint8_t {
  Steady,    ///< sin(a)
  Decaying,  ///< sin(a)/(1 + a/(2 pi)), begun anew after kSwings swings
};

/// What a flake keeps for life of its flutter, drawn from its number. Two swings across each other, of
/// different rates, so that no heading and no common beat is seen in many flakes.
struct Flutter {
  double swing = 0.0;       ///< share of the amplitude, 0..1
  double mainShare = 1.0;   ///< of the swing along `heading`; the rest goes across, by Pythagoras
  Vec2d rates{1.0, 1.0};    ///< factors on the rate
  Vec2d phases{};           ///< rad, of all the swings until the law begins anew
  Vec2d heading{1.0, 0.0};  ///< unit vector
};

inline constexpr double kSwings = 4.0;  ///< of the decaying law, until it begins anew

inline Flutter drawFlutter(const CounterRandom& random, std::uint64_t flake) {
  const UInt4 a = random.words(flake, 0), b = random.words(flake, 1), c = random.words(flake, 2);
  Flutter f;
  f.swing = toUnitDouble(a.x, a.y);
  f.rates = {0.7 + 0.6 * toUnitDouble(a.z, a.w), 0.7 + 0.6 * toUnitDouble(c.x, c.y)};
  const double whole = 2.0 * kPi * kSwings;
  f.phases = {whole * toUnitDouble(b.x, b.y), whole * static_cast<double>(toUnitFloat(c.z))};
  const double heading = 2.0 * kPi * toUnitDouble(b.z, b.w);
  f.heading = {std::cos(heading), std::sin(heading)};
  f.mainShare = std::cos(kPi / 4.0 * static_cast<double>(toUnitFloat(c.w)));
  return f;
}

/// A place on a swing and how fast it goes, per radian.
struct Swing {
  double offset = 0.0, slope = 0.0;
};

/// The decaying law divides by 1 + a/(2 pi) where the published one (Tang and Zhang) divides by the time
/// since release, which is singular there. It begins anew where it is zero, so it has no leap.
inline Swing swingAt(FlutterLaw law, double angle) {
  if (law == FlutterLaw::Steady) return {std::sin(angle), std::cos(angle)};
  const double whole = 2.0 * kPi * kSwings;
  const double a = angle - whole * std::floor(angle / whole);
  const double damping = 1.0 / (1.0 + a / (2.0 * kPi));
  return {std::sin(a) * damping, (std::cos(a) - std::sin(a) * damping / (2.0 * kPi)) * damping};
}

/// The same laws for a number, a pack and CUDA, by the angle in turns; slope per radian.
template <class V>
struct TurnSwing {
  V offset, slope;
};
template <class V>
SPIN_HD_INLINE TurnSwing<V> steadySwing(V turns) {
  return {turnSine(turns), turnCosine(turns)};
}
template <class V>
SPIN_HD_INLINE TurnSwing<V> decayingSwing(V turns) {
  const V since = turns - lit<V>(kSwings) * wholeBelow(turns * lit<V>(1.0 / kSwings));
  const V damping = lit<V>(1.0) / (lit<V>(1.0) + since);
  const V offset = turnSine(turns) * damping;
  return {offset, (turnCosine(turns) - offset * lit<V>(0.5 / kPi)) * damping};
}

/// Offset from the mean path, m, and its rate, m/s, both horizontal, at a film time; amplitude in m, rate in
/// rad/s.
struct FlutterState {
  Vec2d offset{}, velocity{};
};
inline FlutterState flutterAt(const Flutter& flutter, FlutterLaw law, double amplitude, double rate,
                              double time) {
  const double r1 = rate * flutter.rates.x, r2 = rate * flutter.rates.y;
  const Swing along = swingAt(law, r1 * time + flutter.phases.x);
  const Swing across = swingAt(law, r2 * time + flutter.phases.y);
  const double a1 = amplitude * flutter.swing * flutter.mainShare;
  const double a2 = amplitude * flutter.swing * std::sqrt(1.0 - flutter.mainShare * flutter.mainShare);
  const Vec2d e = flutter.heading, n{-e.y, e.x};
  return {e * (a1 * along.offset) + n * (a2 * across.offset),
          e * (a1 * r1 * along.slope) + n * (a2 * r2 * across.slope)};
}

/// Amplitude and rate grow with the root of the force on the flake over its weight: the wind's force is
/// (wind/fall speed)^2 of the weight by the quadratic drag. Capped at three weights (both doubled) by taste:
/// no measured amplitude is published.
inline double flutterGain(double windSpeed, double fallSpeed) {
  const double ratio = windSpeed / fallSpeed;
  return std::sqrt(1.0 + std::fmin(ratio * ratio, 3.0));
}

}  // namespace spin
