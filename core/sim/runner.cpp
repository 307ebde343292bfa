// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/runner.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "core/sim/thread_priority.h"

namespace spin {
namespace {

struct Job {
  SnapshotPointer scene;
  std::shared_ptr<FrameStore> store;
  RunOptions options;
  RunCallbacks callbacks;
  std::function<void(const Status&)> finished;
  CancelToken cancel;

  void finish(const Status& status) const {
    if (finished) finished(status);
  }
  void finishUnstarted() const {
    finish(Error{ErrorKind::Cancelled, "The simulation was cancelled", "", "a newer run took its place", ""});
  }
};

}  // namespace

class Runner::State {
 public:
  State() : m_thread([this] { loop(); }) {}
  ~State() {
    {
      std::lock_guard lock(m_mutex);
      m_quit = true;
      m_current.cancel();
    }
    m_wake.notify_all();
    m_thread.join();
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void start(Job job) {
    std::optional<Job> replaced;
    {
      std::lock_guard lock(m_mutex);
      m_current.cancel();
      replaced = std::exchange(m_next, std::move(job));
    }
    m_wake.notify_all();
    if (replaced) replaced->finishUnstarted();
  }
  void cancel() {
    std::optional<Job> dropped;
    {
      std::lock_guard lock(m_mutex);
      m_current.cancel();
      dropped = std::exchange(m_next, std::nullopt);
    }
    m_wake.notify_all();
    if (dropped) dropped->finishUnstarted();
  }
  bool running() const {
    std::lock_guard lock(m_mutex);
    return m_busy || m_next;
  }
  void wait() {
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return !m_busy && !m_next; });
  }

 private:
  void loop() {
    lowerThreadPriority();
    std::unique_lock lock(m_mutex);
    for (;;) {
      m_wake.wait(lock, [this] { return m_quit || m_next; });
      if (m_quit) break;
      const Job job = *std::exchange(m_next, std::nullopt);
      m_current = job.cancel;
      m_busy = true;
      lock.unlock();
      job.finish(runSimulation(*job.scene, *job.store, job.options, job.callbacks, job.cancel));
      lock.lock();
      m_busy = false;
      m_wake.notify_all();
    }
    const std::optional<Job> dropped = std::exchange(m_next, std::nullopt);
    lock.unlock();
    if (dropped) dropped->finishUnstarted();
  }

  mutable std::mutex m_mutex;
  std::condition_variable m_wake;
  std::optional<Job> m_next;
  CancelToken m_current;
  bool m_busy = false;
  bool m_quit = false;
  std::thread m_thread;  ///< last: it uses all of the above
};

Runner::Runner() : m_state(std::make_unique<State>()) {}

Runner::~Runner() = default;

void Runner::start(SnapshotPointer scene, std::shared_ptr<FrameStore> store, RunOptions options,
                   RunCallbacks callbacks, std::function<void(const Status&)> finished) {
  options.lowPriority = true;
  m_state->start({std::move(scene), std::move(store), std::move(options), std::move(callbacks),
                  std::move(finished), CancelToken()});
}

void Runner::cancel() {
  m_state->cancel();
}

bool Runner::running() const {
  return m_state->running();
}

void Runner::wait() {
  m_state->wait();
}

}  // namespace spin
