// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/sph/flow_solver.h"
#include "core/sph/flow_view.h"

namespace spin {

/// Every value in range, the box not empty, periodic lengths whole, no more cells than positions can say.
Status checkFlowConfig(const FlowConfig& config);
/// Makes the signed distance of every mesh among the walls that has none; drops its triangles.
Status makeMeshFields(FlowConfig& config, int threads, const CancelToken& cancel = {});
/// Constants, walls without the arrays of ground and meshes, domain and periods.
FlowView flowView(const FlowConfig& config);
/// Whether any material needs the shear rate.
bool needsShearRate(const FlowConfig& config);
/// Whether a step may take the implicit form of viscosity: asked for, or Auto and some material's viscosity
/// can bind the step.
bool mayNeedImplicitViscosity(const FlowConfig& config);

/// Whether a solver of one configuration can go on with the other: see FlowSolver::reconfigure.
Status checkReconfiguration(const FlowConfig& from, const FlowConfig& to);

/// A share in whole kGivenUnit.
inline std::int32_t unitsGiven(double share) {
  return static_cast<std::int32_t>(std::lround(share / kGivenUnit));
}

/// Particles as the solver's arrays hold them.
struct FlowHostState {
  std::vector<std::int32_t> x, y, z;
  std::vector<PairRecord> records;
  std::vector<ParticleExtra> extras;
  std::vector<std::uint32_t> ids;
  std::vector<float> excess;
  std::vector<std::int32_t> given;  ///< kGivenUnit; empty = none has given anything

  std::size_t size() const { return x.size(); }
  void resize(std::size_t n);
};
/// Appends particles but those that lie in a solid or in one of the bodies where they are now; ids from
/// firstId on, theirs too.
Status appendParticles(const FlowConfig& config, const std::vector<RigidState>& bodies,
                       const std::vector<FlowParticle>& particles, std::uint32_t firstId,
                       FlowHostState& state);
/// What FlowSolver::exchange does, to the arrays; `given` is there. Fails, and changes nothing, where a
/// number is not that of a living particle or comes twice, or a value is out of range.
Status exchangeParticles(const std::vector<FlowExchange>& changes, FlowHostState& state);
FlowParticle flowParticle(const FlowConfig& config, const FlowHostState& state, std::size_t i);

}  // namespace spin
