// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
/// For what runs in a task before ForkJoin::enter().
#define SPIN_BEFORE_FORK __attribute__((no_sanitize("thread")))
#else
#define SPIN_BEFORE_FORK
#endif

namespace spin {

/// Tells ThreadSanitizer what a parallel loop orders: all before the loop comes before every task, and every
/// task comes before all after the loop, but no task before another. The oneTBB library is not built with
/// the sanitizer, so it cannot see that by itself. Costs nothing in other builds.
class ForkJoin {
 public:
#if defined(__SANITIZE_THREAD__)
  void fork() {
    __tsan_release(&m_fork);
  }
  void enter() {
    __tsan_acquire(&m_fork);
  }
  void leave() {
    __tsan_release(&m_join);
  }
  void join() {
    __tsan_acquire(&m_join);
  }

 private:
  char m_fork = 0;
  char m_join = 0;
#else
  void fork() {}
  void enter() {}
  void leave() {}
  void join() {}
#endif
};

}  // namespace spin
