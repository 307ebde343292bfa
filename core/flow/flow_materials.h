// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/nodes/flow_nodes.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// Numbers of a preset and where they come from. Sound speed is left at its default: it follows from the
/// scene.
struct FlowMaterialPreset {
  FlowMaterialConfig material;
  const char* source;
};

/// Not for Custom.
FlowMaterialPreset flowMaterialPreset(FlowMaterialKind kind);
/// Numbers of a material of one's own.
FlowMaterialConfig customFlowMaterial(const FlowMaterialNode& node);

}  // namespace spin
