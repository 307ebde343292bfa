// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/ground_materials.h"

#include <array>

namespace spin {
namespace {

/// Evaporation as a conductance: moist soil and grass 5 mm/s, none from stone and asphalt; a lake meets no
/// resistance of its own.
GroundMaterial material(float conductivity, float heatCapacity, float frozenWater, float albedo,
                        float roughness, float evaporation) {
  GroundMaterial m;
  m.conductivity = conductivity;
  m.heatCapacity = heatCapacity;
  m.frozenWater = frozenWater;
  m.albedo = albedo;
  m.roughness = roughness;
  m.evaporation = evaporation;
  return m;
}

const std::array<GroundMaterial, kGroundTypeCount> kMaterials = {
    material(0.4427f, 1.9e6f, 0.0f, 0.30f, 0.01f, 0.0f),      // quartz
    material(0.1674f, 1.3e6f, 40.0f, 0.35f, 0.01f, 0.001f),   // sand, nearly dry
    material(0.6276f, 2.2e6f, 200.0f, 0.20f, 0.05f, 0.005f),  // soil, peat: moist
    material(0.1255f, 1.6e6f, 250.0f, 0.20f, 0.10f, 0.005f),  // vegetation, humus
    material(2.9f, 2.2e6f, 0.0f, 0.25f, 0.05f, 0.0f),         // rock: granite
    material(2.2f, 1.93e6f, 0.0f, 0.40f, 0.01f, 0.1f),        // ice
    material(0.75f, 1.9e6f, 0.0f, 0.10f, 0.005f, 0.0f),       // asphalt
    material(0.60f, 4.18e6f, 1000.0f, 0.08f, 0.001f, 0.1f),   // water at rest
};

}  // namespace

const GroundMaterial& groundMaterial(GroundType type) {
  return kMaterials[static_cast<std::size_t>(type)];
}

}  // namespace spin
