// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sim/pipeline.h"

#include <algorithm>
#include <string_view>

#include "core/nodes/settings_nodes.h"
#include "core/sim/runner.h"

namespace spin {

Pipeline Pipeline::compile(const SceneSnapshot& scene, const std::vector<ProcessType>& types) {
  std::vector<const ProcessType*> needed;
  for (const ProcessType& type : types)
    if (type.needed(scene)) needed.push_back(&type);
  std::stable_sort(needed.begin(), needed.end(),
                   [](const ProcessType* a, const ProcessType* b) { return a->order < b->order; });
  Pipeline pipeline;
  for (const ProcessType* type : needed) pipeline.m_processes.push_back(type->create());
  return pipeline;
}

bool isPaused(const SceneSnapshot& scene, const Process& process, double filmTime) {
  const SimulationNode settings = scene.settings<SimulationNode>(filmTime);
  const std::string_view id = process.id();
  if (id == "air") return settings.pauseAir;
  const bool flows = id == "flow" || id == "rigid";
  return flows ? settings.pauseFlow : settings.pauseSnow;
}

std::vector<Hash128> frameKeys(const SceneSnapshot& scene, const Pipeline& pipeline,
                               const std::string& backendName, int lastFrame) {
  const SimulationNode settings = scene.settings<SimulationNode>(0.0);
  std::vector<Hash128> keys;
  FrameTime from = scene.timeOf(0);
  for (int frame = 0; frame <= lastFrame; ++frame) {
    const FrameTime to = scene.timeOf(frame);
    Hasher hasher;
    if (frame == 0)
      hasher.add(kSolverVersion).add(std::string_view(backendName)).add(settings.seed);
    else
      hasher.add(keys.back());
    // Times stand for frame rate and time scale.
    hasher.add(to.frame).add(to.film).add(to.weather);
    for (const auto& process : pipeline.processes()) {
      hasher.add(process->id());
      if (frame > 0 && isPaused(scene, *process, to.film))
        hasher.add("paused");
      else
        process->hashInputs({scene, from, to}, hasher);
    }
    keys.push_back(hasher.digest());
    from = to;
  }
  return keys;
}

}  // namespace spin
