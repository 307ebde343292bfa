// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_estimate.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "core/flow/flow_state_io.h"
#include "core/flow/inflow.h"
#include "core/nodes/settings_nodes.h"

namespace spin {
namespace {

/// Particle-steps a second and thread, measured by sph-speed at 200,000 particles (performance.md): Newtonian
/// and with the shear rate, by instruction set.
constexpr double kRates[3][2] = {{1.75e6, 1.0e6}, {4.1e6, 2.3e6}, {5.9e6, 3.2e6}};
/// Arrays of the solver, what is downloaded for a frame, and the state that is kept for a resume, bytes a
/// particle.
constexpr double kWorkBytes = 150.0 + 150.0 + 44.0;
/// Search and sums go over four times as many neighbours at support 3.
constexpr double kAccurateCost = 3.0;

}  // namespace

double FlowEstimate::seconds(double film, Isa isa, int threads) const {
  if (particles <= 0.0 || stepSeconds <= 0.0) return 0.0;
  return particles * (film / stepSeconds) / (kRates[static_cast<int>(isa)][shears ? 1 : 0] * threads);
}

FlowEstimate estimateFlow(const SceneSnapshot& scene, const FlowScene& flow) {
  FlowEstimate need;
  const FlowConfig& c = flow.config;
  if (const SceneNode* node = scene.first<FlowSettingsNode>())
    need.node = node->id;
  else if (!flow.releases.empty())
    need.node = flow.releases.front().node->id;
  for (const FlowRelease& release : flow.releases) need.particles += release.particles;
  const double end = scene.timeOf(scene.settings<SimulationNode>(0.0).lastFrame).film;
  for (const FlowInflow& inflow : flow.inflows) {
    const auto source = static_cast<const WaterSourceNode&>(*evaluate(*inflow.node, 0.0));
    const InflowLattice lattice = inflowLattice(scene, source, c.spacing);
    const double open = std::max(std::min(end, source.stop) - source.start, 0.0);
    if (lattice.interval > 0.0)
      need.particles += open / lattice.interval * static_cast<double>(lattice.positions.size());
  }
  need.workBytes = need.particles * kWorkBytes;
  for (const FlowMaterialConfig& m : c.materials) {
    need.shears = need.shears || m.rheology.needsShearRate();
    // On the way the flow is about half as fast as at its fastest.
    double step = c.courant * c.spacing / (m.soundSpeed + 0.5 * flow.fastest);
    const double most = m.rheology.needsShearRate() ? static_cast<double>(m.rheology.most)
                                                    : static_cast<double>(m.rheology.viscosity);
    if (most > 0.0) step = std::min(step, c.viscousFactor * c.spacing * c.spacing * m.restDensity / most);
    need.stepSeconds = need.stepSeconds > 0.0 ? std::min(need.stepSeconds, step) : step;
  }
  need.stepSeconds = std::min(need.stepSeconds, scene.settings<FlowSettingsNode>(0.0).longestStep);
  if (c.supportSpacings > 2.5) need.stepSeconds /= kAccurateCost;
  return need;
}

double physicalMemory() {
  return static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

std::optional<FlowIssue> memoryIssue(const FlowEstimate& need, double available) {
  const double bytes = need.workBytes + 2.0 * kFlowStateBytes * need.particles;
  if (bytes <= available && need.particles < 2.0e9) return std::nullopt;
  return FlowIssue{
      need.node,
      fmt::format("about {:.3g} million particles take {:.1f} GB of memory and {:.1f} GB are there",
                  need.particles * 1e-6, bytes * 1e-9, available * 1e-9),
      true};
}

std::vector<FlowIssue> findFlowIssues(const SceneSnapshot& scene) {
  FlowScene flow = makeFlowScene(scene, 0.0);
  if (flow.fatal()) return flow.issues;
  if (const auto issue = memoryIssue(estimateFlow(scene, flow))) flow.issues.push_back(*issue);
  return flow.issues;
}

FlowEstimate estimateFlow(const SceneSnapshot& scene) {
  return estimateFlow(scene, makeFlowScene(scene, 0.0, false));
}

}  // namespace spin
