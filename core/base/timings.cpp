// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/timings.h"

#include <algorithm>

namespace spin {

StageTimings::StageTimings(const StageTimings& other) : m_stages(other.table()) {}

StageTimings& StageTimings::operator=(const StageTimings& other) {
  if (this == &other) return *this;
  std::vector<StageTime> copy = other.table();
  std::lock_guard lock(m_mutex);
  m_stages = std::move(copy);
  return *this;
}

void StageTimings::add(std::string_view name, double seconds) {
  std::lock_guard lock(m_mutex);
  auto it =
      std::find_if(m_stages.begin(), m_stages.end(), [&](const StageTime& s) { return s.name == name; });
  if (it == m_stages.end()) it = m_stages.insert(it, StageTime{std::string(name), 0, 0.0});
  ++it->calls;
  it->seconds += seconds;
}

void StageTimings::merge(const StageTimings& other) {
  for (const StageTime& stage : other.table()) {
    add(stage.name, stage.seconds);
    std::lock_guard lock(m_mutex);
    for (StageTime& mine : m_stages)
      if (mine.name == stage.name) mine.calls += stage.calls - 1;
  }
}

void StageTimings::clear() {
  std::lock_guard lock(m_mutex);
  m_stages.clear();
}

std::vector<StageTime> StageTimings::table() const {
  std::lock_guard lock(m_mutex);
  return m_stages;
}

double StageTimings::seconds(std::string_view name) const {
  std::lock_guard lock(m_mutex);
  for (const StageTime& stage : m_stages)
    if (stage.name == name) return stage.seconds;
  return 0.0;
}

}  // namespace spin
