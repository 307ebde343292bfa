// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/flow/flow_scene.h"

namespace spin {

/// Surfaces before this one are those of ground types and closed sides.
inline constexpr std::size_t kFirstBodySurface = 9;

/// Puts the solids of the scene into the configuration, whose domain stands already: the terrain within the
/// domain with its painted surfaces (level ground at height 0 where there is none), and closed sides.
void setFlowWalls(const SceneSnapshot& scene, const FlowSettingsNode& settings, FlowScene& flow);

}  // namespace spin
