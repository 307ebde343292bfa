// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <optional>

#include "core/base/cpu_features.h"
#include "core/base/log.h"
#include "core/nodes/settings_nodes.h"
#include "core/sim/runner.h"
#include "core/sim/thread_priority.h"

namespace spin {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kProgressSeconds = 0.05;
/// Frames beyond that are stale after any run.
constexpr int kMostKeys = 100'000;
/// So that a killed process loses little.
constexpr double kCheckpointSeconds = 10.0;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Error cancelledError(int frame) {
  return {ErrorKind::Cancelled, "The simulation was cancelled", fmt::format("frame {}", frame),
          "the user stopped it", "Finished frames are kept; the next run continues from them"};
}

/// The state after a frame, as bytes.
struct SavedState {
  int frame = -1;
  std::vector<char> bytes;
};

/// One call of runSimulation().
class SimulationRun {
 public:
  SimulationRun(const SceneSnapshot& scene, FrameStore& store, const RunOptions& options,
                const RunCallbacks& callbacks, const CancelToken& cancel)
      : m_scene(scene),
        m_store(store),
        m_options(options),
        m_callbacks(callbacks),
        m_cancel(cancel),
        m_backend(options.threads),
        m_isa(chooseIsa(options.isa) ? *chooseIsa(options.isa) : bestIsa()),
        m_backendName(backendName(options.isa) + (options.device.empty() ? "" : "+" + options.device)),
        m_pipeline(Pipeline::compile(scene, options.types)),
        m_settings(scene.settings<SimulationNode>(0.0)) {
    if (options.lowPriority) m_lowPriority.emplace(m_backend.arena());
  }

  Status run();

 private:
  Status advanceTo(int frame);
  Status resumeBefore(int frame);
  bool loadCheckpoint(const FrameStore::Checkpoint& checkpoint);
  Status compute(int frame);
  Status publish(int frame);
  Status publishProcess(const Process& process, const FrameTime& time, Frame& frame) const;
  void rememberState();
  Status writeCheckpoint();
  void report(double fractionOfFrame, bool always);
  ProcessContext context();
  void discardState();

  const SceneSnapshot& m_scene;
  FrameStore& m_store;
  const RunOptions& m_options;
  const RunCallbacks& m_callbacks;
  const CancelToken& m_cancel;
  CpuBackend m_backend;
  std::optional<LowPriorityArena> m_lowPriority;
  Isa m_isa;
  std::string m_backendName;
  Pipeline m_pipeline;
  SimulationNode m_settings;
  std::vector<Hash128> m_keys;

