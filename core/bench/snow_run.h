// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "core/sim/pipeline.h"

namespace spin {

/// Steps a scene's processes frame by frame without a frame store, for cases and tests that look inside.
class SnowRun {
 public:
  SnowRun(const SnowRun&) = delete;
  SnowRun& operator=(const SnowRun&) = delete;
  SnowRun(const SceneSnapshot& scene, RaySceneFactory makeRayScene, int threads = 0)
      : m_scene(scene),
        m_makeRayScene(std::move(makeRayScene)),
        m_backend(threads),
        m_pipeline(Pipeline::compile(scene)) {}

  Status begin() {
    m_frame = 0;
    for (const auto& process : m_pipeline.processes())
      if (Status status = process->begin(m_scene, m_context); !status) return status;
    return {};
  }
  Status step() {
    const StepInput input{m_scene, m_scene.timeOf(m_frame), m_scene.timeOf(m_frame + 1)};
    for (const auto& process : m_pipeline.processes())
      if (Status status = process->step(input, m_context); !status) return status;
    ++m_frame;
    return {};
  }
  /// begin() and `frames` steps.
  Status run(int frames) {
    Status status = begin();
    for (int f = 0; f < frames && status; ++f) status = step();
    return status;
  }
  Frame frame() const {
    Frame frame;
    frame.info.time = m_scene.timeOf(m_frame);
    for (const auto& process : m_pipeline.processes()) process->publish(m_scene, frame.info.time, frame);
    return frame;
  }
  std::vector<char> save() const {
    ByteWriter out;
    for (const auto& process : m_pipeline.processes()) process->saveState(out);
    return out.take();
  }
  Status load(int frame, const std::vector<char>& state) {
    m_frame = frame;
    ByteReader in(state.data(), state.size());
    for (const auto& process : m_pipeline.processes())
      if (Status status = process->loadState(m_scene, m_context, in); !status) return status;
    return {};
  }
  CancelToken& cancel() { return m_cancel; }
  CpuBackend& backend() { return m_backend; }
  Exchange& exchange() { return m_pipeline.exchange(); }

 private:
  const SceneSnapshot& m_scene;
  RaySceneFactory m_makeRayScene;
  CpuBackend m_backend;
  CancelToken m_cancel;
  Pipeline m_pipeline;
  ProcessContext m_context{m_backend, m_makeRayScene, m_cancel, m_pipeline.exchange(), {}};
  int m_frame = 0;
};

}  // namespace spin
