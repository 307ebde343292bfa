// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/value_json.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "core/property/text_check.h"

namespace spin {
namespace {

using Kind = JsonValue::Kind;

constexpr std::array<const char*, 3> kInterpolations{"step", "linear", "smooth"};
/// Keys of one property; a key on every frame of a long film is far fewer.
constexpr std::size_t kMaxKeys = 100'000;
/// Integers up to here are exact in a JSON number.
constexpr double kExactInteger = 9007199254740992.0;

Error wrongKind(const PropertyInfo& property, const JsonValue& json, const std::string& where,
                const char* expected) {
  return badInput(fmt::format("The value of {} is unusable", property.id), placeOf(where, json),
                  fmt::format("expected is {}, found {}", expected, kindText(json.kind)));
}

Result<Value> vectorFromJson(const PropertyInfo& property, const JsonValue& json, const std::string& where) {
  if (!json.is(Kind::Array) || json.items.size() != 3)
    return wrongKind(property, json, where, "an array of three numbers");
  double parts[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!json.items[i].is(Kind::Number))
      return wrongKind(property, json.items[i], where, "an array of three numbers");
    parts[i] = json.items[i].number;
  }
  return Value(Vec3d{parts[0], parts[1], parts[2]});
}

Result<Value> pointsFromJson(const PropertyInfo& property, const JsonValue& json, const std::string& where) {
  constexpr const char* kExpected = "an array of points, each an array of two numbers";
  if (!json.is(Kind::Array)) return wrongKind(property, json, where, kExpected);
  PlanPoints points;
  for (const JsonValue& item : json.items) {
    if (!item.is(Kind::Array) || item.items.size() != 2 || !item.items[0].is(Kind::Number) ||
        !item.items[1].is(Kind::Number))
      return wrongKind(property, item, where, kExpected);
    points.push_back({item.items[0].number, item.items[1].number});
  }
  return Value(std::move(points));
}

/// The right alternative, range unchecked; choices are complete.
Result<Value> rawValue(const PropertyInfo& property, const JsonValue& json, const std::string& where) {
  switch (property.kind) {
    case PropertyKind::Bool:
      if (!json.is(Kind::Bool)) return wrongKind(property, json, where, "true or false");
      return Value(json.boolean);
    case PropertyKind::Int:
      if (!json.is(Kind::Number) || json.number != std::floor(json.number) ||
          std::abs(json.number) > kExactInteger)
        return wrongKind(property, json, where, "a whole number");
      return Value(static_cast<std::int64_t>(json.number));
    case PropertyKind::Real:
      if (!json.is(Kind::Number)) return wrongKind(property, json, where, "a number");
      return Value(json.number);
    case PropertyKind::Vector:
    case PropertyKind::Colour:
      return vectorFromJson(property, json, where);
    case PropertyKind::Choice:
      if (!json.is(Kind::Text)) return wrongKind(property, json, where, "one of the listed words");
      return parseValue(property, json.text);
    case PropertyKind::Points:
      return pointsFromJson(property, json, where);
    case PropertyKind::Text:
    case PropertyKind::Path:
      if (!json.is(Kind::Text)) return wrongKind(property, json, where, "a text");
      return Value(json.text);
  }
  return wrongKind(property, json, where, "a value");
}

Result<Interpolation> interpolationFromJson(const JsonValue* json, const std::string& where) {
  if (!json) return Interpolation::Linear;
  for (std::size_t i = 0; i < kInterpolations.size(); ++i)
    if (json->is(Kind::Text) && json->text == kInterpolations[i]) return static_cast<Interpolation>(i);
  return badInput("The interpolation of a key is unusable", placeOf(where, *json),
                  "allowed is one of step, linear, smooth");
}

Result<Key> keyFromJson(const PropertyInfo& property, const JsonValue& json, const std::string& where) {
  const auto bad = [&](const std::string& why) {
    return badInput(fmt::format("A key of {} is unusable", property.id), placeOf(where, json), why);
  };
  if (!json.is(Kind::Object)) return bad(fmt::format("expected is an object, found {}", kindText(json.kind)));
  for (const JsonValue::Member& member : json.members)
    if (member.key != "interpolation" && member.key != "time_s" && member.key != "value")
      return bad(fmt::format("\"{}\" is unknown, allowed are interpolation, time_s and value",
                             printable(member.key)));
  const JsonValue* time = json.find("time_s");
  const JsonValue* value = json.find("value");
  if (!time || !time->is(Kind::Number)) return bad("time_s is missing or no number");
  if (std::abs(time->number) > 1e7) return bad("time_s lies outside -1e7 to 1e7");
  if (!value) return bad("the value is missing");
  Result<Value> read = valueFromJson(property, *value, where);
  if (!read) return read.error();
  Result<Interpolation> interpolation = interpolationFromJson(json.find("interpolation"), where);
  if (!interpolation) return interpolation.error();
  return Key{time->number, std::move(*read), *interpolation};
}

}  // namespace

