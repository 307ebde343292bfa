// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace spin {

/// A JSON value (RFC 8259) that knows its line, so that messages can name it.
struct JsonValue {
  enum class Kind { Null, Bool, Number, Text, Array, Object };
  struct Member;

  Kind kind = Kind::Null;
  bool boolean = false;
  double number = 0.0;  ///< always finite
  std::string text;
  std::vector<JsonValue> items;
  std::vector<Member> members;  ///< in file order, keys distinct
  int line = 0;                 ///< from 1; 0 = not from a file

  static JsonValue of(bool value);
  static JsonValue of(double value);
  static JsonValue of(std::string value);
  static JsonValue of(const char* value) { return of(std::string(value)); }
  static JsonValue array(std::vector<JsonValue> items = {});
  static JsonValue object();

  bool is(Kind k) const { return kind == k; }
  const JsonValue* find(std::string_view key) const;
  JsonValue* find(std::string_view key);
  /// Sets or replaces a member; makes an object of null.
  void set(const std::string& key, JsonValue value);
  /// Takes a member out; null where there is none.
  JsonValue take(std::string_view key);
};

struct JsonValue::Member {
  std::string key;
  JsonValue value;
};

/// "an object", "a number", ...
const char* kindText(JsonValue::Kind kind);

/// Limits that hold before memory is taken.
struct JsonLimits {
  int depth = 32;
  std::size_t values = 2'000'000;
};

/// Strict reader: no comments, no trailing commas, no duplicate keys, numbers finite, text well-formed UTF-8.
/// Errors name the line.
Result<JsonValue> parseJson(std::string_view text, const std::string& nameForMessages,
                            const JsonLimits& limits = {});

/// Writes with two blanks of indent and one value per line; up to four numbers of an array share one. Keys
/// are sorted, in the outermost object behind those in `headKeys`. Ends with a line end.
std::string writeJson(const JsonValue& root, std::span<const char* const> headKeys = {});

}  // namespace spin
