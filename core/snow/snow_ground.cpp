// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_ground.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/units.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/snow/snow_inputs.h"

namespace spin {

const SceneNode& nodeOf(const SceneSnapshot& scene, const ModelGround& model) {
  const auto found = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                  [&](const SceneNode& n) { return n.id == model.node; });
  SPIN_CHECK(found != scene.nodes.end(), "the snow ground is of another scene");
  return *found;
}

std::vector<PlacedTriangle> placedTriangles(const ModelData& model, const Transform& placement) {
  std::vector<PlacedTriangle> triangles;
  triangles.reserve(model.triangleCount());
  Transform turn = placement;
  turn.translation = {};
  for (const MeshInstance& instance : model.instances) {
    const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
    const Transform toPlace = turn * instance.transform;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
      PlacedTriangle triangle;
      for (std::size_t c = 0; c < 3; ++c)
        triangle.corners[c] = toPlace.point(mesh.positions[mesh.indices[k + c]].to<double>()).to<float>();
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

SnowGroundPointer makeSnowGround(const SceneSnapshot& scene) {
  auto ground = std::make_shared<SnowGround>();
  auto layout = std::make_shared<CoverLayout>();
  addTerrainGrids(scene, *layout, *ground);
  const auto settings = scene.settings<SimulationNode>(0.0);
  const double shedsAbove = std::max(settings.shedsAboveDegrees, settings.holdsBelowDegrees);
  // A surface just at the angle still counts: level roofs hold snow where level ground does. Walls never do.
  const double minUpward = std::max(std::cos(degreesToRadians(shedsAbove)) - 1e-9, kLeastUpward);
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto found = scene.models.find(node->id);
    if (found == scene.models.end() || !found->second) continue;
    const auto evaluated = evaluate(*node, 0.0);
    const auto& data = static_cast<const ModelNode&>(*evaluated);
    ModelGround model;
    model.node = node->id;
    model.turns = modelTurns(*node);
    model.triangles = placedTriangles(*found->second, scene.modelTransform(*node, 0.0));
    if (data.catchesSnow && !model.turns)
      addModelPatches(model, data.coverCell, minUpward, *layout, ground->messages);
    else
      leaveBare(model);
    if (data.catchesSnow && model.turns)
      ground->messages.push_back("Model '" + node->id +
                                 "' turns or changes size during the film, so no snow stays on it");
    ground->models.push_back(std::move(model));
  }
  ground->layout = std::move(layout);
  return ground;
}

}  // namespace spin
