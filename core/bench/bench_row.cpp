// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/bench/bench_case.h"

namespace spin {

void BenchRow::addError(const std::string& name, double value, const std::string& unit, double bar) {
  // Written so that a NaN fails.
  metrics.emplace_back(name, BenchMetric{value, unit, true, bar, value <= bar, false});
}

void BenchRow::addFigure(const std::string& name, double value, const std::string& unit) {
  metrics.emplace_back(name, BenchMetric{value, unit, false, 0.0, true, false});
}

void BenchRow::addTime(const std::string& name, double value, const std::string& unit) {
  metrics.emplace_back(name, BenchMetric{value, unit, false, 0.0, true, true});
}

void BenchRow::addRate(const std::string& name, double value, const std::string& unit, double bar) {
  metrics.emplace_back(name, BenchMetric{value, unit, true, bar, value >= bar, true});
}

bool BenchRow::pass() const {
  return std::all_of(metrics.begin(), metrics.end(),
                     [](const auto& m) { return m.second.isTime || !m.second.hasBar || m.second.pass; });
}

}  // namespace spin
