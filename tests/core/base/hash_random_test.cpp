// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/base/hash.h"
#include "core/base/random.h"

namespace spin {
namespace {

void expectWords(UInt4 got, UInt4 expected) {
  EXPECT_EQ(got.x, expected.x);
  EXPECT_EQ(got.y, expected.y);
  EXPECT_EQ(got.z, expected.z);
  EXPECT_EQ(got.w, expected.w);
}

TEST(PhiloxTest, GivesTheKnownAnswers) {
  // Known-answer vectors for philox4x32, 10 rounds, of the Random123 library (Salmon et al. 2011).
  expectWords(philox4x32({0, 0, 0, 0}, 0), {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  expectWords(philox4x32({~0u, ~0u, ~0u, ~0u}, ~0ull), {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  expectWords(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822ull),
              {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST(CounterRandomTest, SeedStreamIndexAndDrawAllMatter) {
  const std::set<float> values = {
      CounterRandom{1, 2}.uniform(3, 4), CounterRandom{2, 2}.uniform(3, 4),
      CounterRandom{1, 3}.uniform(3, 4), CounterRandom{1, 2}.uniform(4, 4),
      CounterRandom{1, 2}.uniform(3, 5), CounterRandom{1, 2}.uniform(3ull << 32, 4)};
  EXPECT_EQ(values.size(), 6u);
  EXPECT_EQ((CounterRandom{1, 2}.uniform(3, 4)), (CounterRandom{1, 2}.uniform(3, 4)));
}

TEST(CounterRandomTest, UniformHasTheRightMoments) {
  const CounterRandom random{99, 1};
  double sum = 0, squares = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double u = random.uniformDouble(static_cast<std::uint64_t>(i));
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Five standard errors of the mean and of the second moment.
  EXPECT_NEAR(sum / n, 0.5, 5 * std::sqrt(1.0 / 12 / n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / n));
}

TEST(CounterRandomTest, UnitIntervalExcludesOne) {
  EXPECT_EQ(toUnitFloat(0), 0.0f);
  EXPECT_LT(toUnitFloat(~0u), 1.0f);
  EXPECT_EQ(toUnitDouble(0, 0), 0.0);
  EXPECT_LT(toUnitDouble(~0u, ~0u), 1.0);
}

TEST(HashTest, IsStableOverVersions) {
  // Keys of stored frames depend on these: XXH3, 128 bits, of nothing and of the framed text "snow".
  EXPECT_EQ(Hasher().digest().hex(), "99aa06d3014798d86001c324468d497f");
  Hasher text;
  text.add("snow");
  Hasher framed;
  framed.add(std::uint64_t{4}).addBytes("snow", 4);
  EXPECT_EQ(text.digest(), framed.digest());
}

TEST(HashTest, FramesStrings) {
  Hasher a, b;
  a.add("ab").add("c");
  b.add("a").add("bc");
  EXPECT_NE(a.digest(), b.digest());
}

TEST(HashTest, OrderAndTypeMatter) {
  Hasher a, b, c;
  a.add(1).add(2);
  b.add(2).add(1);
  c.add(std::int64_t{1}).add(std::int64_t{2});
  EXPECT_NE(a.digest(), b.digest());
  EXPECT_NE(a.digest(), c.digest());
}

TEST(HashTest, StreamingEqualsOneCall) {
  std::vector<unsigned char> bytes(10000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(i * 7);
  Hasher whole, parts;
  whole.addBytes(bytes.data(), bytes.size());
  for (std::size_t at = 0; at < bytes.size(); at += 37)
    parts.addBytes(bytes.data() + at, std::min<std::size_t>(37, bytes.size() - at));
  EXPECT_EQ(whole.digest(), parts.digest());
}

TEST(HashTest, HexHas32DigitsAndKnowsNull) {
  EXPECT_EQ(Hash128{}.hex(), std::string(32, '0'));
  EXPECT_TRUE(Hash128{}.isNull());
  EXPECT_EQ((Hash128{0x0123456789abcdefull, 0xfull}.hex()), "0123456789abcdef000000000000000f");
}

}  // namespace
}  // namespace spin
