// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/property/property_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/property/text_check.h"

namespace spin {
namespace {

/// Longest text a property takes; a caption or a path is far shorter.
constexpr std::size_t kMaxTextBytes = 4096;
/// An outline drawn by hand has a few dozen corners, one from a map a few thousand.
constexpr std::size_t kMaxPoints = 10'000;

bool hasRange(const PropertyInfo& property) {
  return property.min < property.max;
}

const char* kindName(PropertyKind kind) {
  switch (kind) {
    case PropertyKind::Bool:
      return "true or false";
    case PropertyKind::Int:
      return "a whole number";
    case PropertyKind::Real:
      return "a number";
    case PropertyKind::Vector:
      return "three numbers";
    case PropertyKind::Colour:
      return "three numbers (linear red, green, blue)";
    case PropertyKind::Choice:
      return "one of the listed words";
    case PropertyKind::Points:
      return "points, each of two numbers, parted by ';'";
    case PropertyKind::Text:
      return "a text";
    case PropertyKind::Path:
      return "a path";
  }
  return "a value";
}

bool rightAlternative(PropertyKind kind, const Value& value) {
  switch (kind) {
    case PropertyKind::Bool:
      return std::holds_alternative<bool>(value);
    case PropertyKind::Int:
    case PropertyKind::Choice:
      return std::holds_alternative<std::int64_t>(value);
    case PropertyKind::Real:
      return std::holds_alternative<double>(value);
    case PropertyKind::Vector:
    case PropertyKind::Colour:
      return std::holds_alternative<Vec3d>(value);
    case PropertyKind::Points:
      return std::holds_alternative<PlanPoints>(value);
    case PropertyKind::Text:
    case PropertyKind::Path:
      return std::holds_alternative<std::string>(value);
  }
  return false;
}

std::string rangeText(const PropertyInfo& property) {
  std::string text = fmt::format("{} to {}", property.min, property.max);
  const UnitInfo unit = unitInfo(property.unit);
  if (unit.scale != 1.0 || unit.offset != 0.0)
    text += fmt::format(" (shown as {:.6g} to {:.6g} {})", toDisplay(property.unit, property.min),
                        toDisplay(property.unit, property.max), unit.suffix);
  return text;
}

std::string choiceList(const PropertyInfo& property) {
  std::string list;
  for (const Choice& choice : property.choices) list += (list.empty() ? "" : ", ") + std::string(choice.id);
  return list;
}

Error refused(const PropertyInfo& property, std::string_view shown, std::string why, std::string advice) {
  constexpr std::size_t kShown = 80;
  const std::string text(shown.substr(0, kShown));
  return badInput(fmt::format("\"{}\" is not a value of {}", printable(text), property.id), property.id,
                  std::move(why), std::move(advice));
}

Status checkNumber(const PropertyInfo& property, double number, const Value& value) {
  if (!std::isfinite(number)) return refused(property, toText(value), "the number is not finite", {});
  if (hasRange(property) && !(number >= property.min && number <= property.max))
    return refused(property, toText(value), fmt::format("allowed is {}", rangeText(property)), {});
  return {};
}

Status checkText(const PropertyInfo& property, const std::string& text) {
  if (text.size() > kMaxTextBytes)
    return refused(property, text, fmt::format("the text is longer than {} bytes", kMaxTextBytes), {});
  if (!isCleanText(text))
    return refused(property, text, "the text is not UTF-8 or has control characters", {});
  return {};
}

Status checkPoints(const PropertyInfo& property, const Value& value) {
  const PlanPoints& points = std::get<PlanPoints>(value);
  if (points.size() > kMaxPoints)
    return refused(property, toText(value), fmt::format("there are more than {} points", kMaxPoints), {});
  for (const Vec2d& point : points)
    for (const double number : {point.x, point.y})
      if (Status status = checkNumber(property, number, value); !status) return status;
  return {};
}

Result<Value> readChoice(const PropertyInfo& property, std::string_view word) {
  std::vector<std::string_view> ids;
  for (const Choice& choice : property.choices) ids.push_back(choice.id);
  const auto found = std::find(ids.begin(), ids.end(), word);
  if (found != ids.end()) return Value(static_cast<std::int64_t>(found - ids.begin()));
  const std::string_view near = nearestName(word, ids);
  return refused(property, word, "allowed is one of " + choiceList(property),
                 near.empty() ? std::string() : fmt::format("Did you mean \"{}\"?", near));
}

/// The text as a value of the property's kind, range unchecked.
Result<Value> readValue(const PropertyInfo& property, std::string_view text) {
  double real = 0.0;
  std::int64_t integer = 0;
  Vec3d vector;
  switch (property.kind) {
    case PropertyKind::Bool:
      if (text == "true" || text == "false") return Value(text == "true");
      break;
    case PropertyKind::Choice:
      return readChoice(property, text);
    case PropertyKind::Int:
      if (parseInteger(text, integer)) return Value(integer);
      break;
    case PropertyKind::Real:
      if (parseReal(text, real)) return Value(real);
      break;
    case PropertyKind::Vector:
    case PropertyKind::Colour:
      if (parseVector(text, vector)) return Value(vector);
      break;
    case PropertyKind::Points: {
      PlanPoints points;
      if (parsePoints(text, points)) return Value(std::move(points));
      break;
    }
    case PropertyKind::Text:
    case PropertyKind::Path:
      return Value(std::string(text));
  }
  return refused(property, text, fmt::format("expected is {}", kindName(property.kind)), {});
}

}  // namespace

const PropertyInfo* NodeType::find(std::string_view propertyId) const {
  for (const PropertyRow& row : properties)
    if (propertyId == row.id) return &row;
  return nullptr;
}

Value defaultValue(const NodeType& type, const PropertyInfo& property) {
  return property.get(*type.create());
}

Status validate(const PropertyInfo& property, const Value& value) {
  if (!rightAlternative(property.kind, value))
    return refused(property, toText(value), fmt::format("expected is {}", kindName(property.kind)), {});
  switch (property.kind) {
    case PropertyKind::Bool:
      return {};
    case PropertyKind::Choice: {
      const std::int64_t index = std::get<std::int64_t>(value);
      if (index < 0 || index >= static_cast<std::int64_t>(property.choices.size()))
        return refused(property, toText(value), "allowed is one of " + choiceList(property), {});
      return {};
    }
    case PropertyKind::Int:
      return checkNumber(property, static_cast<double>(std::get<std::int64_t>(value)), value);
    case PropertyKind::Real:
      return checkNumber(property, std::get<double>(value), value);
    case PropertyKind::Vector:
    case PropertyKind::Colour: {
      const Vec3d& vector = std::get<Vec3d>(value);
      for (int axis = 0; axis < 3; ++axis)
        if (Status status = checkNumber(property, vector[axis], value); !status) return status;
      return {};
    }
    case PropertyKind::Points:
      return checkPoints(property, value);
    case PropertyKind::Text:
    case PropertyKind::Path:
      return checkText(property, std::get<std::string>(value));
  }
  return {};
}

std::string toText(const PropertyInfo& property, const Value& value) {
  if (property.kind == PropertyKind::Choice) {
    const auto index = static_cast<std::size_t>(std::get<std::int64_t>(value));
    if (index < property.choices.size()) return property.choices[index].id;
  }
  return toText(value);
}

Result<Value> parseValue(const PropertyInfo& property, std::string_view text) {
  const std::string_view word = trimmed(text);
  Result<Value> read = readValue(property, property.kind >= PropertyKind::Text ? text : word);
  if (!read) return read;
  if (Status status = validate(property, *read); !status) return status.error();
  return read;
}

}  // namespace spin
