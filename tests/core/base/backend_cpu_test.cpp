// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "core/base/parallel.h"
#include "tests/support/backend_contract.h"

namespace spin {
namespace {

template <int kThreads>
struct CpuTraits {
  using Backend = CpuBackend;
  static Backend make() { return CpuBackend(kThreads); }
  static bool available(std::string&) { return true; }
};

}  // namespace

using CpuTypes = ::testing::Types<CpuTraits<1>, CpuTraits<2>, CpuTraits<4>>;
namespace contract {
INSTANTIATE_TYPED_TEST_SUITE_P(Cpu, BackendContract, CpuTypes);
}

namespace {

TEST(CpuBackendTest, SumsOfFloatsDoNotDependOnTheThreadCount) {
  const CounterRandom random{11, 0};
  const auto value = [&](std::size_t i) { return random.uniform(i) * (i % 3 == 0 ? 1e6f : 1e-3f); };
  const auto add = [](float a, float b) { return a + b; };
  CpuBackend one(1), two(2), four(4);
  for (const std::size_t n : {std::size_t{1}, std::size_t{1025}, std::size_t{100003}}) {
    const float sum = one.reduce("sum", n, 0.0f, value, add);
    EXPECT_EQ(two.reduce("sum", n, 0.0f, value, add), sum);
    EXPECT_EQ(four.reduce("sum", n, 0.0f, value, add), sum);
  }
}

TEST(CpuBackendTest, StartsAsManyThreadsAsAskedAlsoWhereTheMachineHasFewer) {
  // Four chunks that wait for each other end only if four threads run at once.
  CpuBackend backend(4);
  EXPECT_EQ(backend.threads(), 4);
  std::mutex mutex;
  std::condition_variable changed;
  std::set<std::thread::id> threads;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  backend.forChunks("meet", 4, 1, [&](std::size_t, std::size_t, std::size_t) {
    std::unique_lock lock(mutex);
    threads.insert(std::this_thread::get_id());
    changed.notify_all();
    changed.wait_until(lock, limit, [&] { return threads.size() == 4; });
  });
  EXPECT_EQ(threads.size(), 4u);
}

TEST(CpuBackendTest, ChunksCoverTheRangeWithoutOverlap) {
  CpuBackend backend(2);
  std::vector<std::atomic<int>> hits(1001);
  backend.forChunks("cover", hits.size(), 10, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    EXPECT_EQ(begin, chunk * 10);
    for (std::size_t i = begin; i < end; ++i) ++hits[i];
  });
  for (const auto& hit : hits) EXPECT_EQ(hit.load(), 1);
}

TEST(CpuBackendTest, ZeroThreadsMeansAll) {
  EXPECT_GE(CpuBackend(0).threads(), 1);
  EXPECT_EQ(CpuBackend(3).threads(), 3);
}

}  // namespace
}  // namespace spin
