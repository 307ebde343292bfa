// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <oneapi/tbb/task_arena.h>

#include <memory>

namespace spin {

/// How much a thread gives way to others: pictures come before the simulation, the window before both.
inline constexpr int kSimulationNiceness = 10;
inline constexpr int kDrawingNiceness = 5;

/// Makes the calling thread, and the threads it starts from now on, give way to others.
void lowerThreadPriority(int niceness = kSimulationNiceness);

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
