// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/fork_join.h"
#include "core/base/timings.h"

/// The CPU backend. A backend offers arrays, forEach, reduce, scan and a stable sort by key; solvers are
/// written once over this concept and instantiated per backend (gpu/ has the CUDA one).
///
/// Determinism: work is cut into chunks of a fixed size that does not depend on the thread count, each chunk
/// is done by one thread in index order, and partial results are combined in chunk order. So 1, 2 and 64
/// threads give the same bits.
namespace spin {

class CpuBackend {
 public:
  template <class T>
  using Array = std::vector<T>;

  static constexpr std::size_t kChunk = 1024;
  static constexpr const char* kDevice = "cpu";

  /// threads <= 0 takes all the machine has; more than it has are really started.
  explicit CpuBackend(int threads = 0);

  /// One that works with the same threads and books its own times.
  CpuBackend sharingThreads() const {
    CpuBackend other(*this);
    other.m_timings.clear();
    return other;
  }

  int threads() const { return m_threads; }
  oneapi::tbb::task_arena& arena() { return *m_arena; }
  StageTimings& timings() { return m_timings; }
  const StageTimings& timings() const { return m_timings; }

  /// From and to host memory; the target takes the size of the source.
  template <class T>
  void upload(const std::vector<T>& from, Array<T>& to) {
    to = from;
  }
  template <class T>
  void download(const Array<T>& from, std::vector<T>& to) {
    to = from;
  }
  /// Memory that the backend keeps for its own use, bytes.
  std::size_t scratchBytes() const { return m_scratch.capacity() * sizeof(std::uint32_t); }

  /// Calls kernel(i) for i in [0, n), in parallel, and books the time under name.
  template <class Kernel>
  void forEach(const char* name, std::size_t n, const Kernel& kernel, std::size_t chunk = kChunk) {
    forChunks(name, n, chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      // A copy that no store can reach, so that its pointers stay in registers.
      const Kernel own = kernel;
      for (std::size_t i = begin; i < end; ++i) own(i);
    });
  }

  /// Calls body(begin, end, chunkIndex) for every chunk of [0, n).
  template <class Body>
  void forChunks(const char* name, std::size_t n, std::size_t chunk, const Body& body) {
    ScopedStage stage(m_timings, name);
    const std::size_t chunks = (n + chunk - 1) / chunk;
    if (chunks == 0) return;
    const auto run = [&](std::size_t c) { body(c * chunk, std::min(n, (c + 1) * chunk), c); };
    if (m_threads == 1 || chunks == 1) {
      for (std::size_t c = 0; c < chunks; ++c) run(c);
      return;
    }
    ForkJoin order;
    order.fork();
    m_arena->execute([&] {
      oneapi::tbb::parallel_for(
          oneapi::tbb::blocked_range<std::size_t>(0, chunks, 1),
          [&](const oneapi::tbb::blocked_range<std::size_t>& range) SPIN_BEFORE_FORK {
            order.enter();
            for (std::size_t c = range.begin(); c != range.end(); ++c) run(c);
            order.leave();
          },
          oneapi::tbb::simple_partitioner());
    });
    order.join();
  }

  /// combine(... combine(combine(initial, map(0)), map(1)) ...) in a fixed order: per chunk, then over
  /// chunks. `initial` must be neutral for `combine`.
  template <class T, class Map, class Combine>
  T reduce(const char* name, std::size_t n, T initial, const Map& map, const Combine& combine) {
    std::vector<T> partial((n + kChunk - 1) / kChunk, initial);
    forChunks(name, n, kChunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      T value = initial;
      for (std::size_t i = begin; i < end; ++i) value = combine(value, map(i));
      partial[c] = value;
    });
    T total = initial;
    for (const T& value : partial) total = combine(total, value);
    return total;
  }

  /// out[i] = sum of in[0..i), returns the sum of all. `in` and `out` may be the same array.
  std::uint64_t exclusiveScan(const char* name, const std::uint32_t* in, std::uint32_t* out, std::size_t n);

  /// Writes to order the permutation that sorts keys ascending, equal keys in their old order (stable).
  /// keys < keyCount. keys are left unchanged; order is resized to n.
  void sortByKey(const char* name, const Array<std::uint32_t>& keys, std::uint32_t keyCount,
                 Array<std::uint32_t>& order);

 private:
  int m_threads;
  std::shared_ptr<oneapi::tbb::task_arena> m_arena;
  StageTimings m_timings;
  std::vector<std::uint32_t> m_scratch;  // second copy of the order while sorting
};

}  // namespace spin
