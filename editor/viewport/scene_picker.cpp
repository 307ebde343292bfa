// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/scene_picker.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/fields/terrain_surface.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

/// Between the ground and the eye: the near plane, and room for some snow.
constexpr double kEyeClearance = 0.5;  // m

/// The corners of the model's box, placed.
Box3d placedBounds(const ModelData& model, const Transform& placement) {
  const Box3d own = model.bounds();
  Box3d box;
  if (own.empty()) return box;
  for (int corner = 0; corner < 8; ++corner)
    box.extend(placement.point({corner & 1 ? own.max.x : own.min.x, corner & 2 ? own.max.y : own.min.y,
                                corner & 4 ? own.max.z : own.min.z}));
  return box;
}

/// The ray in another space; its direction keeps the length that makes t the same in both.
ViewRay mapped(const ViewRay& ray, const Transform& toSpace) {
  return {toSpace.point(ray.origin), toSpace.vector(ray.direction)};
}

Box3d boundsOf(const Mesh& mesh) {
  Box3d box;
  for (const Vec3f& p : mesh.positions) box.extend(p.to<double>());
  return box;
}

std::optional<double> hitMesh(const Mesh& mesh, const Box3d& box, const ViewRay& ray, double nearest) {
  const auto enter = intersectBox(ray, box);
  if (!enter || *enter > nearest) return std::nullopt;
  std::optional<double> best;
  for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
    const auto corner = [&](std::size_t n) { return mesh.positions[mesh.indices[k + n]].to<double>(); };
    const auto t = intersectTriangle(ray, corner(0), corner(1), corner(2));
    if (t && *t < nearest) best = nearest = *t;
  }
  return best;
}

std::optional<double> hitModel(const ModelData& model, const Transform& placement, const ViewRay& ray,
                               double nearest) {
  if (placement.determinant() == 0.0) return std::nullopt;
  std::optional<double> best;
  // A forest has hundreds of instances of a mesh.
  std::vector<Box3d> boxes;
  for (const Mesh& mesh : model.meshes) boxes.push_back(boundsOf(mesh));
  for (const MeshInstance& instance : model.instances) {
    const Transform toLocal = placement * instance.transform;
    if (toLocal.determinant() == 0.0) continue;
    const auto mesh = static_cast<std::size_t>(instance.mesh);
    const auto t = hitMesh(model.meshes[mesh], boxes[mesh], mapped(ray, toLocal.inverse()), nearest);
    if (t) best = nearest = *t;
  }
  return best;
}

/// Flow needs no terrain: its releases on level ground, its sources, and the tank that holds it.
Box3d flowBounds(const SceneSnapshot& scene, double filmTime) {
  Box3d box;
  for (const SceneNode* node : scene.all<AvalancheReleaseNode>()) {
    const auto release = static_cast<const AvalancheReleaseNode&>(*evaluate(*node, filmTime));
    for (const Vec2d& corner : release.outline)
      for (const double z : {0.0, release.depth}) box.extend(Vec3d{corner.x, corner.y, z});
  }
  for (const SceneNode* node : scene.all<WaterSourceNode>()) {
    const auto source = static_cast<const WaterSourceNode&>(*evaluate(*node, filmTime));
    box.extend(source.position);
    if (source.shape == WaterSourceShape::Line) box.extend(source.end);
  }
  if (box.empty()) return box;
  const auto settings = scene.settings<FlowSettingsNode>(filmTime);
  const Vec3d size = settings.domainMax - settings.domainMin;
  if (settings.closed && size.x > 0.0 && size.y > 0.0 && size.z > 0.0) {
    box.extend(settings.domainMin);
    // Tanks are high so that nothing splashes over; one looks at what is in them.
    box.extend(Vec3d{settings.domainMax.x, settings.domainMax.y, box.max.z});
  }
  return box;
}

}  // namespace

std::optional<Vec3d> pickTerrain(const SceneSnapshot& scene, const ViewRay& ray) {
  if (!scene.terrain) return std::nullopt;
  return TerrainSurface(scene.terrain->heights).raycast(ray.origin, ray.direction);
}

std::optional<PickHit> pickScene(const SceneSnapshot& scene, double filmTime, const ViewRay& ray) {
  std::optional<PickHit> hit;
  double nearest = 1e300;
  const SceneNode* terrain = scene.first<TerrainNode>();
  const auto ground = pickTerrain(scene, ray);
  if (terrain && ground) {
    hit = PickHit{terrain->id, *ground};
    nearest = dot(*ground - ray.origin, ray.direction);
  }
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto model = scene.models.find(node->id);
    if (model == scene.models.end() || !model->second) continue;
    const Transform placement = scene.modelTransform(*node, filmTime);
    const auto enter = intersectBox(ray, placedBounds(*model->second, placement));
    if (!enter || *enter > nearest) continue;
    const auto t = hitModel(*model->second, placement, ray, nearest);
    if (!t) continue;
    nearest = *t;
    hit = PickHit{node->id, ray.at(*t)};
  }
  return hit;
}

Box3d nodeBounds(const SceneSnapshot& scene, const std::string& id, double filmTime) {
  Box3d box;
  for (const SceneNode& node : scene.nodes) {
    if (node.id != id) continue;
    if (node.as<TerrainNode>() && scene.terrain) box.extend(boundsOf(scene.terrain->heights));
    const auto model = scene.models.find(id);
    if (node.as<ModelNode>() && model != scene.models.end() && model->second)
      box.extend(placedBounds(*model->second, scene.modelTransform(node, filmTime)));
    if (node.as<CameraNode>()) {
      const RenderCamera camera = cameraOf(scene, filmTime);
      box.extend(camera.position);
      box.extend(camera.target);
    }
  }
  return box;
}

bool showsNothing(const SceneSnapshot& scene) {
  const bool land = scene.terrain && !scene.terrain->heights.empty() && scene.first<TerrainNode>();
  return !land && flowBounds(scene, 0.0).empty() &&
         std::none_of(scene.models.begin(), scene.models.end(),
                      [](const auto& model) { return model.second && !model.second->meshes.empty(); });
}

EyeFloor eyeFloor(const SceneSnapshot& scene) {
  if (!scene.terrain || scene.terrain->heights.empty() || !scene.first<TerrainNode>()) return {};
  return [terrain = scene.terrain](double x, double y) {
    const Raster<float>& h = terrain->heights;
    const double inX = std::clamp(x, h.x(0), h.x(h.width - 1)),
                 inY = std::clamp(y, h.y(0), h.y(h.height - 1));
    const std::optional<double> ground = TerrainSurface(h).heightAt(inX, inY);
    return ground ? *ground + kEyeClearance : std::numeric_limits<double>::lowest();
  };
}

Box3d sceneBounds(const SceneSnapshot& scene, double filmTime) {
  Box3d box;
  if (scene.terrain && scene.first<TerrainNode>())
    box.extend(boundsOf(scene.terrain->heights));
  else
    box.extend(flowBounds(scene, filmTime));
  for (const SceneNode* node : scene.all<ModelNode>()) box.extend(nodeBounds(scene, node->id, filmTime));
  return box;
}

}  // namespace spin
