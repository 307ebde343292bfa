// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace spin {

/// Wall time of one named stage.
struct StageTime {
  std::string name;
  std::size_t calls = 0;
  double seconds = 0.0;
};

/// Wall time per named stage, in order of first use. Thread-safe.
class StageTimings {
 public:
  StageTimings() = default;
  StageTimings(const StageTimings& other);
  StageTimings& operator=(const StageTimings& other);

  void add(std::string_view name, double seconds);
  void merge(const StageTimings& other);
  void clear();
  std::vector<StageTime> table() const;
  double seconds(std::string_view name) const;

 private:
  mutable std::mutex m_mutex;
  std::vector<StageTime> m_stages;
};

/// Adds the time of its own life to a stage.
class ScopedStage {
 public:
  ScopedStage(StageTimings& timings, std::string_view name)
      : m_timings(timings), m_name(name), m_start(std::chrono::steady_clock::now()) {}
  ~ScopedStage() {
    m_timings.add(m_name, std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count());
  }
  ScopedStage(const ScopedStage&) = delete;
  ScopedStage& operator=(const ScopedStage&) = delete;

 private:
  StageTimings& m_timings;
  std::string m_name;
  std::chrono::steady_clock::time_point m_start;
};

}  // namespace spin