  int m_frame = -1;       ///< frame of the processes' state, -1 = none
  int m_target = 0;       ///< frame in work
  SavedState m_saved;     ///< of the last frame done
  int m_checkpoint = -1;  ///< frame of the last checkpoint on disk in this run
  Clock::time_point m_lastCheckpoint = Clock::now();
  Clock::time_point m_lastReport{};
  int m_framesTotal = 0;  ///< missing at the start
  int m_framesDone = 0;
  int m_stepsDone = 0;  ///< steps but frame 0, for the time left
  double m_stepSeconds = 0.0;
  StageTimings m_timings;
};

ProcessContext SimulationRun::context() {
  return {m_backend,
          m_options.makeRayScene,
          m_cancel,
          m_pipeline.exchange(),
          [this](double fraction) { report(fraction, false); },
          m_isa,
          m_options.makeFlowSolver,
          m_options.makeMapRaster,
          m_options.makeAirSolver};
}

void SimulationRun::discardState() {
  m_pipeline = Pipeline::compile(m_scene, m_options.types);
  m_frame = -1;
}

Status SimulationRun::run() {
  m_keys = validKeys(m_scene, m_options, m_store);
  m_store.setKeys(m_keys);
  const std::vector<FrameState> states = m_store.states(m_options.lastFrame + 1);
  const auto missing = [](FrameState state) { return state != FrameState::Ready; };
  m_framesTotal = static_cast<int>(std::count_if(states.begin(), states.end(), missing));
  Status status;
  for (int frame = 0; frame <= m_options.lastFrame && status; ++frame)
    if (missing(states[static_cast<std::size_t>(frame)])) status = advanceTo(frame);
  // The state of the last frame done lets the next run go on there, however this one ended.
  const Status saved = writeCheckpoint();
  return status ? saved : status;
}

/// Brings the state to a missing frame and publishes it.
Status SimulationRun::advanceTo(int frame) {
  if (Status resumed = resumeBefore(frame); !resumed) return resumed;
  while (m_frame < frame)
    if (Status done = compute(m_frame + 1); !done) return done;
  return {};
}

/// Takes the latest checkpoint before the frame if that is nearer than the state at hand.
Status SimulationRun::resumeBefore(int frame) {
  if (m_frame == frame - 1) return {};
  for (int before = frame - 1; before > m_frame;) {
    const auto checkpoint = m_store.latestCheckpoint(before);
    if (!checkpoint || checkpoint->frame <= m_frame) return {};
    if (loadCheckpoint(*checkpoint)) return {};
    if (m_cancel.cancelled()) return cancelledError(frame);
    before = checkpoint->frame - 1;
  }
  return {};
}

bool SimulationRun::loadCheckpoint(const FrameStore::Checkpoint& checkpoint) {
  discardState();
  m_target = checkpoint.frame;
  ByteReader in(checkpoint.state.data(), checkpoint.state.size());
  ProcessContext c = context();
  for (const auto& process : m_pipeline.processes()) {
    const std::string id = in.getText();
    const std::vector<char> bytes = in.getArray<char>();
    ByteReader state(bytes.data(), bytes.size());
    Status loaded;
    if (in.ok() && id == process->id()) loaded = process->loadState(m_scene, c, state);
    if (in.ok() && id == process->id() && loaded && state.ok()) continue;
    const bool cancelled = !loaded && loaded.error().kind == ErrorKind::Cancelled;
    if (!cancelled)
      logWarning(
          fmt::format("The checkpoint of frame {} cannot be used (process {}); going on from an earlier one",
                      checkpoint.frame, process->id()));
    discardState();
    return false;
  }
  m_frame = m_checkpoint = checkpoint.frame;
  m_saved = {};
  return true;
}

/// Steps every process from frame - 1 to frame (begins at frame 0) and publishes what is missing.
Status SimulationRun::compute(int frame) {
  if (m_cancel.cancelled()) return cancelledError(frame);
  m_target = frame;
  m_backend.timings().clear();
  report(0.0, true);
  const auto start = Clock::now();
  const FrameTime to = m_scene.timeOf(frame);
  const StepInput input{m_scene, m_scene.timeOf(std::max(frame - 1, 0)), to};
  ProcessContext c = context();
  m_frame = -1;
  for (const auto& process : m_pipeline.processes()) {
    if (frame > 0 && isPaused(m_scene, *process, to.film)) continue;
    const Status done = frame == 0 ? process->begin(m_scene, c) : process->step(input, c);
    if (!done) return done;
    if (m_cancel.cancelled()) return cancelledError(frame);
  }
  if (m_store.state(frame) != FrameState::Ready) {
    if (Status published = publish(frame); !published) return published;
    ++m_framesDone;
  }
  m_frame = frame;
  rememberState();
  if (frame > 0) {
    ++m_stepsDone;
    m_stepSeconds += secondsSince(start);
  }
  const bool due =
      frame % m_settings.checkpointInterval == 0 || secondsSince(m_lastCheckpoint) > kCheckpointSeconds;
  if (due && frame > 0)
    if (Status written = writeCheckpoint(); !written) return written;
  report(1.0, true);
  return {};
}

Status SimulationRun::publish(int frame) {
  auto result = std::make_shared<Frame>();
  result->info.time = m_scene.timeOf(frame);
  result->info.key = m_keys[static_cast<std::size_t>(frame)];
  result->info.solverVersion = std::string(kSolverVersion);
  result->info.backend = m_backendName;
  result->info.seed = m_settings.seed;
  for (const auto& process : m_pipeline.processes())
    if (Status done = publishProcess(*process, result->info.time, *result); !done) return done;
  result->info.timings = m_backend.timings();
  const auto start = Clock::now();
  if (Status kept = m_store.put(result); !kept) return kept;
  m_timings.merge(result->info.timings);
  m_timings.add("store", secondsSince(start));
  if (m_callbacks.frameReady) m_callbacks.frameReady(result);
  return {};
}

/// Publishes one process's share and checks what it added.
Status SimulationRun::publishProcess(const Process& process, const FrameTime& time, Frame& frame) const {
  const auto before = frame.parts;
  process.publish(m_scene, time, frame);
  const auto failed = [&](const std::string& what, const std::string& why) {
    return Error{
        ErrorKind::Failed, "The simulation produced a value that is not finite",
        fmt::format("frame {}, process {}, {}", time.frame, process.id(), what), why,
        "The frames before it are kept; look for extreme settings of the nodes that feed this process"};
  };
  for (const auto& [name, part] : frame.parts) {
    const auto old = before.find(name);
    if (old != before.end() && old->second == part) continue;
    if (const std::string bad = part->firstNonFinite(); !bad.empty())
      return failed(fmt::format("part {}", name), bad);
  }
  for (const BudgetTerm& term : frame.info.budget.terms)
    if (!std::isfinite(term.kilograms))
      return failed("mass budget", fmt::format("{} is {} kg", term.name, term.kilograms));
  for (const auto& [name, value] : frame.info.figures)
    if (!std::isfinite(value)) return failed("figures", fmt::format("{} is {}", name, value));
  return {};
}

/// Keeps the state in RAM: when a cancel breaks a step half-way, the processes' own state is lost.
void SimulationRun::rememberState() {
  ByteWriter out;
  for (const auto& process : m_pipeline.processes()) {
    ByteWriter state;
    process->saveState(state);
    out.put(std::string(process->id()));
    out.putArray(state.bytes());
  }
  m_saved = {m_frame, out.take()};
}

Status SimulationRun::writeCheckpoint() {
  if (m_saved.frame <= 0 || m_saved.frame == m_checkpoint) return {};
  const auto start = Clock::now();
  const Status written =
      m_store.putCheckpoint(m_saved.frame, m_keys[static_cast<std::size_t>(m_saved.frame)], m_saved.bytes);
  m_timings.add("checkpoint", secondsSince(start));
  m_checkpoint = m_saved.frame;
  m_lastCheckpoint = Clock::now();
  return written;
}

void SimulationRun::report(double fractionOfFrame, bool always) {
  if (!m_callbacks.progress) return;
  if (!always && secondsSince(m_lastReport) < kProgressSeconds) return;
  m_lastReport = Clock::now();
  RunProgress progress;
  progress.frame = m_target;
  progress.lastFrame = m_options.lastFrame;
  progress.framesDone = m_framesDone;
  // A frame that is finished is counted already.
  const double inWork = fractionOfFrame < 1.0 ? fractionOfFrame : 0.0;
  const int total = std::max(m_framesTotal, 1);
  progress.fractionDone = std::clamp((m_framesDone + inWork) / total, 0.0, 1.0);
  if (m_stepsDone > 0)
    progress.secondsLeft = (m_framesTotal - m_framesDone - inWork) * m_stepSeconds / m_stepsDone;
  progress.timings = m_timings;
  m_callbacks.progress(progress);
}

}  // namespace

