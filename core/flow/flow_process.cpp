// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_process.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/flow/flow_coupling.h"
#include "core/flow/flow_estimate.h"
#include "core/flow/flow_frame.h"
#include "core/flow/flow_inputs.h"
#include "core/flow/flow_scene.h"
#include "core/flow/flow_state_io.h"
#include "core/flow/inflow.h"
#include "core/flow/scene_bodies.h"
#include "core/nodes/settings_nodes.h"

namespace spin {
namespace {

/// Events nearer than this are at the same time, s.
constexpr double kSameTime = 1e-9;
/// Lattices that are due within this share of their interval are due.
constexpr double kDue = 1.0 - 1e-9;

double middleFilm(const StepInput& input) {
  return 0.5 * (input.from.film + input.to.film);
}

/// One source during one frame.
struct ActiveInflow {
  InflowLattice lattice;
  double start = 0.0, stop = 0.0;  ///< s of film
  bool runs(double now) const {
    return lattice.interval > 0.0 && now >= start - kSameTime && now < stop - kSameTime;
  }
};

class FlowProcess final : public Process {
 public:
  const char* id() const override { return "flow"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override { hashFlowInputs(input, hasher); }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    if (Status made = makeSolver(scene, context); !made) return made;
    return release(scene, 0.0);
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    updateFlowConfig(input.scene, middleFilm(input), m_config);
    if (Status kept = m_solver->reconfigure(m_config); !kept) return kept;
    m_longest = input.scene.settings<FlowSettingsNode>(middleFilm(input)).longestStep;
    m_steps = {};
    if (!m_bodies.empty()) {
      const Status moved = m_solver->setBodies(
          followKeys(input.scene, m_bodies, m_solver->bodies(), input.from.film, input.to.film));
      if (!moved) return moved;
    }
    m_coupling = context.exchange.find<FlowCoupling>();
    const Status done = advance(input, context);
    m_coupling = nullptr;
    context.backend.timings().merge(m_solver->timings());
    m_solver->timings().clear();
    return done;
  }

  void publish(const SceneSnapshot&, const FrameTime&, Frame& frame) const override {
    publishFlow({*m_solver, m_config, m_births, m_account, m_steps, m_layers}, frame);
    publishBodies(m_bodies, m_solver->bodies(), frame);
  }

  void saveState(ByteWriter& out) const override {
    out.putArray(m_released);
    out.putArray(m_clocks);
    out.putArray(m_births);
    out.put(m_account);
    out.put(m_nextId);
    out.put(m_lastStep);
    saveFlowState(m_solver->state(), out);
  }

  Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) override {
    if (Status made = makeSolver(scene, context); !made) return made;
    const std::size_t releases = m_released.size(), clocks = m_clocks.size();
    m_released = in.getArray<std::uint8_t>();
    m_clocks = in.getArray<InflowClock>();
    m_births = in.getArray<FlowBirth>();
    m_account = in.get<FlowAccount>();
    m_nextId = in.get<std::uint32_t>();
    m_lastStep = in.get<double>();
    const FlowSolverState state = loadFlowState(in);
    const bool fits = in.ok() && m_released.size() == releases && m_clocks.size() == clocks &&
                      m_lastStep >= 0.0 && state.nextId == m_nextId &&
                      std::all_of(m_clocks.begin(), m_clocks.end(),
                                  [](const InflowClock& clock) { return std::isfinite(clock.share); });
    if (!fits)
      return badInput("The checkpoint could not be used", "flow", "its sources do not fit the scene");
    return m_solver->restore(state);
  }

  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    const FlowEstimate need = estimateFlow(scene);
    stateBytes = need.particles * kFlowStateBytes;
    frameBytes = need.particles * flowFrameBytes();
  }

  WorkEstimate estimateWork(const SceneSnapshot& scene, Isa isa, int threads) const override {
    const FlowEstimate need = estimateFlow(scene);
    const double film = scene.timeOf(scene.settings<SimulationNode>(0.0).lastFrame).film;
    return {need.workBytes, need.particles, need.seconds(film, isa, threads)};
  }

