// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/parallel.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <mutex>
#include <numeric>
#include <utility>

#include "core/base/check.h"

namespace spin {

namespace {

/// Two passes of 11 bits sort the cells of most scenes; the histogram of a chunk (8 KiB) stays in the
/// first-level cache.
constexpr std::uint32_t kRadixBits = 11;
constexpr std::uint32_t kRadix = 1u << kRadixBits;
constexpr std::size_t kSortChunk = 16384;

/// oneTBB starts no more workers than the machine has processors, whatever an arena asks for, unless the
/// limit of the whole program is raised. It is never lowered again: a backend may still rely on it.
void allowThreads(int threads) {
  static std::mutex mutex;
  static int allowed = oneapi::tbb::info::default_concurrency();
  static std::unique_ptr<oneapi::tbb::global_control> control;
  const std::lock_guard lock(mutex);
  if (threads <= allowed) return;
  // The smallest of all live limits counts, so the old one goes first.
  control.reset();
  control = std::make_unique<oneapi::tbb::global_control>(
      oneapi::tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  allowed = threads;
}

}  // namespace

CpuBackend::CpuBackend(int threads)
    : m_threads(threads > 0 ? threads : oneapi::tbb::info::default_concurrency()) {
  allowThreads(m_threads);
  m_arena = std::make_shared<oneapi::tbb::task_arena>(m_threads);
}

std::uint64_t CpuBackend::exclusiveScan(const char* name, const std::uint32_t* in, std::uint32_t* out,
                                        std::size_t n) {
  constexpr std::size_t kScanChunk = 65536;
  std::vector<std::uint64_t> start((n + kScanChunk - 1) / kScanChunk + 1, 0);
  forChunks(name, n, kScanChunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    start[c + 1] = std::accumulate(in + begin, in + end, std::uint64_t{0});
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  forChunks(name, n, kScanChunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    std::uint64_t sum = start[c];
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t value = in[i];
      out[i] = static_cast<std::uint32_t>(sum);
      sum += value;
    }
  });
  return start.back();
}

void CpuBackend::sortByKey(const char* name, const Array<std::uint32_t>& keys, std::uint32_t keyCount,
                           Array<std::uint32_t>& order) {
  const std::size_t n = keys.size();
  SPIN_CHECK(n <= UINT32_MAX, "sortByKey takes at most 2^32 - 1 keys");
  order.resize(n);
  std::iota(order.begin(), order.end(), 0u);
  const std::size_t chunks = (n + kSortChunk - 1) / kSortChunk;
  if (chunks == 0) return;
  m_scratch.resize(n);
  std::vector<std::uint32_t> counts(chunks * kRadix);
  for (std::uint32_t shift = 0; shift < 32 && (keyCount - 1) >> shift != 0; shift += kRadixBits) {
    const auto digit = [&, shift](std::uint32_t item) { return (keys[item] >> shift) & (kRadix - 1); };
    forChunks(name, n, kSortChunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      std::uint32_t* count = &counts[c * kRadix];
      std::fill(count, count + kRadix, 0u);
      for (std::size_t i = begin; i < end; ++i) ++count[digit(order[i])];
    });
    // Digit-major, chunk-minor offsets: within a digit, earlier chunks come first, which keeps the sort
    // stable.
    std::uint32_t sum = 0;
    for (std::uint32_t d = 0; d < kRadix; ++d)
      for (std::size_t c = 0; c < chunks; ++c) sum += std::exchange(counts[c * kRadix + d], sum);
    forChunks(name, n, kSortChunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      std::uint32_t* offset = &counts[c * kRadix];
      for (std::size_t i = begin; i < end; ++i) m_scratch[offset[digit(order[i])]++] = order[i];
    });
    order.swap(m_scratch);
  }
}

}  // namespace spin
