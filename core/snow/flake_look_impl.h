// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The loop over flakes, once per instruction set: SPIN_ISA names its namespace.
#include "core/math/simd_pack.h"
#include "core/physics/flutter.h"
#include "core/snow/flake_groups.h"
#include "core/snow/flake_look.h"

namespace spin::SPIN_ISA {
namespace {

static_assert(kFlakeBlock % kLanes == 0);

/// What the flakes of a block have in common.
struct BlockMotion {
  FlakeRow row;
  std::int32_t centre[3];
};

SPIN_HD_INLINE std::int32_t fraction32(double turns) {
  double whole = static_cast<double>(static_cast<std::int64_t>(turns));
  if (whole > turns) whole -= 1.0;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>((turns - whole) * 4294967296.0));
}

SPIN_HD_INLINE BlockMotion motionOf(const FlakeLookView& view, std::size_t block) {
  const float place = view.blockClass[block];
  const int j = static_cast<int>(place);
  const float t = place - static_cast<float>(j);
  BlockMotion m;
  const float* a = view.rows[j].velocity;
  const float* b = view.rows[j + 1].velocity;
  float* out = m.row.velocity;
  for (int k = 0; k < kFlakeRowFloats; ++k) out[k] = a[k] + (b[k] - a[k]) * t;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double c = view.centre[j][axis], d = view.centre[j + 1][axis];
    m.centre[axis] = fraction32(c + (d - c) * static_cast<double>(t));
  }
  return m;
}

/// 0 below a, 1 above b, smooth between.
SPIN_HD_INLINE Pack ramp(Pack x, float a, float b) {
  const Pack t = minimum(maximum((x - Pack(a)) * Pack(1.0f / (b - a)), Pack(0.0f)), Pack(1.0f));
  return t * t * (Pack(3.0f) - (t + t));
}

SPIN_HD_INLINE Pack magnitude(Pack x) {
  return maximum(x, -x);
}

/// Share of a flake that shows, between the group's borders. Its distance is the one that it would have
/// without gusts, from where a flake at the eye would be: so the borders lie inside the box whatever blows,
/// and all groups together fill every place evenly, since gusts keep volumes.
SPIN_HD_INLINE Pack fadeOf(const FlakeLookView& view, Pack distance) {
  return ramp(distance, view.nearFrom, view.nearTo) * (Pack(1.0f) - ramp(distance, view.farFrom, view.farTo));
}

SPIN_HD_INLINE Pack along(const float* axis, const GustPoint<Pack>& p) {
  return mulAdd(Pack(axis[0]), p.x, mulAdd(Pack(axis[1]), p.y, Pack(axis[2]) * p.z));
}

/// Bits of the lanes in view.
SPIN_HD_INLINE std::uint32_t inFrustum(const FlakeLookView& view, const GustPoint<Pack>& p) {
  const Pack depth = along(view.forward, p), margin = Pack(view.margin);
  const Pack x = magnitude(along(view.right, p)) - depth * Pack(view.tangentX);
  const Pack y = magnitude(along(view.up, p)) - depth * Pack(view.tangentY);
  return lessBits(x, margin) & lessBits(y, margin) & lessBits(-margin, depth);
}

SPIN_HD_INLINE void blow(const FlakeWave& w, float reach, GustPoint<Pack>& p) {
  followGust(
      p, GustPush<Pack>{Pack(w.wave[0]), Pack(w.wave[1]), Pack(w.wave[2]), Pack(w.push[0] * reach),
                        Pack(w.push[1] * reach), Pack(w.push[2] * reach), Pack(w.phase), Pack(w.turning)});
}

/// Adds the flutter and returns the turns of the main swing.
SPIN_HD_INLINE Pack swing(const FlakeLookView& view, const FlakeRow& row, std::size_t i, GustPoint<Pack>& p) {
  const Pack turns(row.turns), rate1 = Pack::load(view.seeds[2] + i), rate2 = Pack::load(view.seeds[3] + i);
  const Pack turns1 = mulAdd(turns, rate1, Pack::load(view.seeds[0] + i));
  const Pack turns2 = mulAdd(turns, rate2, Pack::load(view.seeds[1] + i));
  const TurnSwing<Pack> s1 = view.decaying ? decayingSwing(turns1) : steadySwing(turns1);
  const TurnSwing<Pack> s2 = view.decaying ? decayingSwing(turns2) : steadySwing(turns2);
  const Pack amplitude(row.swing), speed(row.swing * row.turnRate * 6.28318530718f);
  const Pack ax = Pack::load(view.seeds[4] + i), ay = Pack::load(view.seeds[5] + i),
             across = Pack::load(view.seeds[6] + i);
  const Pack o1 = s1.offset * amplitude, o2 = s2.offset * amplitude * across;
  p.x = p.x + (ax * o1 - ay * o2);
  p.y = p.y + (ay * o1 + ax * o2);
  const Pack v1 = s1.slope * speed * rate1, v2 = s2.slope * speed * rate2 * across;
  p.vx = p.vx + (ax * v1 - ay * v2);
  p.vy = p.vy + (ay * v1 + ax * v2);
  return turns1;
}

