// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/scene_bodies.h"

#include <algorithm>
#include <cmath>

#include "core/flow/flow_walls.h"
#include "core/nodes/terrain_node.h"
#include "core/sim/bodies_part.h"

namespace spin {
namespace {

/// All triangles of a model where it stands.
TriangleMesh placedTriangles(const ModelData& model, const Transform& placement) {
  TriangleMesh all;
  for (const MeshInstance& instance : model.instances) {
    const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
    const Transform place = placement * instance.transform;
    const auto first = static_cast<std::uint32_t>(all.positions.size());
    for (const Vec3f& p : mesh.positions) all.positions.push_back(place.point(p.to<double>()));
    // A mirror turns the triangles inside out.
    const std::size_t second = place.determinant() < 0.0 ? 2 : 1;
    for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3)
      for (const std::size_t corner : {std::size_t{0}, second, 3 - second})
        all.indices.push_back(first + mesh.indices[k + corner]);
  }
  return all;
}

/// The surface with this friction; a new one where there is none yet and room for it.
std::uint8_t bodySurface(FlowWallsConfig& walls, double friction) {
  WallSurface surface;
  surface.friction = WallFriction::Coulomb;
  surface.tangent = static_cast<float>(friction);
  for (std::size_t k = kFirstBodySurface; k < walls.surfaces.size(); ++k)
    if (walls.surfaces[k].tangent == surface.tangent) return static_cast<std::uint8_t>(k);
  if (walls.surfaces.size() == kMostSurfaces) return static_cast<std::uint8_t>(kMostSurfaces - 1);
  walls.surfaces.push_back(surface);
  return static_cast<std::uint8_t>(walls.surfaces.size() - 1);
}

Transform transformOf(const Quaternion& q, Vec3d translation) {
  Transform t;
  const Vec3d axes[3] = {q.rotate({1, 0, 0}), q.rotate({0, 1, 0}), q.rotate({0, 0, 1})};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      t.linear[static_cast<std::size_t>(3 * row + column)] = axes[column][row];
  t.translation = translation;
  return t;
}

/// Of a rotation matrix by rows (Shepperd 1978).
Quaternion quaternionOf(const std::array<double, 9>& m) {
  const double trace = m[0] + m[4] + m[8];
  const double parts[4] = {trace, m[0], m[4], m[8]};
  const auto largest = std::max_element(parts, parts + 4) - parts;
  Quaternion q;
  if (largest == 0)
    q = {1.0 + trace, m[7] - m[5], m[2] - m[6], m[3] - m[1]};
  else if (largest == 1)
    q = {m[7] - m[5], 1.0 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6]};
  else if (largest == 2)
    q = {m[2] - m[6], m[1] + m[3], 1.0 - m[0] + m[4] - m[8], m[5] + m[7]};
  else
    q = {m[3] - m[1], m[2] + m[6], m[5] + m[7], 1.0 - m[0] - m[4] + m[8]};
  return normalized(q);
}

/// Of the two quaternions of a rotation that with the angle up to half a turn.
Quaternion shorter(const Quaternion& q) {
  return q.w < 0.0 ? Quaternion{-q.w, -q.x, -q.y, -q.z} : q;
}

void addBody(const RigidBodyNode& body, const std::string& node, const TriangleMesh& mesh,
             const Transform& placement, FlowScene& flow) {
  const auto shape = makeRigidShape(mesh);
  if (!shape) {
    flow.issues.push_back({node, shape.error().text(), true});
    return;
  }
  RigidBodyConfig made;
  made.shape = *shape;
  made.density = body.density;
  made.friction = body.friction;
  made.restitution = body.restitution;
  made.kinematic = body.motion == RigidMotion::Kinematic;
  made.surface = bodySurface(flow.config.walls, body.friction);
  made.start.position = made.shape->mass.centre;
  if (!made.kinematic) {
    made.start.velocity = body.velocity;
    made.start.angularVelocity = body.spin;
  }
  flow.bodies.push_back({body.model, placement, made.shape->mass.centre, made.kinematic});
  flow.config.bodies.push_back(std::move(made));
}

}  // namespace

void addSceneBodies(const SceneSnapshot& scene, FlowScene& flow) {
  for (const SceneNode* node : scene.all<RigidBodyNode>()) {
    const auto body = static_cast<const RigidBodyNode&>(*evaluate(*node, 0.0));
    const SceneNode* model = nullptr;
    for (const SceneNode* other : scene.all<ModelNode>())
      if (other->id == body.model) model = other;
    const auto data = scene.models.find(body.model);
    if (!model || data == scene.models.end() || !data->second) {
      flow.issues.push_back(
          {node->id, "model is \"" + body.model + "\", which is no enabled model with a file of this scene",
           model == nullptr});
      continue;
    }
    const Transform placement = scene.modelTransform(*model, 0.0);
    TriangleMesh mesh = placedTriangles(*data->second, placement);
    FlowWallsConfig& walls = flow.config.walls;
    if (body.motion == RigidMotion::Static)
      walls.meshes.push_back({std::move(mesh), nullptr, bodySurface(walls, body.friction)});
    else
      addBody(body, node->id, mesh, placement, flow);
  }
}

std::vector<RigidState> followKeys(const SceneSnapshot& scene, const std::vector<FlowBody>& bodies,
                                   std::vector<RigidState> states, double from, double to) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!bodies[k].kinematic) continue;
    for (const SceneNode* node : scene.all<ModelNode>()) {
      if (node->id != bodies[k].model) continue;
      // What the keys have done to the body since the start.
      const Transform back = bodies[k].placement.inverse();
      const Transform begin = scene.modelTransform(*node, from) * back;
      const Transform end = scene.modelTransform(*node, to) * back;
      const Quaternion turned = quaternionOf(begin.linear),
                       turn = shorter(quaternionOf(end.linear) * turned.conjugate());
      const double sine = std::sqrt(turn.x * turn.x + turn.y * turn.y + turn.z * turn.z);
      const double angle = 2.0 * std::atan2(sine, turn.w), seconds = to - from;
      RigidState& s = states[k];
      s.position = begin.point(bodies[k].centre);
      s.orientation = turned;
      s.velocity = (end.point(bodies[k].centre) - s.position) / seconds;
      s.angularVelocity = sine > 1e-12 ? Vec3d{turn.x, turn.y, turn.z} * (angle / (sine * seconds)) : Vec3d{};
      s.calmSeconds = 0.0;
    }
  }
  return states;
}

void publishBodies(const std::vector<FlowBody>& bodies, const std::vector<RigidState>& states, Frame& frame) {
  if (bodies.empty()) return;
  auto part = std::make_shared<BodiesPart>();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Transform moved =
        transformOf(states[k].orientation, states[k].position) * translationOf(-bodies[k].centre);
    part->bodies.push_back({bodies[k].model, moved * bodies[k].placement, states[k].velocity});
  }
  frame.parts["bodies"] = std::move(part);
}

}  // namespace spin
