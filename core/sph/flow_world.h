// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/rigid/rigid_world.h"
#include "core/sph/body_view.h"
#include "core/sph/flow_solver.h"

/// What the solver's bodies need of the host.
namespace spin {

/// The bodies among the walls. Every mesh wall has its field.
Result<RigidWorld> makeFlowWorld(const FlowConfig& config);

/// Boundary particles of all bodies, body after body.
struct BodyPoints {
  std::vector<BodyPoint> points;
  std::vector<BodyChunk> chunks;
  std::vector<std::uint8_t> surfaces;  ///< by body
};
BodyPoints makeBodyPoints(const FlowConfig& config);

/// Poses in the solver's units from `origin` (domainMin) on.
std::vector<BodyPose> bodyPoses(const std::vector<RigidState>& states, const FlowView& view, Vec3d origin);

}  // namespace spin
