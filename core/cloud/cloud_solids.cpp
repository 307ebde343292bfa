// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_solids.h"

#include <algorithm>

namespace spin {
namespace {

constexpr double kFar = 1e6;

double fieldDistance(const SignedDistanceView& view, Vec3d p) {
  SignedDistanceView::Value value;
  const Vec3f at = p.to<float>();
  return view.sample(at.x, at.y, at.z, value) ? static_cast<double>(value.distance) : kFar;
}

/// All that a field knows of.
Box3d boxOf(const SignedDistanceView& view) {
  const Vec3d low{view.originX, view.originY, view.originZ};
  const double block = kFieldBlock / static_cast<double>(view.cellsPerMetre);
  return {low, low + block * Vec3d{static_cast<double>(view.blocksX), static_cast<double>(view.blocksY),
                                   static_cast<double>(view.blocksZ)}};
}

}  // namespace

Result<CloudSolids> CloudSolids::make(const SceneSnapshot& scene, const FlowScene& flow, double cell,
                                      const CancelToken& cancel) {
  CloudSolids made;
  made.m_ground = CloudGround(scene);
  for (const FlowWallsConfig::MeshWall& wall : flow.config.walls.meshes) {
    SignedDistanceOptions options;
    options.cell = 0.5 * cell;
    options.reach = 2.0 * cell;
    options.leastThickness = cell;
    options.cancel = cancel;
    auto field = SignedDistance::make(wall.triangles, options);
    if (!field) return field.error();
    made.m_meshes.push_back(*field);
  }
  for (const RigidBodyConfig& body : flow.config.bodies) {
    made.m_shapes.push_back(body.shape);
    made.m_bodies->push_back(body.start);
  }
  return made;
}

double CloudSolids::bodyDistance(std::size_t body, Vec3d p) const {
  return fieldDistance(m_shapes[body]->field->view({}), (*m_bodies)[body].toBody(p));
}

double CloudSolids::distance(Vec3d p) const {
  double nearest = groundDistance(p);
  for (const auto& mesh : m_meshes) nearest = std::min(nearest, fieldDistance(mesh->view({}), p));
  for (std::size_t k = 0; k < m_shapes.size(); ++k) nearest = std::min(nearest, bodyDistance(k, p));
  return nearest;
}

Vec3d CloudSolids::normal(Vec3d p) const {
  constexpr double kStep = 0.01;
  const auto along = [&](Vec3d d) { return distance(p + d) - distance(p - d); };
  const Vec3d slope{along({kStep, 0, 0}), along({0, kStep, 0}), along({0, 0, kStep})};
  return length(slope) > 0.0 ? normalized(slope) : Vec3d{0, 0, 1};
}

std::vector<AirSolid> CloudSolids::airSolids() const {
  std::vector<AirSolid> solids;
  // Copies, so that the solver may keep the functions longer than this is there.
  const CloudSolids own = *this;
  AirSolid ground{[own](Vec3d p) { return own.groundDistance(p); }, {}};
  ground.mayTouch = [own](Vec3d low, Vec3d high) { return own.m_ground.mayTouch(low, high); };
  solids.push_back(std::move(ground));
  for (const auto& mesh : m_meshes) {
    const Box3d box = boxOf(mesh->view({}));
    solids.push_back({[mesh](Vec3d p) { return fieldDistance(mesh->view({}), p); }, {}, box.min, box.max});
  }
  for (std::size_t k = 0; k < m_shapes.size(); ++k) {
    const double far = m_shapes[k]->radius + m_shapes[k]->field->reach();
    const Vec3d middle = (*m_bodies)[k].position, half{far, far, far};
    solids.push_back({[own, k](Vec3d p) { return own.bodyDistance(k, p); },
                      [own, k](Vec3d p) { return (*own.m_bodies)[k].velocityAt(p); }, middle - half,
                      middle + half});
  }
  return solids;
}

}  // namespace spin
