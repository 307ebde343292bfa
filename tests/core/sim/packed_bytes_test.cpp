// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/packed_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "core/base/random.h"

namespace spin {
namespace {

std::vector<char> smoothField(std::size_t floats) {
  std::vector<char> bytes(floats * sizeof(float));
  for (std::size_t i = 0; i < floats; ++i) {
    const float value = 1.0f + 0.2f * std::sin(0.001f * static_cast<float>(i));
    std::memcpy(bytes.data() + i * sizeof value, &value, sizeof value);
  }
  return bytes;
}

TEST(PackedBytes, ComeBackAsTheyWere) {
  for (const std::size_t size : {0u, 1u, 7u, 1000u, (16u << 20) + 5u}) {
    std::vector<char> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 2654435761u >> 13);
    const std::vector<char> packed = packBytes(bytes);
    EXPECT_EQ(unpackBytes(packed), bytes) << size;
    EXPECT_EQ(packBytes(bytes), packed) << "the same bytes each time";
    EXPECT_LE(packed.size(), size + size / 1000 + 64) << "never much larger";
  }
}

#ifdef SPIN_HAS_BLOSC
TEST(PackedBytes, SmoothFieldsShrink) {
  const std::vector<char> bytes = smoothField(100000);
  EXPECT_LT(packBytes(bytes).size(), bytes.size() * 6 / 10);
}
#endif

TEST(PackedBytes, DamageIsFoundOrHarmless) {
  const std::vector<char> bytes = smoothField(5000);
  const std::vector<char> packed = packBytes(bytes);
  EXPECT_FALSE(unpackBytes({}));
  EXPECT_FALSE(unpackBytes({7, 1, 2, 3}));
  const CounterRandom random{3, 0x7061636bu};
  for (std::uint32_t k = 0; k < 2000; ++k) {
    const UInt4 words = random.words(k, 0);
    std::vector<char> damaged = packed;
    damaged[words.x % damaged.size()] = static_cast<char>(words.y);
    if (words.z % 3 == 0) damaged.resize(words.w % damaged.size());
    const auto out = unpackBytes(damaged);
    EXPECT_LE(out ? out->size() : 0u, std::size_t{16} << 20);
  }
}

}  // namespace
}  // namespace spin
