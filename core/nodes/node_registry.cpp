// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/node_registry.h"

#include <array>

#include "core/nodes/air_nodes.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flake_node.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/painted_kinds.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {

std::span<const NodeType* const> nodeTypes() {
  static constexpr std::array kTypes{&kTerrainType,         &kModelType,
                                     &kGroundTypeLayerType, &kGroundTemperatureLayerType,
                                     &kSnowDepthLayerType,  &kKeepClearLayerType,
                                     &kWeatherType,         &kSnowfallType,
                                     &kFlakeType,           &kSnowCoverType,
                                     &kHeatSourceType,      &kAvalancheReleaseType,
                                     &kWaterSourceType,     &kFlowSinkType,
                                     &kRigidBodyType,       &kFlowMaterialType,
                                     &kFlowSettingsType,    &kAirType,
                                     &kCameraType,          &kRenderType,
                                     &kSimulationType};
  return kTypes;
}

const NodeType* findNodeType(std::string_view id) {
  for (const NodeType* type : nodeTypes())
    if (id == type->id) return type;
  return nullptr;
}

bool isPaintedType(const NodeType& type) {
  return paintedKind(type) != nullptr;
}

}  // namespace spin
