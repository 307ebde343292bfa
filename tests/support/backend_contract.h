// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/base/host_device.h"
#include "core/base/random.h"

/// What every backend must do, one text for all: instantiate BackendContract with a struct that has
/// `using Backend`, `static Backend make()` and `static bool available(std::string& why)`.
namespace spin::contract {

/// Sizes round the chunk and block sizes, empty and single ones too.
inline const std::vector<std::size_t>& sizes() {
  static const std::vector<std::size_t> list = {0, 1, 2, 127, 128, 1023, 1024, 1025, 4099, 65537, 200003};
  return list;
}

inline std::vector<std::uint32_t> randomValues(std::size_t n, std::uint32_t below, std::uint32_t stream) {
  const CounterRandom random{7, stream};
  std::vector<std::uint32_t> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = random.words(i).x % below;
  return values;
}

struct SquareKernel {
  const std::uint32_t* in;
  std::uint32_t* out;
  SPIN_HD void operator()(std::size_t i) const { out[i] = in[i] * in[i] + 1u; }
};

struct ReadFloat {
  const float* in;
  SPIN_HD float operator()(std::size_t i) const { return in[i]; }
};
struct AddFloat {
  SPIN_HD float operator()(float a, float b) const { return a + b; }
};
struct ReadWord {
  const std::uint32_t* in;
  SPIN_HD std::uint32_t operator()(std::size_t i) const { return in[i]; }
};
struct LargerWord {
  SPIN_HD std::uint32_t operator()(std::uint32_t a, std::uint32_t b) const { return a < b ? b : a; }
};

template <class Traits>
class BackendContract : public ::testing::Test {
 protected:
  using Words = typename Traits::Backend::template Array<std::uint32_t>;
  using Floats = typename Traits::Backend::template Array<float>;
  void SetUp() override {
    std::string why;
    if (!Traits::available(why)) GTEST_SKIP() << why;
  }
};
TYPED_TEST_SUITE_P(BackendContract);

TYPED_TEST_P(BackendContract, ForEachVisitsEveryIndexOnce) {
  auto backend = TypeParam::make();
  for (const std::size_t n : sizes()) {
    const auto in = randomValues(n, 60000, 1);
    typename TestFixture::Words a, b;
    backend.upload(in, a);
    backend.upload(std::vector<std::uint32_t>(n, 0), b);
    backend.forEach("square", n, SquareKernel{a.data(), b.data()});
    std::vector<std::uint32_t> out;
    backend.download(b, out);
    ASSERT_EQ(out.size(), n);
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(out[i], in[i] * in[i] + 1u) << "index " << i << " of " << n;
  }
  EXPECT_GT(backend.timings().seconds("square"), 0.0);
}

TYPED_TEST_P(BackendContract, ReduceFindsTheLargest) {
  auto backend = TypeParam::make();
  for (const std::size_t n : sizes()) {
    const auto in = randomValues(n, UINT32_MAX, 2);
    typename TestFixture::Words a;
    backend.upload(in, a);
    const std::uint32_t expected = n == 0 ? 0 : *std::max_element(in.begin(), in.end());
    EXPECT_EQ(backend.reduce("largest", n, std::uint32_t{0}, ReadWord{a.data()}, LargerWord{}), expected)
        << n;
  }
}

TYPED_TEST_P(BackendContract, ReduceOfFloatsRepeatsBitForBit) {
  auto backend = TypeParam::make();
  const std::size_t n = 200003;
  std::vector<float> in(n);
  const CounterRandom random{7, 3};
  for (std::size_t i = 0; i < n; ++i) in[i] = random.uniform(i) * (i % 3 == 0 ? 1e6f : 1e-3f);
  typename TestFixture::Floats a;
  backend.upload(in, a);
  const float first = backend.reduce("sum", n, 0.0f, ReadFloat{a.data()}, AddFloat{});
  const double exact = std::accumulate(in.begin(), in.end(), 0.0);
  EXPECT_NEAR(first, exact, 1e-4 * exact);
  for (int k = 0; k < 5; ++k)
    EXPECT_EQ(backend.reduce("sum", n, 0.0f, ReadFloat{a.data()}, AddFloat{}), first);
}

TYPED_TEST_P(BackendContract, ScanSumsWhatCameBefore) {
  auto backend = TypeParam::make();
  for (const std::size_t n : sizes()) {
    const auto in = randomValues(n, 1000, 4);
    typename TestFixture::Words a, b;
    backend.upload(in, a);
    backend.upload(in, b);
    const std::uint64_t total = backend.exclusiveScan("scan", a.data(), b.data(), n);
    std::vector<std::uint32_t> out, expected(n);
    backend.download(b, out);
    std::exclusive_scan(in.begin(), in.end(), expected.begin(), 0u);
    EXPECT_EQ(out, expected) << n;
    EXPECT_EQ(total, std::accumulate(in.begin(), in.end(), std::uint64_t{0})) << n;
  }
}

TYPED_TEST_P(BackendContract, ScanTotalDoesNotOverflow) {
  auto backend = TypeParam::make();
  const std::vector<std::uint32_t> in(100000, 1000000);
  typename TestFixture::Words a, b;
  backend.upload(in, a);
  backend.upload(in, b);
  EXPECT_EQ(backend.exclusiveScan("scan", a.data(), b.data(), in.size()), 100000000000ull);
}

TYPED_TEST_P(BackendContract, SortIsStable) {
  auto backend = TypeParam::make();
  for (const std::size_t n : sizes()) {
    for (const std::uint32_t keyCount : {1u, 2u, 100u, 2048u, 2049u, 5000000u, UINT32_MAX}) {
      const auto keys = randomValues(n, keyCount, 5);
      typename TestFixture::Words a, order;
      backend.upload(keys, a);
      backend.sortByKey("sort", a, keyCount, order);
      std::vector<std::uint32_t> got, expected(n), unchanged;
      backend.download(order, got);
      backend.download(a, unchanged);
      std::iota(expected.begin(), expected.end(), 0u);
      std::stable_sort(expected.begin(), expected.end(),
                       [&](std::uint32_t i, std::uint32_t j) { return keys[i] < keys[j]; });
      EXPECT_EQ(got, expected) << n << " keys below " << keyCount;
      EXPECT_EQ(unchanged, keys);
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(BackendContract, ForEachVisitsEveryIndexOnce, ReduceFindsTheLargest,
                            ReduceOfFloatsRepeatsBitForBit, ScanSumsWhatCameBefore, ScanTotalDoesNotOverflow,
                            SortIsStable);

}  // namespace spin::contract
