// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/thread_priority.h"

#include <oneapi/tbb/task_scheduler_observer.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace spin {

void lowerThreadPriority(int niceness) {
  // On Linux the niceness belongs to the thread, not to the process.
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  ::setpriority(PRIO_PROCESS, thread, niceness);
}

class LowPriorityArena::Observer : public oneapi::tbb::task_scheduler_observer {
 public:
  explicit Observer(oneapi::tbb::task_arena& arena) : task_scheduler_observer(arena) { observe(true); }
  ~Observer() override { observe(false); }
  void on_scheduler_entry(bool isWorker) override {
    if (isWorker) lowerThreadPriority();
  }
};

LowPriorityArena::LowPriorityArena(oneapi::tbb::task_arena& arena)
    : m_observer(std::make_unique<Observer>(arena)) {}

LowPriorityArena::~LowPriorityArena() = default;

}  // namespace spin
