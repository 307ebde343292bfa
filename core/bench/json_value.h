// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// A parsed JSON value (RFC 8259). Members keep their order.
struct BenchJson {
  enum class Kind { Null, Bool, Number, String, List, Object };
  Kind kind = Kind::Null;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  std::vector<BenchJson> items;                            ///< List
  std::vector<std::pair<std::string, BenchJson>> members;  ///< Object

  bool isNull() const { return kind == Kind::Null; }
  /// nullptr if there is no such member.
  const BenchJson* find(std::string_view name) const;
};

/// Strict: one value, nothing after it, at most 64 levels deep, no repeated member. The error names the byte.
Result<BenchJson> parseBenchJson(std::string_view text);

/// The text with quotes, escaped.
std::string jsonQuote(std::string_view text);
/// Shortest text that reads back to the same number; "null" for NaN and infinities, which JSON lacks.
std::string jsonNumber(double value);

}  // namespace spin
