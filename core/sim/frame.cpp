// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/frame.h"

namespace spin {

void MassBudget::set(const std::string& name, bool source, double kilograms) {
  for (BudgetTerm& term : terms) {
    if (term.name != name) continue;
    term = {name, source, kilograms};
    return;
  }
  terms.push_back({name, source, kilograms});
}

double MassBudget::get(const std::string& name) const {
  for (const BudgetTerm& term : terms)
    if (term.name == name) return term.kilograms;
  return 0.0;
}

double MassBudget::relativeImbalance() const {
  double sources = 0.0, sinks = 0.0;
  for (const BudgetTerm& term : terms) (term.source ? sources : sinks) += term.kilograms;
  return sources == 0.0 ? 0.0 : (sources - sinks) / sources;
}

std::size_t Frame::memoryBytes() const {
  std::size_t bytes = sizeof(Frame);
  for (const auto& [name, part] : parts) bytes += name.size() + part->memoryBytes();
  return bytes;
}

}  // namespace spin
