// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/base/cpu_features.h"
#include "core/flow/flow_scene.h"

namespace spin {

/// Need of the flow of a scene over its whole film.
struct FlowEstimate {
  double particles = 0.0;    ///< all that are released and flow in until the last frame
  double workBytes = 0.0;    ///< of the solver while it works, besides states and frames
  double stepSeconds = 0.0;  ///< about, of flow
  std::string node;          ///< that sets the spacing
  bool shears = false;       ///< some material needs the shear rate

  /// Working time of `film` seconds of flow with all particles there, by measured rates of the solver.
  double seconds(double film, Isa isa, int threads) const;
};
FlowEstimate estimateFlow(const SceneSnapshot& scene);
FlowEstimate estimateFlow(const SceneSnapshot& scene, const FlowScene& flow);

/// Bytes of memory of this machine.
double physicalMemory();
/// A fatal issue where the flow's arrays and states take more than `available`, bytes.
std::optional<FlowIssue> memoryIssue(const FlowEstimate& need, double available = physicalMemory());
/// All issues of a scene with flow, that of memory too.
std::vector<FlowIssue> findFlowIssues(const SceneSnapshot& scene);

}  // namespace spin