std::string placeOf(const std::string& where, const JsonValue& json) {
  return json.line > 0 ? fmt::format("{}, line {}", where, json.line) : where;
}

JsonValue toJson(const PropertyInfo& property, const Value& value) {
  switch (property.kind) {
    case PropertyKind::Bool:
      return JsonValue::of(std::get<bool>(value));
    case PropertyKind::Int:
      return JsonValue::of(static_cast<double>(std::get<std::int64_t>(value)));
    case PropertyKind::Real:
      return JsonValue::of(std::get<double>(value));
    case PropertyKind::Vector:
    case PropertyKind::Colour: {
      const Vec3d& v = std::get<Vec3d>(value);
      return JsonValue::array({JsonValue::of(v.x), JsonValue::of(v.y), JsonValue::of(v.z)});
    }
    case PropertyKind::Choice:
      return JsonValue::of(toText(property, value));
    case PropertyKind::Points: {
      JsonValue points = JsonValue::array();
      for (const Vec2d& p : std::get<PlanPoints>(value))
        points.items.push_back(JsonValue::array({JsonValue::of(p.x), JsonValue::of(p.y)}));
      return points;
    }
    case PropertyKind::Text:
    case PropertyKind::Path:
      return JsonValue::of(std::get<std::string>(value));
  }
  SPIN_CHECK(false, "kind of property without a JSON form");
}

Result<Value> valueFromJson(const PropertyInfo& property, const JsonValue& json, const std::string& where) {
  Result<Value> value = rawValue(property, json, where);
  const Status status = value ? validate(property, *value) : Status(value.error());
  if (status) return value;
  Error error = status.error();
  if (error.where == property.id) error.where = placeOf(where, json);
  return error;
}

JsonValue toJson(const PropertyInfo& property, const AnimationCurve& curve) {
  JsonValue keys = JsonValue::array();
  for (const Key& key : curve.keys()) {
    JsonValue json = JsonValue::object();
    json.set("interpolation", JsonValue::of(kInterpolations[static_cast<std::size_t>(key.interpolation)]));
    json.set("time_s", JsonValue::of(key.time));
    json.set("value", toJson(property, key.value));
    keys.items.push_back(std::move(json));
  }
  return keys;
}

Result<AnimationCurve> curveFromJson(const PropertyInfo& property, const JsonValue& keys,
                                     const std::string& where) {
  const auto bad = [&](const std::string& why) {
    return badInput(fmt::format("The keys of {} are unusable", property.id), placeOf(where, keys), why);
  };
  if (!property.animatable) return bad("this property cannot be animated");
  if (!keys.is(Kind::Array) || keys.items.empty()) return bad("expected is an array with at least one key");
  if (keys.items.size() > kMaxKeys) return bad(fmt::format("more than {} keys", kMaxKeys));
  AnimationCurve curve;
  for (const JsonValue& json : keys.items) {
    Result<Key> key = keyFromJson(property, json, where);
    if (!key) return key.error();
    const double time = key->time;
    const bool late = curve.empty() || time > curve.keys().back().time;
    const std::size_t before = curve.keys().size();
    if (late) curve.setKey(std::move(*key));
    if (curve.keys().size() == before)
      return bad(fmt::format("the key at {} s does not come after the one before it", time));
  }
  return curve;
}

}  // namespace spin
