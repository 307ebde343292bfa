// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/flow/flow_materials.h"
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
    case Unit::Millimetre:
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
    case Unit::PercentPerHundredMetres:
      return "1/m";
    case Unit::KelvinPerMetre:
      return "K/m";
    case Unit::WattPerSquareMetre:
      return "W/m2";
    case Unit::KilogramPerSquareMetreDayKelvin:
      return "kg/(m2 s K)";
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

std::string lawText(const Rheology& r) {
  if (r.law == RheologyLaw::Newtonian) return fmt::format("Newtonian, {:.3g} Pa s", r.viscosity);
  if (r.law == RheologyLaw::Cross)
    return fmt::format(
        "Cross, mu_0 {:g} Pa s, mu_inf {:g} Pa s, K {:g} s^n, n {:g}, held within {:g} to {:g} Pa s",
        r.viscosity, r.viscosityAtSpeed, r.crossFactor, r.exponent, r.least, r.most);
  return fmt::format("{}, cohesion {:g} Pa, tan phi {:.3g}, consistency {:g} Pa s^n, n {:.3g}",
                     r.frictionTangent > 0.0f ? "frictional (Mohr-Coulomb)" : "Herschel-Bulkley", r.cohesion,
                     r.frictionTangent, r.viscosity, r.exponent);
}

std::string materialsTable(const NodeType& release) {
  std::string text =
      "\n## Presets of flow materials\n\n"
      "Viscosities are also held below the cap of the flow settings.\n\n"
      "| material | density | law | source |\n| --- | --- | --- | --- |\n";
  const PropertyInfo* property = release.find("material");
  for (int k = 0; property && k < kFlowMaterialKinds; ++k) {
    const auto kind = static_cast<FlowMaterialKind>(k);
    if (kind == FlowMaterialKind::Custom) continue;
    const FlowMaterialPreset preset = flowMaterialPreset(kind);
    text +=
        fmt::format("| `{}` | {:g} kg/m3 | {} | {} |\n", property->choices[static_cast<std::size_t>(k)].id,
                    preset.material.restDensity, lawText(preset.material.rheology), preset.source);
  }
  return text;
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
  return page + materialsTable(kAvalancheReleaseType);
}

}  // namespace spin
