// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <memory>

namespace spin {

/// Makes the calling thread give way to others (nice 10).
void lowerThreadPriority();

/// While it lives, the worker threads that enter the arena give way to others; they keep that priority.
class LowPriorityArena {
 public:
  explicit LowPriorityArena(oneapi::tbb::task_arena& arena);
  ~LowPriorityArena();

 private:
  class Observer;
  std::unique_ptr<Observer> m_observer;
};

}  // namespace spin
