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
  out.putArray(p.given);
  out.put(state.nextId);
  out.put(state.lastStep);
  out.put(state.losses);
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
  p.given = in.getArray<std::int32_t>();
  state.nextId = in.get<std::uint32_t>();
  state.lastStep = in.get<double>();
  state.losses = in.get<FlowLosses>();
  state.bodies = in.getArray<RigidState>();
  return state;
}

}  // namespace spin