 private:
  Status makeSolver(const SceneSnapshot& scene, ProcessContext& context) {
    const FlowScene flow = makeFlowScene(scene, 0.0);
    if (const FlowIssue* issue = flow.fatal())
      return badInput("The flow cannot start", issue->node, issue->text);
    if (const auto tooLarge = memoryIssue(estimateFlow(scene, flow)))
      return Error{ErrorKind::OutOfResources, "The flow cannot start", tooLarge->node, tooLarge->text,
                   "Make spacing_m larger, the release smaller or the film shorter"};
    m_config = flow.config;
    m_bodies = flow.bodies;
    m_releases.clear();
    for (const FlowRelease& r : flow.releases)
      m_releases.push_back({r.node->id, r.data.releaseTime, r.material});
    m_inflowMaterials.clear();
    for (const FlowInflow& inflow : flow.inflows) m_inflowMaterials.push_back(inflow.material);
    m_layers = 0;
    for (const FlowRelease& r : flow.releases) m_layers = m_layers ? std::min(m_layers, r.layers) : r.layers;
    m_released.assign(m_releases.size(), 0);
    m_clocks.assign(flow.inflows.size(), InflowClock{});
    m_births.clear();
    m_account = {};
    m_nextId = 0;
    m_lastStep = 0.0;
    m_steps = {};
    Result<std::unique_ptr<FlowSolver>> made =
        context.makeFlowSolver ? context.makeFlowSolver(m_config)
                               : makeFlowSolverCpu(m_config, context.backend, context.isa);
    if (!made) return made.error();
    m_solver = std::move(*made);
    return {};
  }

  /// Fills the slabs that are due.
  Status release(const SceneSnapshot& scene, double now) {
    const bool land = scene.terrain && !scene.terrain->heights.empty();
    const FlowGround ground(land ? &scene.terrain->heights : nullptr);
    for (std::size_t k = 0; k < m_releases.size(); ++k) {
      if (m_released[k] || m_releases[k].time > now + kSameTime) continue;
      m_released[k] = 1;
      for (const SceneNode& node : scene.nodes) {
        if (node.id != m_releases[k].node) continue;
        const auto data = static_cast<const AvalancheReleaseNode&>(*evaluate(node, 0.0));
        const Slab slab =
            fillSlab(ReleaseArea(node, ground), ground, data.depth, data.depthIsVertical, m_config.spacing);
        if (Status added = enter(slab.positions, {}, m_releases[k].material, now, m_account.released); !added)
          return added;
      }
    }
    return {};
  }

  Status enter(const std::vector<Vec3d>& positions, Vec3d velocity, std::uint8_t material, double now,
               std::array<std::uint64_t, kMostMaterials>& account) {
    std::vector<FlowParticle> particles;
    particles.reserve(positions.size());
    for (const Vec3d& p : positions) {
      particles.emplace_back();
      particles.back().position = p;
      particles.back().velocity = velocity;
      particles.back().material = material;
    }
    const std::size_t before = m_solver->count();
    if (Status added = m_solver->add(particles); !added) return added;
    // Numbers go on from the last one, so they tell the time of birth. What would begin within a solid is
    // left out.
    m_births.push_back({m_nextId, now});
    m_nextId += static_cast<std::uint32_t>(particles.size());
    account[material] += m_solver->count() - before;
    return {};
  }

  std::vector<ActiveInflow> activeInflows(const StepInput& input) const {
    std::vector<ActiveInflow> list;
    for (const SceneNode* node : input.scene.all<WaterSourceNode>()) {
      const auto source = static_cast<const WaterSourceNode&>(*evaluate(*node, middleFilm(input)));
      list.push_back({inflowLattice(input.scene, source, m_config.spacing), source.start, source.stop});
    }
    return list;
  }

  Status inflow(const std::vector<ActiveInflow>& inflows, double now) {
    for (std::size_t k = 0; k < inflows.size(); ++k) {
      if (!inflows[k].runs(now) || m_clocks[k].share < kDue) continue;
      const InflowLattice& lattice = inflows[k].lattice;
      if (Status added =
              enter(lattice.positions, lattice.velocity, m_inflowMaterials[k], now, m_account.inflow);
          !added)
        return added;
      m_clocks[k].entered();
    }
    return {};
  }

  /// The next time after `now` at which something enters or the frame ends.
  double nextEvent(const std::vector<ActiveInflow>& inflows, double now, double end) const {
    double next = end;
    const auto consider = [&](double time) {
      if (time > now + kSameTime && time < end - kSameTime) next = std::min(next, time);
    };
    for (std::size_t k = 0; k < m_releases.size(); ++k)
      if (!m_released[k]) consider(m_releases[k].time);
    for (std::size_t k = 0; k < inflows.size(); ++k) {
      consider(inflows[k].start);
      if (inflows[k].runs(now)) consider(now + m_clocks[k].wait(inflows[k].lattice.interval));
    }
    return next;
  }

