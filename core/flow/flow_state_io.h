// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sim/serialize.h"
#include "core/sph/flow_state.h"

namespace spin {

/// Bytes of a state for each particle, without what the scene adds.
inline constexpr double kFlowStateBytes =
    3 * sizeof(std::int32_t) + sizeof(PairRecord) + sizeof(ParticleExtra) + 2 * sizeof(std::uint32_t);

void saveFlowState(const FlowSolverState& state, ByteWriter& out);
/// Whatever the bytes are: what does not fit is found by FlowSolver::restore.
FlowSolverState loadFlowState(ByteReader& in);

}  // namespace spin
