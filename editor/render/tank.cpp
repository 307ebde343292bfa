// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/tank.h"

#include <algorithm>
#include <array>

#include "core/nodes/flow_nodes.h"
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

/// Shares of the longest side: thickness of the bars, and how far the floor reaches beyond the walls.
constexpr double kBar = 0.006, kRim = 0.02;

/// Six faces with corners of their own, so that they are flat.
void addBox(const Box3d& box, Mesh& mesh) {
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  constexpr Vec3f kNormals[6] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  for (std::size_t face = 0; face < 6; ++face) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const int corner : kFaces[face]) {
      const Vec3d p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                    corner & 4 ? box.max.z : box.min.z};
      mesh.positions.push_back(p.to<float>());
      mesh.normals.push_back(kNormals[face]);
    }
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }
}

Mesh floorOf(const Box3d& room, double longest) {
  Mesh mesh;
  const Vec3d rim{kRim * longest, kRim * longest, 0.0};
  Box3d box;
  box.extend(room.min - rim - Vec3d{0, 0, kRim * longest});
  box.extend(Vec3d{room.max.x, room.max.y, room.min.z} + rim);
  addBox(box, mesh);
  return mesh;
}

/// Outside of the walls, so that nothing that flows goes through them.
Mesh barsOf(const Box3d& room, double longest) {
  Mesh mesh;
  mesh.material = 1;
  const double t = kBar * longest;
  const std::array<double, 2> x{room.min.x - t, room.max.x}, y{room.min.y - t, room.max.y};
  const auto bar = [&](Vec3d low, Vec3d high) {
    Box3d box;
    box.extend(low);
    box.extend(high);
    addBox(box, mesh);
  };
  for (const double a : x)
    for (const double b : y) bar({a, b, room.min.z}, {a + t, b + t, room.max.z + t});
  for (const double b : y) bar({x[0], b, room.max.z}, {x[1] + t, b + t, room.max.z + t});
  for (const double a : x) bar({a, y[0], room.max.z}, {a + t, y[1] + t, room.max.z + t});
  return mesh;
}

std::shared_ptr<const ModelData> tankModel(const Box3d& room) {
  const Vec3d size = room.size();
  const double longest = std::max({size.x, size.y, size.z});
  auto model = std::make_shared<ModelData>();
  model->materials.push_back({"floor", {0.42f, 0.42f, 0.41f, 1.0f}});
  model->materials.push_back({"bars", {0.11f, 0.12f, 0.13f, 1.0f}});
  model->meshes = {floorOf(room, longest), barsOf(room, longest)};
  model->instances = {{0, {}}, {1, {}}};
  return model;
}

}  // namespace

SnapshotPointer withTank(const SnapshotPointer& scene) {
  if (!scene || scene->terrain) return scene;
  const SceneNode* node = scene->first<FlowSettingsNode>();
  const auto* flow = node ? node->as<FlowSettingsNode>() : nullptr;
  if (!flow || !flow->closed) return scene;
  const Vec3d size = flow->domainMax - flow->domainMin;
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) return scene;
  Box3d room;
  room.extend(flow->domainMin);
  // Domains are high so that nothing splashes over; bars to their top would look like a swing.
  const double high = std::min(size.z, 0.5 * std::max(size.x, size.y));
  room.extend(Vec3d{flow->domainMax.x, flow->domainMax.y, flow->domainMin.z + high});
  auto shown = std::make_shared<SceneSnapshot>(*scene);
  // No id that a scene may have contains a blank.
  SceneNode tank = makeNode(kModelType, "flow tank", "tank");
  auto data = std::make_shared<ModelNode>();
  data->onGround = false;
  data->catchesSnow = false;
  tank.data = data;
  shown->models["flow tank"] = tankModel(room);
  shown->nodes.push_back(std::move(tank));
  return shown;
}

}  // namespace spin
