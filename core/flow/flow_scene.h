// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/flow/release_area.h"
#include "core/nodes/flow_nodes.h"
#include "core/sim/snapshot.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// Something about flow in a scene that a user should know. `fatal` keeps flow from starting.
struct FlowIssue {
  std::string node;
  std::string text;
  bool fatal = false;
};

/// A release as the solver needs it.
struct FlowRelease {
  const SceneNode* node = nullptr;
  AvalancheReleaseNode data;  ///< at film time 0
  std::uint8_t material = 0;  ///< index into FlowConfig::materials
  double particles = 0.0;     ///< about
  int layers = 0;             ///< per slab depth
};

/// A source as the solver needs it; where and how fast is asked for frame by frame.
struct FlowInflow {
  const SceneNode* node = nullptr;
  std::uint8_t material = 0;
};

/// A model that the solver moves: what to add to its motion to place the model.
struct FlowBody {
  std::string model;    ///< id of the model node
  Transform placement;  ///< of the model at film time 0
  Vec3d centre{};       ///< of mass then, local m
  bool kinematic = false;
};

/// Everything about flow in a scene. Refers to the snapshot, which must outlive it.
struct FlowScene {
  FlowConfig config;
  std::vector<FlowRelease> releases;
  std::vector<FlowInflow> inflows;
  std::vector<FlowBody> bodies;  ///< as FlowConfig::bodies
  double fastest = 0.0;          ///< m/s, to be expected
  std::vector<FlowIssue> issues;

  const FlowIssue* fatal() const;
};

/// Whether there is an enabled release or source.
bool sceneHasFlow(const SceneSnapshot& scene);
/// Places and domain are those at film time 0; wind, sinks and friction those at `filmTime`.
/// Without `withBodies` models are left out, which saves their fields where only numbers are asked for.
FlowScene makeFlowScene(const SceneSnapshot& scene, double filmTime, bool withBodies = true);
/// Only what may change while flow is simulated, into a configuration of the same scene.
void updateFlowConfig(const SceneSnapshot& scene, double filmTime, FlowConfig& config);
/// Position on the ground (or as it is) of one of a source's points.
Vec3d sourcePoint(const SceneSnapshot& scene, const WaterSourceNode& source, Vec3d point);

}  // namespace spin
