// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/nodes/node_registry.h"
#include "editor/cli/commands.h"

namespace spin {
namespace {

const char* kindText(PropertyKind kind) {
  switch (kind) {
    case PropertyKind::Bool:
      return "true or false";
    case PropertyKind::Int:
      return "whole number";
    case PropertyKind::Real:
      return "number";
    case PropertyKind::Vector:
      return "three numbers";
    case PropertyKind::Colour:
      return "colour, linear RGB";
    case PropertyKind::Choice:
      return "choice";
    case PropertyKind::Points:
      return "points `x y; x y; ...`";
    case PropertyKind::Text:
      return "text";
    case PropertyKind::Path:
      return "file";
  }
  return "";
}

std::string unitText(const PropertyInfo& property) {
  switch (property.unit) {
    case Unit::None:
    case Unit::Factor:
      return "";
    case Unit::Metre:
      return "m";
    case Unit::MetrePerSecond:
      return "m/s";
    case Unit::Degree:
      return "degree";
    case Unit::Kelvin:
      return "K";
    case Unit::PrecipitationRate:
      return "kg/(m2 s)";
    case Unit::KilogramPerCubicMetre:
      return "kg/m3";
    case Unit::Second:
      return "s";
    case Unit::PerSecond:
      return "1/s";
    case Unit::Pixel:
      return "pixel";
    case Unit::Byte:
      return "byte";
    case Unit::SquareMetrePerSecond:
      return "m2/s";
    case Unit::CubicMetrePerSecond:
      return "m3/s";
    case Unit::PascalSecond:
      return "Pa s";
    case Unit::Pascal:
      return "Pa";
    case Unit::PerMetre:
      return "1/m";
  }
  return "";
}

const char* affectsText(Affects affects) {
  switch (affects) {
    case Affects::Nothing:
      return "nothing computed";
    case Affects::Picture:
      return "picture";
    case Affects::Simulation:
      return "simulation";
    case Affects::Both:
      return "simulation and picture";
  }
  return "";
}

std::string valuesText(const PropertyInfo& property) {
  if (property.kind == PropertyKind::Choice) {
    std::string list;
    for (const Choice& choice : property.choices)
      list += fmt::format("{}`{}`", list.empty() ? "" : ", ", choice.id);
    return list;
  }
  const bool ranged = property.kind == PropertyKind::Int || property.kind == PropertyKind::Real ||
                      property.kind == PropertyKind::Vector || property.kind == PropertyKind::Points;
  if (property.refersTo) return fmt::format("id of a `{}`", property.refersTo);
  if (!ranged || property.min == property.max) return kindText(property.kind);
  return fmt::format("{}, {:g} to {:g}", kindText(property.kind), property.min, property.max);
}

std::string defaultText(const NodeType& type, const PropertyInfo& property) {
  const Value value = defaultValue(type, property);
  const auto* choice = std::get_if<std::int64_t>(&value);
  if (property.kind == PropertyKind::Choice && choice)
    return property.choices[static_cast<std::size_t>(*choice)].id;
  const auto* real = std::get_if<double>(&value);
  return real ? fmt::format("{:.6g}", *real) : toText(value);
}

}  // namespace

std::string propertyReference() {
  std::string page =
      "# Properties\n\n"
      "Written from the property tables by `spindrift-cli reference`; do not edit by hand. Values are in the "
      "units of\n"
      "scene files and of `--set node.property=value` (SI); the editor shows friendlier ones. Animatable "
      "properties can\n"
      "carry keyframes. The last column says what is computed again after a change.\n";
  for (const NodeType* type : nodeTypes()) {
    page += fmt::format("\n## {} (`{}`)\n\n{}{}\n\n", type->label, type->id, type->doc,
                        type->single ? " At most one in a scene." : "");
    page += "| property | meaning | values | unit | default | animatable | affects |\n";
    page += "| --- | --- | --- | --- | --- | --- | --- |\n";
    for (const PropertyRow& row : type->properties) {
      const std::string standard = defaultText(*type, row);
      page += fmt::format("| `{}` | **{}.** {} | {} | {} | {} | {} | {} |\n", row.id, row.label, row.doc,
                          valuesText(row), unitText(row), standard.empty() ? "none" : standard,
                          row.animatable ? "yes" : "no", affectsText(row.affects));
    }
  }
  return page;
}

}  // namespace spin
