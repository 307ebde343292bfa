// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/air_solver.h"
#include "core/cloud/cloud_state.h"
#include "core/flow/flow_coupling.h"

namespace spin {

/// What is under way between processes, and the grid.
void saveCloud(const FlowCoupling& coupling, const SnowFallout* cover, const AirState& air, ByteWriter& out);
/// Whatever the bytes are: fits() and AirSolver::restore() find what cannot be. Without a cover what settles
/// is dropped.
AirState loadCloud(ByteReader& in, FlowCoupling& coupling, SnowFallout* cover);
/// Finite places, materials that are there, masses that can be.
bool fits(const CloudState& state, const FlowCoupling& coupling, std::size_t materials);

}  // namespace spin
