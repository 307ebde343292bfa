// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/cancel.h"
#include "core/sim/frame_store.h"
#include "core/sim/pipeline.h"

namespace spin {

struct RunOptions {
  int lastFrame = 0;         ///< simulate 0 .. lastFrame; frames that are ready are not computed again
  int threads = 0;           ///< 0 = all
  std::string isa = "auto";  ///< auto | avx512 | avx2 | baseline; part of the backend's name and the keys
  RaySceneFactory makeRayScene = makeBvhRayScene;
  FlowSolverFactory makeFlowSolver = {};  ///< empty: on the processor, with `isa`
  MapRasterFactory makeMapRaster = {};    ///< likewise
  AirSolverFactory makeAirSolver = {};    ///< likewise
  std::string device;                     ///< what these compute on ("cuda-sm90"); part of the keys
  bool lowPriority = false;               ///< leave the processor to the user's window (Runner always does)
  std::vector<ProcessType> types = processTypes();  ///< the processes to choose from
};

struct RunProgress {
  int frame = 0;  ///< frame in work
  int lastFrame = 0;
  int framesDone = 0;         ///< by this run; others were there
  double fractionDone = 0.0;  ///< of the whole run
  double secondsLeft = -1.0;  ///< estimate; < 0 = not known yet
  StageTimings timings;       ///< of the run so far
};

struct RunCallbacks {
  std::function<void(const RunProgress&)> progress;  ///< once per frame and within a frame every 50 ms
  std::function<void(const FramePointer&)> frameReady;
};

/// Need of a run, shown before it starts.
struct RunEstimate {
  double memoryBytes = 0.0;  ///< state, its copy for checkpoints, work, and the frames kept in RAM
  double diskBytes = 0.0;    ///< frames and checkpoints to be written; 0 for a RAM-only store
  double frameBytes = 0.0;   ///< of one frame
  double particles = 0.0;    ///< at most, of all processes
  double seconds = 0.0;      ///< of work, by measured rates; 0 = not known
  int framesToCompute = 0;
};
RunEstimate estimateRun(const SceneSnapshot& scene, FrameStore& store, const RunOptions& options);

/// Simulates in the calling thread into the store: sets the store's keys, continues from the latest
/// checkpoint before the first missing frame. Checkpoints are written every checkpoint_interval frames, every
/// ten seconds of work, and for the last frame done, also when the run is cancelled or fails. Ends early with
/// ErrorKind::Cancelled within a second of cancel. On an error the frames finished so far stay. A value that
/// is not finite in a published frame is an error that names process and part.
Status runSimulation(const SceneSnapshot& scene, FrameStore& store, const RunOptions& options,
                     const RunCallbacks& callbacks, const CancelToken& cancel);

/// Keys of frames 0 .. options.lastFrame as runSimulation() declares them: the backend and the ray caster
/// count.
std::vector<Hash128> frameKeys(const SceneSnapshot& scene, const RunOptions& options);
/// The same on to the last frame that the store holds: a shorter run does not make later frames stale.
std::vector<Hash128> validKeys(const SceneSnapshot& scene, RunOptions options, FrameStore& store);

/// Runs runSimulation() on its own low-priority thread; a new start() cancels the old run and waits for it
/// off the caller's thread. Callbacks come on the runner's thread; they may call start() and cancel(), not
/// wait(). `finished` is called once for every start(), with Cancelled for a run that never began.
class Runner {
 public:
  Runner();
  ~Runner();  ///< cancels and joins
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  void start(SnapshotPointer scene, std::shared_ptr<FrameStore> store, RunOptions options,
             RunCallbacks callbacks, std::function<void(const Status&)> finished);
  void cancel();
  bool running() const;
  /// Blocks until idle (tests, shutdown).
  void wait();

 private:
  class State;
  std::unique_ptr<State> m_state;
};

/// Version of the solver's results; part of every key. Raise it when results change.
inline constexpr const char* kSolverVersion = "10";
/// "cpu-avx512" and so on for the instruction set in use; what this processor cannot run counts as auto.
std::string backendName(const std::string& isa);

}  // namespace spin
