// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/base/host_device.h"

namespace spin {

struct UInt4 {
  std::uint32_t x, y, z, w;
};

namespace detail {

SPIN_HD inline UInt4 philoxRound(UInt4 c, std::uint32_t k0, std::uint32_t k1) {
  const std::uint64_t p0 = 0xD2511F53ull * c.x;
  const std::uint64_t p1 = 0xCD9E8D57ull * c.z;
  return {static_cast<std::uint32_t>(p1 >> 32) ^ c.y ^ k0, static_cast<std::uint32_t>(p1),
          static_cast<std::uint32_t>(p0 >> 32) ^ c.w ^ k1, static_cast<std::uint32_t>(p0)};
}

}  // namespace detail

/// Philox4x32-10, a counter-based generator: the same counter and key give the same four words on every
/// machine and in every order. Source: Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3".
SPIN_HD inline UInt4 philox4x32(UInt4 counter, std::uint64_t key) {
  std::uint32_t k0 = static_cast<std::uint32_t>(key);
  std::uint32_t k1 = static_cast<std::uint32_t>(key >> 32);
  for (int round = 0; round < 10; ++round) {
    counter = detail::philoxRound(counter, k0, k1);
    k0 += 0x9E3779B9u;
    k1 += 0xBB67AE85u;
  }
  return counter;
}

/// Uniform in [0, 1) with 24 bits.
SPIN_HD inline float toUnitFloat(std::uint32_t word) {
  return static_cast<float>(word >> 8) * 0x1p-24f;
}
/// Uniform in [0, 1) with 53 bits.
SPIN_HD inline double toUnitDouble(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32 | low) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

/// Random numbers addressed by (seed, stream, index, draw): no state, so threads and restarts cannot change
/// them.
struct CounterRandom {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;

  SPIN_HD UInt4 words(std::uint64_t index, std::uint32_t draw = 0) const {
    return philox4x32(
        {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32), draw, stream}, seed);
  }
  SPIN_HD float uniform(std::uint64_t index, std::uint32_t draw = 0) const {
    return toUnitFloat(words(index, draw).x);
  }
  SPIN_HD double uniformDouble(std::uint64_t index, std::uint32_t draw = 0) const {
    const UInt4 w = words(index, draw);
    return toUnitDouble(w.x, w.y);
  }
};

}  // namespace spin
