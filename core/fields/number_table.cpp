// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace spin {
namespace {

constexpr std::string_view kSpace = " \t\r\v\f";
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// Fields between separators, empty ones kept, or between white space where there is no separator.
void splitFields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const char separator = line.find(';') != std::string_view::npos ? ';' : ',';
  if (line.find(separator) != std::string_view::npos) {
    for (std::size_t from = 0;;) {
      const std::size_t to = line.find(separator, from);
      fields.push_back(trimmed(line.substr(from, to == std::string_view::npos ? to : to - from)));
      if (to == std::string_view::npos) return;
      from = to + 1;
    }
  }
  for (std::size_t from = line.find_first_not_of(kSpace); from != std::string_view::npos;) {
    const std::size_t to = std::min(line.find_first_of(kSpace, from), line.size());
    fields.push_back(line.substr(from, to - from));
    from = line.find_first_not_of(kSpace, to);
  }
}

bool saysMissing(std::string_view field) {
  std::string lower(field.substr(0, 8));
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return lower.empty() || lower == "nan" || lower == "na" || lower == "null" || lower == "-";
}

/// False where the field is neither a finite number nor says that it is missing.
bool readField(std::string_view field, double& value) {
  value = kMissing;
  if (saysMissing(field)) return true;
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) return false;
  if (value == -99.0 || value == -999.0 || value == -9999.0 || value == -99999.0) value = kMissing;
  return true;
}

/// The field as it can stand in a message.
std::string shown(std::string_view field) {
  std::string text(field.substr(0, 24));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return text;
}

bool namesColumns(const std::vector<std::string_view>& fields) {
  double value = 0.0;
  return std::none_of(fields.begin(), fields.end(), [&](std::string_view field) {
    return !field.empty() && readField(field, value) && !std::isnan(value);
  });
}

Error unreadable(const std::string& where, std::string why) {
  return badInput("The table could not be read", where, std::move(why),
                  "Columns are numbers between white space or commas, one row a line");
}

}  // namespace

Result<NumberTable> readNumberTable(std::string_view text, std::size_t columns, const std::string& where) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find('\0') != std::string_view::npos) return unreadable(where, "it is no text");
  NumberTable table;
  table.columns = columns;
  std::vector<std::string_view> fields;
  bool named = false;
  std::size_t number = 0;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    const std::string_view line = trimmed(text.substr(from, to - from));
    from = to + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    splitFields(line, fields);
    if (table.lines.empty() && !named && namesColumns(fields)) {
      named = true;
      continue;
    }
    if (fields.size() < columns)
      return unreadable(where, fmt::format("line {} has {} of {} columns", number, fields.size(), columns));
    for (std::size_t c = 0; c < columns; ++c) {
      double value = 0.0;
      if (!readField(fields[c], value))
        return unreadable(
            where, fmt::format("line {}, column {}: '{}' is no number", number, c + 1, shown(fields[c])));
      table.values.push_back(value);
    }
    table.lines.push_back(number);
  }
  if (table.lines.empty()) return unreadable(where, "there is no row of numbers in it");
  return table;
}

Result<std::string> readTextFile(const std::string& path) {
  constexpr std::uintmax_t kMostBytes = 256u << 20;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::is_regular_file(path, error)
                                  ? std::filesystem::file_size(path, error)
                                  : kMostBytes + 1;
  if (error || size > kMostBytes)
    return badInput("The file could not be read", path,
                    error ? error.message() : "it is no file, or larger than 256 MB");
  std::ifstream in(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in)
    return badInput("The file could not be read", path,
                    "it cannot be opened, or it changed while it was read");
  return text;
}

}  // namespace spin
