// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/flow_state.h"

#include <cmath>

namespace spin {
namespace {

Status unfit(std::string why) {
  return badInput("The particles' state cannot be used", {}, std::move(why),
                  "Compute it anew: it is damaged, or of another scene");
}

bool fits(const FlowConfig& config, const FlowView& view, const FlowSolverState& state, std::size_t i) {
  const FlowHostState& p = state.particles;
  const ParticleExtra& extra = p.extras[i];
  const PairRecord& r = p.records[i];
  const bool within = p.x[i] >= 0 && p.y[i] >= 0 && p.z[i] >= 0 && p.x[i] < view.domainX &&
                      p.y[i] < view.domainY && p.z[i] < view.domainZ;
  const bool finite =
      std::isfinite(r.vx) && std::isfinite(r.vy) && std::isfinite(r.vz) && std::isfinite(p.excess[i]);
  const bool share = p.given.empty() || std::abs(std::int64_t{p.given[i]}) <= unitsGiven(1.0);
  return share && (within || (extra.flags & kDead)) && finite && extra.material < config.materials.size() &&
         p.ids[i] < state.nextId;
}

}  // namespace

Status checkState(const FlowConfig& config, const FlowSolverState& state) {
  const FlowHostState& p = state.particles;
  const std::size_t n = p.x.size();
  for (const std::size_t size :
       {p.y.size(), p.z.size(), p.records.size(), p.extras.size(), p.ids.size(), p.excess.size()})
    if (size != n) return unfit("its arrays differ in length");
  if (!p.given.empty() && p.given.size() != n) return unfit("its arrays differ in length");
  if (n > INT32_MAX - kPairPadding) return unfit("it has too many particles");
  if (!(state.lastStep >= 0.0) || !std::isfinite(state.lastStep)) return unfit("its last step is not valid");
  if (state.bodies.size() != config.bodies.size()) return unfit("it has more or fewer bodies");
  for (const RigidState& body : state.bodies)
    if (!isFinite(body)) return unfit("a body's state is not finite");
  const FlowView view = flowView(config);
  for (std::size_t i = 0; i < n; ++i)
    if (!fits(config, view, state, i))
      return unfit("particle " + std::to_string(i) + " lies outside, is not finite, or has no material");
  return {};
}

}  // namespace spin
