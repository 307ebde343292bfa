// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/base/result.h"
#include "core/property/text_mark.h"
#include "core/property/value.h"

namespace spin {

/// Base of all node structs: plain data, the member initialiser is the default.
struct NodeData {
  virtual ~NodeData() = default;
};

/// What a change of a property makes stale.
enum class Affects : std::uint8_t { Nothing = 0, Picture = 1, Simulation = 2, Both = 3 };

/// One entry of an enumeration: `id` in files and on the command line, `label` on screen.
struct Choice {
  const char* id;
  const char* label;
};

struct PropertyInfo {
  const char* id = "";  ///< snake_case with the unit where it helps; never changes once released
  const char* label = "";
  PropertyKind kind = PropertyKind::Real;
  Unit unit = Unit::None;
  double min = 0.0, max = 0.0, step = 0.0;  ///< SI; for Int, Real and each component of Vector and Points
  bool animatable = false;
  Affects affects = Affects::Both;
  const char* doc = "";
  std::span<const Choice> choices{};
  const char* refersTo = nullptr;  ///< for Text: it is the id of a node of this type, or empty
  Value (*get)(const NodeData&) = nullptr;
  void (*set)(NodeData&, const Value&) = nullptr;  ///< expects the right alternative and range
};

namespace detail {

template <class M>
struct MemberTraits;
template <class C, class T>
struct MemberTraits<T C::*> {
  using Class = C;
  using Type = T;
};

template <class T>
Value toValue(const T& member) {
  if constexpr (std::is_enum_v<T>)
    return static_cast<std::int64_t>(member);
  else if constexpr (std::is_same_v<T, bool>)
    return member;
  else if constexpr (std::is_integral_v<T>)
    return static_cast<std::int64_t>(member);
  else if constexpr (std::is_floating_point_v<T>)
    return static_cast<double>(member);
  else
    return member;
}

template <class T>
void fromValue(T& member, const Value& value) {
  if constexpr (std::is_same_v<T, bool>)
    member = std::get<bool>(value);
  else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
    member = static_cast<T>(std::get<std::int64_t>(value));
  else if constexpr (std::is_floating_point_v<T>)
    member = static_cast<T>(std::get<double>(value));
  else
    member = std::get<T>(value);
}

template <class T>
constexpr PropertyKind kindOf() {
  if constexpr (std::is_same_v<T, bool>)
    return PropertyKind::Bool;
  else if constexpr (std::is_enum_v<T>)
    return PropertyKind::Choice;
  else if constexpr (std::is_integral_v<T>)
    return PropertyKind::Int;
  else if constexpr (std::is_floating_point_v<T>)
    return PropertyKind::Real;
  else if constexpr (std::is_same_v<T, Vec3d>)
    return PropertyKind::Vector;
  else if constexpr (std::is_same_v<T, PlanPoints>)
    return PropertyKind::Points;
  else
    return PropertyKind::Text;
}

}  // namespace detail

/// A row of the table. The member pointer gives kind, getter and setter; the chained calls give the rest:
///   property<&WeatherNode::windSpeed>("wind_speed_m_s", SPIN_TR("Wind speed"), SPIN_TR("Mean wind ..."))
///       .in(Unit::MetrePerSecond).range(0, 80, 0.5).animated().affecting(Affects::Both)
struct PropertyRow : PropertyInfo {
  constexpr PropertyRow in(Unit u) const {
    auto r = *this;
    r.unit = u;
    return r;
  }
  constexpr PropertyRow range(double low, double high, double by) const {
    auto r = *this;
    r.min = low;
    r.max = high;
    r.step = by;
    return r;
  }
  constexpr PropertyRow animated() const {
    auto r = *this;
    r.animatable = true;
    return r;
  }
  constexpr PropertyRow affecting(Affects a) const {
    auto r = *this;
    r.affects = a;
    return r;
  }
  constexpr PropertyRow colour() const {
    auto r = *this;
    r.kind = PropertyKind::Colour;
    return r;
  }
  constexpr PropertyRow path() const {
    auto r = *this;
    r.kind = PropertyKind::Path;
    return r;
  }
  constexpr PropertyRow naming(const char* nodeTypeId) const {
    auto r = *this;
    r.refersTo = nodeTypeId;
    return r;
  }
  constexpr PropertyRow oneOf(std::span<const Choice> list) const {
    auto r = *this;
    r.choices = list;
    return r;
  }
};

template <auto Member>
constexpr PropertyRow property(const char* id, const char* label, const char* doc) {
  using Traits = detail::MemberTraits<decltype(Member)>;
  using Class = typename Traits::Class;
  PropertyRow row;
  row.id = id;
  row.label = label;
  row.doc = doc;
  row.kind = detail::kindOf<typename Traits::Type>();
  row.get = [](const NodeData& node) { return detail::toValue(static_cast<const Class&>(node).*Member); };
  row.set = [](NodeData& node, const Value& value) {
    detail::fromValue(static_cast<Class&>(node).*Member, value);
  };
  return row;
}

/// A kind of node: its table and how to make one.
struct NodeType {
  const char* id;     ///< "weather"
  const char* label;  ///< SPIN_TR("Weather")
  const char* doc;
  bool single;  ///< at most one in a scene
  std::span<const PropertyRow> properties;
  std::unique_ptr<NodeData> (*create)();
  std::unique_ptr<NodeData> (*clone)(const NodeData&);

  const PropertyInfo* find(std::string_view propertyId) const;
};

template <class T>
constexpr NodeType nodeType(const char* id, const char* label, const char* doc, bool single,
                            std::span<const PropertyRow> rows) {
  return {id,
          label,
          doc,
          single,
          rows,
          [] { return std::unique_ptr<NodeData>(std::make_unique<T>()); },
          [](const NodeData& n) {
            return std::unique_ptr<NodeData>(std::make_unique<T>(static_cast<const T&>(n)));
          }};
}

/// The value of the default node.
Value defaultValue(const NodeType& type, const PropertyInfo& property);
/// Checks kind, finiteness and range; the error names the property, the value and the allowed range.
Status validate(const PropertyInfo& property, const Value& value);
/// Text form that parseValue() reads back: choices by id, all else like toText(value).
std::string toText(const PropertyInfo& property, const Value& value);
/// Reads the command line's text form in SI (choices by id); checks it like validate().
Result<Value> parseValue(const PropertyInfo& property, std::string_view text);

/// The candidate nearest to `word` by edit distance; empty if none is near.
std::string_view nearestName(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace spin