std::string backendName(const std::string& isa) {
  const Result<Isa> chosen = chooseIsa(isa);
  return fmt::format("cpu-{}", isaName(chosen ? *chosen : bestIsa()));
}

std::vector<Hash128> frameKeys(const SceneSnapshot& scene, const RunOptions& options) {
  const std::string caster = options.makeRayScene ? options.makeRayScene()->name() : "none";
  std::string backend = fmt::format("{}+{}", backendName(options.isa), caster);
  if (!options.device.empty()) backend += "+" + options.device;
  return frameKeys(scene, Pipeline::compile(scene, options.types), backend, options.lastFrame);
}

std::vector<Hash128> validKeys(const SceneSnapshot& scene, RunOptions options, FrameStore& store) {
  options.lastFrame = std::max(options.lastFrame, std::min(store.lastFrame(), kMostKeys));
  return frameKeys(scene, options);
}

RunEstimate estimateRun(const SceneSnapshot& scene, FrameStore& store, const RunOptions& options) {
  const Pipeline pipeline = Pipeline::compile(scene, options.types);
  const std::vector<Hash128> keys = frameKeys(scene, options);
  RunEstimate estimate;
  for (std::size_t frame = 0; frame < keys.size(); ++frame)
    if (!store.has(static_cast<int>(frame), keys[frame])) ++estimate.framesToCompute;
  double stateBytes = 0.0, frameBytes = 0.0, seconds = 0.0, workBytes = 0.0;
  const Result<Isa> isa = chooseIsa(options.isa);
  for (const auto& process : pipeline.processes()) {
    double ofState = 0.0, ofFrame = 0.0;
    process->estimate(scene, ofState, ofFrame);
    stateBytes += ofState;
    frameBytes += ofFrame;
    const WorkEstimate work =
        process->estimateWork(scene, isa ? *isa : bestIsa(), CpuBackend(options.threads).threads());
    workBytes += work.bytes;
    seconds += work.seconds;
    estimate.particles += work.particles;
  }
  const SimulationNode settings = scene.settings<SimulationNode>(0.0);
  const int interval = settings.checkpointInterval;
  estimate.frameBytes = frameBytes;
  const int frames = estimate.framesToCompute;
  estimate.seconds = seconds * frames / std::max(settings.lastFrame + 1, 1);
  const double kept = std::min(frames * frameBytes, static_cast<double>(store.options().memoryBudget));
  if (frames == 0) return estimate;
  estimate.memoryBytes = 2.0 * stateBytes + workBytes + kept;
  if (!store.options().directory.empty())
    estimate.diskBytes = frames * frameBytes + (1 + frames / interval) * stateBytes;
  return estimate;
}

Status runSimulation(const SceneSnapshot& scene, FrameStore& store, const RunOptions& options,
                     const RunCallbacks& callbacks, const CancelToken& cancel) {
  if (options.lastFrame < 0)
    return Error{ErrorKind::Usage, "The simulation cannot start", "last frame",
                 fmt::format("{} is negative", options.lastFrame), "Choose 0 or more"};
  if (const Result<Isa> isa = chooseIsa(options.isa); !isa) return isa.error();
  try {
    return SimulationRun(scene, store, options, callbacks, cancel).run();
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResources, "The simulation stopped", "", "there is not enough memory",
                 "Close other programs, or choose coarser cells and fewer flakes"};
  }
}

}  // namespace spin
