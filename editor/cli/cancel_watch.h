// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "core/base/cancel.h"

namespace spin {

/// Watches for a cancel while the owner is in calls that cannot be interrupted, such as drawing. If such a
/// call goes on for too long after the cancel, the action given for it is run instead of waiting; it should
/// not return.
class CancelWatch {
 public:
  explicit CancelWatch(const CancelToken& cancel);
  ~CancelWatch();
  CancelWatch(const CancelWatch&) = delete;
  CancelWatch& operator=(const CancelWatch&) = delete;

  /// One such call. Leaving it waits while the action runs, so that both never touch the same data. A null
  /// watch does nothing.
  class Section {
   public:
    Section(CancelWatch* watch, std::function<void()> abandon);
    ~Section();
    Section(const Section&) = delete;
    Section& operator=(const Section&) = delete;

   private:
    CancelWatch* m_watch;
  };

 private:
  void watch();

  const CancelToken& m_cancel;
  std::mutex m_mutex;
  std::function<void()> m_abandon;
  std::atomic<bool> m_quit{false};
  std::thread m_thread;
};

}  // namespace spin
