// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_materials.h"

#include <cmath>

#include "core/base/check.h"
#include "core/base/units.h"

namespace spin {
namespace {

/// Time of Papanastasiou's regularisation, s: below a shear rate of 1/m the yield stress fades, above it is
/// exact to e^-m gd.
constexpr float kRegularisation = 100.0f;

float tangentOf(double degrees) {
  return static_cast<float>(std::tan(degreesToRadians(degrees)));
}

/// Mohr-Coulomb yield with a Newtonian rest.
FlowMaterialConfig frictional(double density, double cohesion, double angleDegrees, double viscosity) {
  FlowMaterialConfig m;
  m.restDensity = density;
  m.rheology.law = RheologyLaw::Yield;
  m.rheology.viscosity = static_cast<float>(viscosity);
  m.rheology.cohesion = static_cast<float>(cohesion);
  m.rheology.frictionTangent = tangentOf(angleDegrees);
  m.rheology.regularisation = kRegularisation;
  return m;
}

FlowMaterialConfig cross(double density, double atRest, double atSpeed, double factor, double exponent) {
  FlowMaterialConfig m;
  m.restDensity = density;
  m.rheology.law = RheologyLaw::Cross;
  m.rheology.viscosity = static_cast<float>(atRest);
  m.rheology.viscosityAtSpeed = static_cast<float>(atSpeed);
  m.rheology.crossFactor = static_cast<float>(factor);
  m.rheology.exponent = static_cast<float>(exponent);
  // The clamp that was published with both sets.
  m.rheology.least = 1.0f;
  m.rheology.most = 300.0f;
  return m;
}

FlowMaterialConfig water() {
  FlowMaterialConfig m;
  m.restDensity = 999.8;
  m.rheology.viscosity = 1.79e-3f;
  return m;
}

constexpr const char* kCrossSource =
    "Cross 1965 with the numbers that a thesis of Zhejiang University on large snow scenes and avalanches "
    "prints";

}  // namespace

FlowMaterialPreset flowMaterialPreset(FlowMaterialKind kind) {
  switch (kind) {
    case FlowMaterialKind::DrySnow:
      return {frictional(300.0, 50.0, 27.0, 1.0),
              "dense dry flow; cohesion and friction of the order that chute experiments with flowing snow "
              "give for dry snow (Platzer, Bartelt and Kern 2007; Bartelt et al. 2015)"};
    case FlowMaterialKind::WetSnow: {
      FlowMaterialConfig m = frictional(450.0, 200.0, 24.0, 5.0);
      // The apex of the Mohr-Coulomb cone, c / tan(phi) = 449 Pa, is the most that this cohesion could bear.
      m.tensileStrength = 200.0;
      return {m,
              "dense wet flow; cohesion and friction of the order that chute experiments with flowing snow "
              "give for wet snow (Platzer, Bartelt and Kern 2007; Bartelt et al. 2015)"};
    }
    case FlowMaterialKind::Slush: {
      FlowMaterialConfig m = frictional(900.0, 20.0, 0.0, 2.0);
      m.rheology.exponent = 0.7f;
      return {m,
              "Herschel-Bulkley fluid near the density of water, of the kind used for water-saturated "
              "snow (Jaedicke, Kern, Gauer, Baillifard and Platzer 2008)"};
    }
    case FlowMaterialKind::Water:
      return {water(), "fresh water at 0 degrees Celsius: 999.8 kg/m3, 1.79 mPa s"};
    case FlowMaterialKind::CrossThinning:
      return {cross(400.0, 100.0, 1.0, 3000.0, 2.0), kCrossSource};
    case FlowMaterialKind::CrossThickening:
      return {cross(400.0, 1.0, 200.0, 300.0, 1.0), kCrossSource};
    case FlowMaterialKind::Custom:
      break;
  }
  SPIN_CHECK(false, "a preset of a custom material");
}

FlowMaterialConfig customFlowMaterial(const FlowMaterialNode& node) {
  FlowMaterialConfig m;
  m.restDensity = node.density;
  m.tensileStrength = node.tensileStrength;
  Rheology& r = m.rheology;
  r.viscosity = static_cast<float>(node.viscosity);
  r.least = static_cast<float>(node.least);
  r.most = static_cast<float>(node.most);
  r.regularisation = kRegularisation;
  if (node.law == FlowLaw::Newtonian) return m;
  r.law = RheologyLaw::Yield;
  const bool power = node.law == FlowLaw::PowerLaw || node.law == FlowLaw::HerschelBulkley;
  const bool yields =
      node.law == FlowLaw::Bingham || node.law == FlowLaw::HerschelBulkley || node.law == FlowLaw::Frictional;
  if (power) r.exponent = static_cast<float>(node.exponent);
  if (yields) r.cohesion = static_cast<float>(node.cohesion);
  if (node.law == FlowLaw::Frictional) r.frictionTangent = tangentOf(node.frictionAngleDegrees);
  if (node.law == FlowLaw::Cross) {
    r.law = RheologyLaw::Cross;
    r.exponent = static_cast<float>(node.exponent);
    r.viscosityAtSpeed = static_cast<float>(node.viscosityAtSpeed);
    r.crossFactor = static_cast<float>(node.crossFactor);
  }
  return m;
}

}  // namespace spin
