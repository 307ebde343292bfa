// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/flow/flow_scene.h"
#include "core/sim/frame.h"

namespace spin {

/// Models that rigid_body nodes make solid: those that stand become static meshes of the walls, the others
/// bodies of the solver, where they stand at film time 0. What cannot be is an issue.
void addSceneBodies(const SceneSnapshot& scene, FlowScene& flow);

/// States in which kinematic bodies follow their models' keys from one film time to another; the others stay.
std::vector<RigidState> followKeys(const SceneSnapshot& scene, const std::vector<FlowBody>& bodies,
                                   std::vector<RigidState> states, double from, double to);

/// Puts the part "bodies" into the frame where there are any.
void publishBodies(const std::vector<FlowBody>& bodies, const std::vector<RigidState>& states, Frame& frame);

}  // namespace spin