  Status advance(const StepInput& input, ProcessContext& context) {
    const std::vector<ActiveInflow> inflows = activeInflows(input);
    const double from = input.from.film, end = input.to.film;
    const int parts = m_coupling ? m_coupling->partsOf(end - from) : 1;
    int part = 1;  // the one that is under way
    const auto partEnd = [&](int k) { return k == parts ? end : from + (end - from) * k / parts; };
    const auto begin = [&](double now) -> Status {
      if (Status entered = rejoin(now); !entered || !m_coupling || !m_coupling->before) return entered;
      return m_coupling->before({input, now, partEnd(part), *m_solver, m_config, context});
    };
    if (Status begun = begin(from); !begun) return begun;
    for (double now = from; now < end - kSameTime;) {
      if (context.cancel.cancelled())
        return Error{ErrorKind::Cancelled, "The simulation stopped", "flow", "it was cancelled", ""};
      if (context.progress) context.progress((now - from) / (end - from));
      if (Status done = release(input.scene, now); !done) return done;
      if (Status done = inflow(inflows, now); !done) return done;
      const double next = nextEvent(inflows, now, partEnd(part));
      const Result<double> seconds = oneStep(next - now, next == partEnd(part));
      if (!seconds) return seconds.error();
      for (std::size_t k = 0; k < inflows.size(); ++k)
        if (inflows[k].runs(now)) m_clocks[k].advance(*seconds, inflows[k].lattice.interval);
      now = next - now - *seconds < kSameTime ? next : now + *seconds;
      if (now < partEnd(part)) continue;
      if (m_coupling) {
        const FlowPart done{input, partEnd(part - 1), now, *m_solver, m_config, context};
        if (Status acted = m_coupling->after(done); !acted) return acted;
      }
      ++part;
      // What comes back at the end of a frame enters at the beginning of the next: it has no samples yet.
      if (part <= parts)
        if (Status begun = begin(now); !begun) return begun;
    }
    return {};
  }

  /// Particles that come back into the flow. What finds no place is given back.
  Status rejoin(double now) {
    if (!m_coupling || m_coupling->rejoining.empty()) return {};
    const std::vector<FlowParticle> coming = std::exchange(m_coupling->rejoining, {});
    const std::uint32_t first = m_nextId;
    const std::size_t before = m_solver->count();
    m_births.push_back({first, now});
    m_nextId += static_cast<std::uint32_t>(coming.size());
    if (Status added = m_solver->add(coming); !added) return added;
    if (m_solver->count() - before == coming.size()) return {};
    std::vector<bool> there(coming.size(), false);
    for (const FlowSample& s : m_solver->samples())
      if (s.particle.id >= first) there[s.particle.id - first] = true;
    for (std::size_t k = 0; k < coming.size(); ++k)
      if (!there[k]) m_coupling->refused.push_back(coming[k]);
    return {};
  }

  /// A step of at most `left`. The last one of a frame is sampled; which one that is is not known before, so
  /// the ones that may be are, and one that is not sampled leaves something to do.
  Result<double> oneStep(double left, bool toFrameEnd) {
    if (m_solver->count() == 0 && m_bodies.empty()) return left;
    double most = std::min(m_longest, left);
    const double usual = m_lastStep > 0.0 ? m_lastStep : m_longest;
    const bool maybeLast = toFrameEnd && left <= 2.0 * usual;
    if (toFrameEnd && !maybeLast) most = std::min(most, left - 0.5 * usual);
    m_solver->sample(maybeLast);
    const Result<FlowStep> done = m_solver->step(most);
    if (!done) return done.error();
    m_lastStep = done->seconds;
    ++m_steps.steps;
    ++m_steps.limits[static_cast<std::size_t>(done->limit)];
    m_steps.seconds += done->seconds;
    m_steps.pressureIterations += static_cast<std::uint64_t>(done->pressure.iterations);
    m_steps.viscosityIterations += static_cast<std::uint64_t>(done->viscous.iterations);
    m_steps.viscositySolves += done->viscosity == ViscosityMode::Implicit ? 1 : 0;
    return done->seconds;
  }

  struct Release {
    std::string node;
    double time = 0.0;  ///< s of film
    std::uint8_t material = 0;
  };

  FlowConfig m_config;
  std::unique_ptr<FlowSolver> m_solver;
  std::vector<Release> m_releases;
  std::vector<std::uint8_t> m_inflowMaterials;
  std::vector<FlowBody> m_bodies;
  int m_layers = 0;
  double m_longest = 0.02;  ///< s

  // The state, besides the solver's.
  std::vector<std::uint8_t> m_released;  ///< by m_releases: is there
  std::vector<InflowClock> m_clocks;     ///< by sources
  std::vector<FlowBirth> m_births;
  FlowAccount m_account;
  std::uint32_t m_nextId = 0;  ///< of the next particle
  double m_lastStep = 0.0;     ///< s

  FlowCoupling* m_coupling = nullptr;  ///< during a step, where there is one
  FlowStepCount m_steps;               ///< of the latest frame
};

}  // namespace

ProcessType flowProcessType() {
  return {"flow", 700, sceneHasFlow,
          [] { return std::unique_ptr<Process>(std::make_unique<FlowProcess>()); }};
}

}  // namespace spin
