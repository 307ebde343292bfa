// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#define SPIN_ISA isa_test
#include "core/math/simd_pack.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace spin::isa_test {
namespace {

using Lanes = std::array<float, kLanes>;

Lanes lanesOf(Pack p) {
  Lanes out;
  p.store(out.data());
  return out;
}

Lanes ramp(float start, float step) {
  Lanes out;
  for (int l = 0; l < kLanes; ++l) out[static_cast<std::size_t>(l)] = start + step * static_cast<float>(l);
  return out;
}

TEST(SimdPackTest, ArithmeticIsLaneByLane) {
  const Lanes a = ramp(-1.5f, 1.0f), b = ramp(4.0f, -0.75f);
  const Pack pa = Pack::load(a.data()), pb = Pack::load(b.data());
  const Lanes sum = lanesOf(pa + pb), product = lanesOf(pa * pb), ratio = lanesOf(pa / pb),
              negative = lanesOf(-pa);
  const Lanes low = lanesOf(minimum(pa, pb)), high = lanesOf(maximum(pa, pb));
  const Lanes chosen = lanesOf(selectLess(pa, pb, Pack(1.0f), Pack(2.0f)));
  const Lanes root = lanesOf(squareRoot(pa * pa)), fused = lanesOf(mulAdd(pa, pb, Pack(1.0f)));
  for (std::size_t l = 0; l < a.size(); ++l) {
    EXPECT_EQ(sum[l], a[l] + b[l]);
    EXPECT_EQ(product[l], a[l] * b[l]);
    EXPECT_EQ(ratio[l], a[l] / b[l]);
    EXPECT_EQ(negative[l], -a[l]);
    EXPECT_EQ(low[l], std::min(a[l], b[l]));
    EXPECT_EQ(high[l], std::max(a[l], b[l]));
    EXPECT_EQ(chosen[l], a[l] < b[l] ? 1.0f : 2.0f);
    EXPECT_EQ(root[l], std::abs(a[l]));
    EXPECT_NEAR(fused[l], a[l] * b[l] + 1.0f, 1e-5f);
  }
}

TEST(SimdPackTest, ReadsBySelectedPlaces) {
  std::array<float, 2 * kLanes> values{};
  for (std::size_t l = 0; l < values.size(); ++l) values[l] = 0.5f * static_cast<float>(l * l);
  const IntPack places = IntPack(2 * kLanes - 1) - IntPack(2) * IntPack::iota();
  const Lanes picked = lanesOf(gather(values.data(), places)), even = lanesOf(loadEven(values.data()));
  const Lanes pairs = lanesOf(loadPairSums(values.data())), doubled = lanesOf(loadDoubled(values.data()));
  const Lanes whole = lanesOf(toFloat(toInt(Pack::load(ramp(-2.75f, 1.0f).data()))));
  for (std::size_t l = 0; l < picked.size(); ++l) {
    EXPECT_EQ(picked[l], values[values.size() - 1 - 2 * l]);
    EXPECT_EQ(even[l], values[2 * l]);
    EXPECT_EQ(pairs[l], values[2 * l] + values[2 * l + 1]);
    EXPECT_EQ(doubled[l], values[l / 2]);
    EXPECT_EQ(whole[l], std::trunc(-2.75f + static_cast<float>(l)));
  }
}

TEST(SimdPackTest, CompressionKeepsTheSetLanesInOrder) {
  const Lanes a = ramp(10.0f, 1.0f);
  for (std::uint32_t bits = 0; bits < (1u << std::min(kLanes, 8)); ++bits) {
    std::array<float, 2 * kLanes> out{};
    std::array<std::int32_t, 2 * kLanes> numbers{};
    const Compressor keep(bits);
    keep.store(Pack::load(a.data()), out.data());
    keep.store(IntPack::iota(), numbers.data());
    std::size_t at = 0;
    for (int l = 0; l < kLanes; ++l) {
      if (!(bits >> l & 1)) continue;
      EXPECT_EQ(out[at], a[static_cast<std::size_t>(l)]) << bits;
      EXPECT_EQ(numbers[at], l) << bits;
      ++at;
    }
    EXPECT_EQ(keep.count(), at);
  }
}

TEST(SimdPackTest, ComparisonSetsABitPerLaneAndNaNIsNotLess) {
  Lanes a = ramp(0.0f, 1.0f);
  EXPECT_EQ(lessBits(Pack::load(a.data()), Pack(2.0f)), 3u);
  a[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(lessBits(Pack::load(a.data()), Pack(2.0f)), 1u);
}

TEST(SimdPackTest, IntegersWrapConvertAndReduce) {
  const IntPack top(std::numeric_limits<std::int32_t>::max());
  EXPECT_EQ(lowest(top + IntPack(1)), std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(lowest(IntPack::iota() - IntPack(2)), -2);
  EXPECT_EQ(highest(IntPack::iota()), kLanes - 1);
  EXPECT_EQ(lanesOf(toFloat(IntPack::iota()))[kLanes - 1], static_cast<float>(kLanes - 1));
}

}  // namespace
}  // namespace spin::isa_test
