// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "core/base/check.h"
#include "core/bench/bench_case.h"

namespace spin {
namespace {

/// Metrics are members of a JSON object: a name may come once.
void append(BenchRow& row, const std::string& name, BenchMetric metric) {
  SPIN_CHECK(
      std::none_of(row.metrics.begin(), row.metrics.end(), [&](const auto& m) { return m.first == name; }),
      row.caseId + " has two metrics named " + name);
  row.metrics.emplace_back(name, std::move(metric));
}

}  // namespace

void BenchRow::addError(const std::string& name, double value, const std::string& unit, double bar) {
  // Written so that a NaN fails.
  append(*this, name, BenchMetric{value, unit, true, bar, value <= bar, false});
}

void BenchRow::addFigure(const std::string& name, double value, const std::string& unit) {
  append(*this, name, BenchMetric{value, unit, false, 0.0, true, false});
}

void BenchRow::addTime(const std::string& name, double value, const std::string& unit) {
  append(*this, name, BenchMetric{value, unit, false, 0.0, true, true});
}

void BenchRow::addRate(const std::string& name, double value, const std::string& unit, double bar) {
  append(*this, name, BenchMetric{value, unit, true, bar, value >= bar, true});
}

bool BenchRow::pass() const {
  return std::all_of(metrics.begin(), metrics.end(),
                     [](const auto& m) { return m.second.isTime || !m.second.hasBar || m.second.pass; });
}

}  // namespace spin
