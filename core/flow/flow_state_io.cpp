// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_state_io.h"

namespace spin {

void saveFlowState(const FlowSolverState& state, ByteWriter& out) {
  const FlowHostState& p = state.particles;
  for (const auto* axis : {&p.x, &p.y, &p.z}) out.putArray(*axis);
  out.putArray(p.records);
  out.putArray(p.extras);
  out.putArray(p.ids);
  out.putArray(p.excess);
  out.put(state.nextId);
  out.put(state.lastStep);
  for (const auto* counts : {&state.losses.left, &state.losses.sunk})
    for (const std::uint64_t count : *counts) out.put(count);
  out.putArray(state.bodies);
}

FlowSolverState loadFlowState(ByteReader& in) {
  FlowSolverState state;
  FlowHostState& p = state.particles;
  for (auto* axis : {&p.x, &p.y, &p.z}) *axis = in.getArray<std::int32_t>();
  p.records = in.getArray<PairRecord>();
  p.extras = in.getArray<ParticleExtra>();
  p.ids = in.getArray<std::uint32_t>();
  p.excess = in.getArray<float>();
  state.nextId = in.get<std::uint32_t>();
  state.lastStep = in.get<double>();
  for (auto* counts : {&state.losses.left, &state.losses.sunk})
    for (std::uint64_t& count : *counts) count = in.get<std::uint64_t>();
  state.bodies = in.getArray<RigidState>();
  return state;
}

}  // namespace spin
