// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>
#include <vector>

#include "core/property/property_table.h"

namespace spin {
namespace {

/// Longer words are no typing mistakes, and the distance costs the product of the lengths.
constexpr std::size_t kLongestWord = 100;

/// Insertions, deletions and replacements between two words (Levenshtein 1966), by the row-wise dynamic
/// programme of Wagner and Fischer 1974.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

/// A word that only lacks the unit's suffix ("wind_speed") counts as one mistake.
std::size_t distance(std::string_view word, std::string_view candidate) {
  const std::size_t edits = editDistance(word, candidate);
  const bool isStart = word.size() >= 4 && candidate.substr(0, word.size()) == word;
  return isStart ? std::min<std::size_t>(edits, 1) : edits;
}

}  // namespace

std::string_view nearestName(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.empty() || word.size() > kLongestWord) return {};
  std::string_view best;
  std::size_t bestDistance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (std::string_view candidate : candidates) {
    if (candidate.size() > kLongestWord) continue;
    // Two edits turn any two letters into any others: a candidate must share more than it lacks.
    const std::size_t d = distance(word, candidate);
    if (d < bestDistance && d < std::max(word.size(), candidate.size())) best = candidate, bestDistance = d;
  }
  return best;
}

}  // namespace spin
