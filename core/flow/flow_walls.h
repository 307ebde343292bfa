// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/flow/flow_scene.h"

namespace spin {

/// Puts the solids of the scene into the configuration, whose domain stands already: the terrain within the
/// domain with its painted surfaces (level ground at height 0 where there is none), closed sides, and the
/// models that rigid_body nodes make solid, where they stand at film time 0.
void setFlowWalls(const SceneSnapshot& scene, const FlowSettingsNode& settings, FlowScene& flow);

}  // namespace spin
