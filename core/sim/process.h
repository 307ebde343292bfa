// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <vector>

#include "core/base/cancel.h"
#include "core/base/cpu_features.h"
#include "core/base/parallel.h"
#include "core/fields/ray_scene.h"
#include "core/sim/frame.h"
#include "core/sim/snapshot.h"

namespace spin {

struct FlowConfig;
class FlowSolver;
/// Makes the particle solver on the device that a run was asked for; empty: on the processor.
using FlowSolverFactory = std::function<Result<std::unique_ptr<FlowSolver>>(const FlowConfig&)>;

struct AirConfig;
class AirSolver;
/// Likewise the solver of what hangs in the air.
using AirSolverFactory = std::function<Result<std::unique_ptr<AirSolver>>(const AirConfig&)>;

class MapRaster;
class Occluders;
/// Makes what draws occlusion maps on that device; empty, or null made: on the processor.
using MapRasterFactory = std::function<std::unique_ptr<MapRaster>(const Occluders&)>;

/// What processes hand to each other within a step, by type: the exposure to the cover, the weather to all.
class Exchange {
 public:
  template <class T>
  T& emplace(T value = T{}) {
    auto held = std::make_shared<T>(std::move(value));
    m_items[typeid(T)] = held;
    return *held;
  }
  /// nullptr if nobody put one.
  template <class T>
  T* find() {
    const auto it = m_items.find(typeid(T));
    return it == m_items.end() ? nullptr : static_cast<T*>(it->second.get());
  }

 private:
  std::map<std::type_index, std::shared_ptr<void>> m_items;
};

/// Machinery that a step may use; nothing of the document.
struct ProcessContext {
  CpuBackend& backend;
  const RaySceneFactory& makeRayScene;
  const CancelToken& cancel;
  Exchange& exchange;
  std::function<void(double)> progress;  ///< fraction 0..1 of the current step; may be empty
  Isa isa = bestIsa();                   ///< instruction set of hot loops
  FlowSolverFactory makeFlowSolver = {};
  MapRasterFactory makeMapRaster = {};
  AirSolverFactory makeAirSolver = {};
};

/// A step from one frame to the next.
struct StepInput {
  const SceneSnapshot& scene;
  FrameTime from;
  FrameTime to;
};

/// What computing takes, besides states and frames.
struct WorkEstimate {
  double bytes = 0.0;      ///< memory while it works
  double particles = 0.0;  ///< at most
  double seconds = 0.0;    ///< of work for the scene's whole film, by measured rates; 0 = not worth telling
};

/// One part of the simulation. It owns its state; the runner calls begin() for frame 0, then step() frame by
/// frame, in the pipeline's order. A long stage checks context.cancel at least every 100 ms and returns
/// ErrorKind::Cancelled.
class Process {
 public:
  virtual ~Process() = default;
  virtual const char* id() const = 0;
  /// Everything that this process's step from..to depends on.
  virtual void hashInputs(const StepInput& input, Hasher& hasher) const = 0;
  virtual Status begin(const SceneSnapshot& scene, ProcessContext& context) = 0;
  virtual Status step(const StepInput& input, ProcessContext& context) = 0;
  /// Puts this process's parts, budget terms and figures into the frame.
  virtual void publish(const SceneSnapshot& scene, const FrameTime& time, Frame& frame) const = 0;
  virtual void saveState(ByteWriter& out) const = 0;
  /// Called instead of begin() when resuming at a checkpoint of the same scene.
  virtual Status loadState(const SceneSnapshot& scene, ProcessContext& context, ByteReader& in) = 0;
  /// Rough need, for the estimate before a run: bytes of state, bytes per frame.
  virtual void estimate(const SceneSnapshot& scene, double& stateBytes, double& frameBytes) const = 0;
  virtual WorkEstimate estimateWork(const SceneSnapshot&, Isa, int /*threads*/) const { return {}; }
};

/// How the pipeline knows a process: in which scenes it runs and where in the order.
struct ProcessType {
  const char* id;
  int order;  ///< weather 100, fall 200, exposure 300, cover 400, melt 500, release 600, flow 700, rigid 800,
              ///< air 900, deposit 1000
  bool (*needed)(const SceneSnapshot& scene);
  std::unique_ptr<Process> (*create)();
};

}  // namespace spin
