// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/scatter_brush.h"

#include <algorithm>

#include "core/fields/terrain_surface.h"
#include "core/nodes/terrain_node.h"
#include "core/sim/model_copies.h"

namespace spin {

const SceneNode* modelToCopy(const SceneSnapshot& scene, const std::string& id) {
  const std::vector<const SceneNode*> models = scene.all<ModelNode>();
  for (const SceneNode* node : models)
    if (node->id == id) return node;
  return models.empty() ? nullptr : models.front();
}

void ScatterBrush::setNode(std::string id) {
  if (!scattering()) m_node = std::move(id);
}

void ScatterBrush::setDensity(double perSquareMetre) {
  m_density = std::clamp(perSquareMetre, kLeastDensity, kMostDensity);
}

void ScatterBrush::setDistance(double metres) {
  m_distance = std::clamp(metres, 0.0, kMostCopyDistance);
}

bool ScatterBrush::begin(const ViewportContext& context, Vec2d place, double radius, bool erase,
                         PlanPoints copies) {
  if (!context.scene || !context.scene->terrain) return false;
  const SceneNode* node = modelToCopy(*context.scene, m_node);
  if (!node || node->id != m_node) return false;
  const auto evaluated = evaluate(*node, 0.0);
  const auto& model = static_cast<const ModelNode&>(*evaluated);
  ScatterTask task;
  task.erase = erase;
  task.radius = radius;
  task.density = m_density;
  task.distance = m_distance;
  task.seed = static_cast<std::uint64_t>(model.copySeed);
  task.most = kMostCopies;
  task.own = {model.position.x, model.position.y};
  task.isGround = [terrain = context.scene->terrain](Vec2d p) {
    return TerrainSurface(terrain->heights).heightAt(p.x, p.y).has_value();
  };
  m_stroke.emplace(std::move(copies), std::move(task));
  m_stroke->moveTo(place);
  return true;
}

}  // namespace spin
