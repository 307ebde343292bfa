// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/base/timings.h"
#include "gpu/cuda_error.cuh"

namespace spin {

/// Device time per named stage by pairs of events. Nothing waits while stages are queued; the times are read
/// when somebody asks for the table.
class CudaStageTimer {
 public:
  CudaStageTimer() = default;
  CudaStageTimer(CudaStageTimer&& other) noexcept
      : m_pending(std::move(other.m_pending)), m_free(std::move(other.m_free)), m_timings(other.m_timings) {}
  CudaStageTimer& operator=(CudaStageTimer&&) = delete;
  ~CudaStageTimer() {
    for (const Pending& p : m_pending) cudaEventDestroy(p.start), cudaEventDestroy(p.stop);
    for (const cudaEvent_t event : m_free) cudaEventDestroy(event);
  }

  /// Runs body between two events.
  template <class Body>
  void measure(const char* name, const Body& body) {
    if (m_pending.size() >= kMaxPending) resolve();
    const cudaEvent_t start = take(), stop = take();
    cudaRequire(cudaEventRecord(start), name);
    body();
    cudaRequire(cudaEventRecord(stop), name);
    m_pending.push_back({name, start, stop});
  }

  StageTimings& timings() {
    resolve();
    return m_timings;
  }

 private:
  static constexpr std::size_t kMaxPending = 1024;
  struct Pending {
    std::string name;
    cudaEvent_t start, stop;
  };

  cudaEvent_t take() {
    cudaEvent_t event = nullptr;
    if (m_free.empty()) {
      cudaRequire(cudaEventCreate(&event), "event");
    } else {
      event = m_free.back();
      m_free.pop_back();
    }
    return event;
  }
  void resolve() {
    for (const Pending& p : m_pending) {
      float milliseconds = 0.0f;
      cudaRequire(cudaEventSynchronize(p.stop), p.name.c_str());
      cudaRequire(cudaEventElapsedTime(&milliseconds, p.start, p.stop), p.name.c_str());
      m_timings.add(p.name, 1e-3 * static_cast<double>(milliseconds));
      m_free.push_back(p.start);
      m_free.push_back(p.stop);
    }
    m_pending.clear();
  }

  std::vector<Pending> m_pending;
  std::vector<cudaEvent_t> m_free;
  StageTimings m_timings;
};

}  // namespace spin
