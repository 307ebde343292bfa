// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/text_check.h"

#include <charconv>

namespace spin {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

template <class T>
bool parseWhole(std::string_view text, T& number) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
  return code == std::errc() && end == text.data() + text.size() && !text.empty();
}

/// Length of the well-formed UTF-8 sequence at the start of a text, 0 if there is none (RFC 3629, table in
/// section 4: no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
  };
  const auto follows = [&](std::size_t i, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return text.empty() ? 0 : 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool second = follows(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF);
    return second && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool second = follows(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF);
    return second && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

bool isControl(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return first < 0x20 || first == 0x7F;
  // U+0080 to U+009F: terminals take some of them as the start of commands.
  return first == 0xC2 && static_cast<unsigned char>(sequence[1]) < 0xA0;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

bool parseInteger(std::string_view text, std::int64_t& number) {
  return parseWhole(text, number);
}

bool parseReal(std::string_view text, double& number) {
  return parseWhole(text, number);
}

bool parseVector(std::string_view text, Vec3d& vector) {
  double* const components[] = {&vector.x, &vector.y, &vector.z};
  for (double* component : components) {
    text = trimmed(text);
    const std::size_t end = text.find_first_of(" \t,");
    if (!parseReal(text.substr(0, end), *component)) return false;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end);
    text = trimmed(text);
    if (component != &vector.z && !text.empty() && text.front() == ',') text.remove_prefix(1);
  }
  return text.empty();
}

bool parsePoints(std::string_view text, PlanPoints& points) {
  points.clear();
  if (trimmed(text).empty()) return true;
  while (true) {
    const std::size_t end = text.find(';');
    const std::string_view point = trimmed(text.substr(0, end));
    const std::size_t gap = point.find_first_of(" \t,");
    if (gap == std::string_view::npos) return false;
    std::string_view second = trimmed(point.substr(gap));
    if (!second.empty() && second.front() == ',') second = trimmed(second.substr(1));
    Vec2d read;
    if (!parseReal(point.substr(0, gap), read.x) || !parseReal(second, read.y)) return false;
    points.push_back(read);
    if (end == std::string_view::npos) return true;
    text.remove_prefix(end + 1);
  }
}

bool isCleanText(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequenceLength(text);
    if (length == 0 || isControl(text.substr(0, length))) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = sequenceLength(text);
    const bool good = length > 0 && !isControl(text.substr(0, length));
    clean += good ? text.substr(0, length) : std::string_view("?");
    text.remove_prefix(length > 0 ? length : 1);
  }
  return clean;
}

}  // namespace spin
