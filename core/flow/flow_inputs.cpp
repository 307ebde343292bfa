// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_inputs.h"

#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

template <class T>
void hashAll(const StepInput& input, Hasher& hasher) {
  const double middle = 0.5 * (input.from.film + input.to.film);
  for (const SceneNode* node : input.scene.all<T>())
    for (const double film : {input.from.film, middle, input.to.film})
      input.scene.hashNode(*node, film, hasher);
}

}  // namespace

void hashFlowInputs(const StepInput& input, Hasher& hasher) {
  hasher.add("flow").add(input.from.film).add(input.to.film).add(input.scene.terrain != nullptr);
  hashAll<AvalancheReleaseNode>(input, hasher);
  hashAll<WaterSourceNode>(input, hasher);
  hashAll<FlowSinkNode>(input, hasher);
  hashAll<RigidBodyNode>(input, hasher);
  hashAll<FlowMaterialNode>(input, hasher);
  hashAll<FlowSettingsNode>(input, hasher);
  hashAll<WeatherNode>(input, hasher);
  hashAll<TerrainNode>(input, hasher);
  hashAll<GroundTypeLayerNode>(input, hasher);
  for (const SceneNode* node : input.scene.all<RigidBodyNode>())
    for (const SceneNode* model : input.scene.all<ModelNode>())
      if (const auto* body = node->as<RigidBodyNode>(); body && model->id == body->model)
        input.scene.hashNode(*model, input.to.film, hasher);
}

}  // namespace spin