/// Where the flakes of a pack are before any gust, from the eye.
SPIN_HD_INLINE GustPoint<Pack> startOf(const FlakeLookView& view, const BlockMotion& m, std::size_t i,
                                       Pack& distance) {
  const FlakeRow& row = m.row;
  const Pack box(view.box), unit(2.3283064e-10f);  // 2^-32
  Pack u[3];
  for (std::size_t axis = 0; axis < 3; ++axis)
    u[axis] = toFloat(IntPack::load(view.place[axis] + i) - IntPack(m.centre[axis])) * unit;
  distance = squareRoot(mulAdd(u[0], u[0], mulAdd(u[1], u[1], u[2] * u[2]))) * box;
  return {mulAdd(u[0], box, Pack(row.back[0])),
          mulAdd(u[1], box, Pack(row.back[1])),
          mulAdd(u[2], box, Pack(row.back[2])),
          Pack(row.velocity[0]),
          Pack(row.velocity[1]),
          Pack(row.velocity[2])};
}

/// Lets the blown flakes of a pack swing and writes those that show to `at`; returns their number.
SPIN_HD_INLINE std::size_t tellPack(const FlakeLookView& view, const FlakeRow& row, std::size_t i,
                                    Pack distance, GustPoint<Pack> p, std::size_t at) {
  const Pack turns = swing(view, row, i, p), character = Pack::load(view.seeds[7] + i);
  const Pack fade = fadeOf(view, distance);
  // The character's last digits choose the share, so that it does not go with what the flake looks like.
  const Pack rank = character * Pack(977.0f) - wholeBelow(character * Pack(977.0f));
  std::uint32_t shown = lessBits(Pack(view.leastFade), fade) & lessBits(rank, Pack(view.share));
  if (view.frustum) shown &= inFrustum(view, p);
  if (shown == 0) return 0;
  const Compressor keep(shown);
  const Pack first(static_cast<float>(i));
  const Pack values[kFlakeRecord] = {p.x,
                                     p.y,
                                     p.z,
                                     p.vx,
                                     p.vy,
                                     p.vz,
                                     Pack(row.diameter),
                                     Pack(view.weight),
                                     fade,
                                     character,
                                     turns - nearestWhole(turns),
                                     first + toFloat(IntPack::iota())};
  for (std::size_t k = 0; k < kFlakeRecord; ++k) keep.store(values[k], view.out[k] + at);
  return keep.count();
}

/// Two packs at once: a wave waits for the one before, so the processor works on the other pack meanwhile.
SPIN_HD_INLINE std::size_t lookAtPair(const FlakeLookView& view, const BlockMotion& a, const BlockMotion& b,
                                      std::size_t i, std::size_t at) {
  Pack distanceA, distanceB;
  GustPoint<Pack> p = startOf(view, a, i, distanceA), q = startOf(view, b, i + kLanes, distanceB);
  for (int m = 0; m < view.waveCount; ++m) {
    blow(view.waves[m], a.row.reach[m], p);
    blow(view.waves[m], b.row.reach[m], q);
  }
  const std::size_t first = tellPack(view, a.row, i, distanceA, p, at);
  return first + tellPack(view, b.row, i + kLanes, distanceB, q, at + first);
}

SPIN_HD_INLINE std::size_t lookAtPack(const FlakeLookView& view, const BlockMotion& a, std::size_t i,
                                      std::size_t at) {
  Pack distance;
  GustPoint<Pack> p = startOf(view, a, i, distance);
  for (int m = 0; m < view.waveCount; ++m) blow(view.waves[m], a.row.reach[m], p);
  return tellPack(view, a.row, i, distance, p, at);
}

std::size_t lookAtFlakes(const FlakeLookView& flakes, std::size_t begin, std::size_t end) {
  const FlakeLookView view = flakes;  // a copy that no store can reach
  std::size_t count = 0, block = begin;
  if constexpr (kFlakeBlock == kLanes) {
    for (; block + 1 < end; block += 2)
      count += lookAtPair(view, motionOf(view, block), motionOf(view, block + 1), block * kFlakeBlock, count);
    if (block < end) count += lookAtPack(view, motionOf(view, block), block * kFlakeBlock, count);
  } else {
    for (; block < end; ++block) {
      const BlockMotion motion = motionOf(view, block);
      for (std::size_t lane = 0; lane < kFlakeBlock; lane += 2 * kLanes)
        count += lookAtPair(view, motion, motion, block * kFlakeBlock + lane, count);
    }
  }
  return count;
}

}  // namespace

FlakeLook flakeLook() {
  return lookAtFlakes;
}

}  // namespace spin::SPIN_ISA
