// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_process.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/cloud/cloud_estimate.h"
#include "core/cloud/cloud_exchange.h"
#include "core/cloud/cloud_frame.h"
#include "core/cloud/cloud_state_io.h"
#include "core/flow/flow_inputs.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/pipeline.h"

namespace spin {
namespace {

/// Cells a second and thread, of the grid with one exchange, by its measured rate.
constexpr double kCellRate = 1.5e6;
/// Of a checkpoint, bytes a cell.
constexpr double kStateBytes = 32.0;

class CloudProcess final : public Process {
 public:
  const char* id() const override { return "air"; }

  void hashInputs(const StepInput& input, Hasher& hasher) const override {
    hasher.add("air");
    // Solids, materials and the box are the flow's.
    hashFlowInputs(input, hasher);
    for (const SceneNode* node : input.scene.all<AirNode>())
      for (const double film : {input.from.film, input.to.film}) input.scene.hashNode(*node, film, hasher);
  }

  Status begin(const SceneSnapshot& scene, ProcessContext& context) override {
    m_state = {};
    return make(scene, context);
  }

  Status step(const StepInput& input, ProcessContext& context) override {
    if (std::exchange(m_coupled, false)) return {};
    // The flow is held: the air goes on by itself.
    m_steps.clear();
    const double from = input.from.film, seconds = input.to.film - from;
    const int parts = m_coupling->partsOf(seconds);
    for (int k = 0; k < parts; ++k) {
      if (Status done =
              part(input, from + seconds * k / parts, from + seconds * (k + 1) / parts, nullptr, context);
          !done)
        return done;
      if (context.progress) context.progress((k + 1.0) / parts);
    }
    return {};
  }

  void publish(const SceneSnapshot& scene, const FrameTime& time, Frame& frame) const override {
    const AirNode settings = scene.settings<AirNode>(time.film);
    publishCloud({*m_air, *m_scene, settings, m_state, *m_coupling, m_cover, m_steps}, frame);
  }

  void saveState(ByteWriter& out) const override {
    m_state.save(out);
    saveCloud(*m_coupling, m_cover, m_air->state(), out);
  }

  Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) override {
    if (Status made = make(scene, context); !made) return made;
    m_state.load(in);
    const AirState air = loadCloud(in, *m_coupling, m_cover);
    if (!in.ok() || !fits(m_state, *m_coupling, m_scene->flow.materials.size()))
      return badInput("The checkpoint could not be used", "air", "its spray does not fit the scene");
    return m_air->restore(air);
  }

  void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const override {
    const double cells = filledCells(scene);
    const double drops = scene.settings<AirNode>(0.0).mostDrops;
    stateBytes = cells * kStateBytes + drops * sizeof(SprayParcel);
    frameBytes = cells * kAirFrameBytes + drops * kSprayFrameBytes;
  }

  WorkEstimate estimateWork(const SceneSnapshot& scene, Isa, int threads) const override {
    const double cells = filledCells(scene);
    const double film = scene.timeOf(scene.settings<SimulationNode>(0.0).lastFrame).film;
    const double steps = film / scene.settings<AirNode>(0.0).coupling;
    return {cells * kCloudWorkBytes, static_cast<double>(scene.settings<AirNode>(0.0).mostDrops),
            cells * steps / (kCellRate * threads)};
  }

 private:
  static double filledCells(const SceneSnapshot& scene) {
    const Result<CloudScene> made = makeCloudScene(scene, {}, false);
    return made ? spin::filledCells(*made) : 0.0;
  }

  Status make(const SceneSnapshot& scene, ProcessContext& context) {
    Result<CloudScene> made = makeCloudScene(scene, context.cancel);
    if (!made) return made.error();
    const SceneNode* node = scene.first<AirNode>();
    if (const auto tooLarge = memoryIssue(*made, node ? node->id : std::string()))
      return badInput("The air cannot start", tooLarge->node, tooLarge->text);
    m_scene = std::make_unique<CloudScene>(std::move(*made));
    Result<std::unique_ptr<AirSolver>> air =
        context.makeAirSolver ? context.makeAirSolver(m_scene->air)
                              : makeAirSolverCpu(m_scene->air, context.backend, context.isa);
    if (!air) return air.error();
    m_air = std::move(*air);
    m_steps.clear();
    m_coupled = false;
    m_cover = context.exchange.find<SnowFallout>();
    m_coupling = &context.exchange.emplace<FlowCoupling>();
    m_coupling->longest = scene.settings<AirNode>(0.0).coupling;
    m_coupling->before = [this](const FlowPart& begins) -> Status {
      m_before.note(begins.solver.samples());
      return {};
    };
    m_coupling->after = [this](const FlowPart& done) { return after(done); };
    return {};
  }

  /// The flow has gone through a part of the frame.
  Status after(const FlowPart& done) {
    if (isPaused(done.frame.scene, *this, done.frame.to.film)) return {};
    if (!m_coupled) m_steps.clear();
    m_coupled = true;
    return part(done.frame, done.from, done.to, &done, done.context);
  }

  Status part(const StepInput& input, double from, double to, const FlowPart* flow, ProcessContext& context) {
    if (context.cancel.cancelled())
      return Error{ErrorKind::Cancelled, "The simulation stopped", "air", "it was cancelled", ""};
    const AirNode settings = input.scene.settings<AirNode>(0.5 * (from + to));
    if (flow && m_scene->solids.move()) {
      m_scene->solids.place(flow->solver.bodies());
      if (Status moved = m_air->moveSolids(m_scene->solids.airSolids()); !moved) return moved;
    }
    const CloudPart made{settings,
                         from,
                         to,
                         input.scene.settings<SimulationNode>(0.0).seed,
                         *m_air,
                         m_scene->air.origin,
                         m_scene->air.cell,
                         m_scene->surrounding,
                         m_scene->solids,
                         m_scene->box,
                         flow ? flow->config : m_scene->flow,
                         flow ? &flow->solver : nullptr,
                         flow ? &m_coupling->rejoining : nullptr,
                         m_cover,
                         flow ? &m_before : nullptr};
    CloudExchange exchange(made, m_state);
    exchange.takeBack(std::exchange(m_coupling->refused, {}));
    const auto begun = std::chrono::steady_clock::now();
    const Result<AirStep> done = exchange.run();
    if (!done) return done.error();
    m_steps.push_back(*done);
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    mergeTimings(context.backend.timings(), all);
    return {};
  }

  /// The grid's own stages, and what is left of the whole for spray and exchange.
  void mergeTimings(StageTimings& timings, double all) {
    double grid = 0.0;
    for (const StageTime& stage : m_air->timings().table()) grid += stage.seconds;
    timings.merge(m_air->timings());
    timings.add("spray and exchange", std::max(all - grid, 0.0));
    m_air->timings().clear();
  }

  std::unique_ptr<CloudScene> m_scene;
  std::unique_ptr<AirSolver> m_air;
  FlowCoupling* m_coupling = nullptr;  ///< in the exchange
  SnowFallout* m_cover = nullptr;      ///< likewise; null without a cover
  CloudState m_state;
  FlowVelocities m_before;       ///< of the part that is under way
  bool m_coupled = false;        ///< the flow's step has taken the air along
  std::vector<AirStep> m_steps;  ///< of the latest frame
};

}  // namespace

ProcessType cloudProcessType() {
  return {"air", 900, sceneHasCloud,
          [] { return std::unique_ptr<Process>(std::make_unique<CloudProcess>()); }};
}

}  // namespace spin
