// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/solid_test.h"

namespace spin {

SolidTest::SolidTest(const FlowConfig& config, const WallView& walls, const std::vector<RigidState>& bodies)
    : m_config(config),
      m_bodies(bodies),
      m_origin(config.domainMin),
      m_walls(walls),
      m_heights(config.walls.ground.values),
      m_spacing(static_cast<float>(config.spacing)) {
  for (float& z : m_heights) z -= static_cast<float>(config.domainMin.z);
  m_walls.ground.heights = m_heights.empty() ? nullptr : m_heights.data();
  m_walls.ground.surfaces = nullptr;
  for (const auto& mesh : config.walls.meshes)
    if (mesh.field) m_meshes.push_back({mesh.field->view(config.domainMin), mesh.surface});
  m_walls.meshes = m_meshes.data();
  m_walls.meshCount = static_cast<std::int32_t>(m_meshes.size());
}

bool SolidTest::inBody(const Vec3d& position) const {
  for (std::size_t k = 0; k < m_bodies.size(); ++k) {
    const RigidShape& shape = *m_config.bodies[k].shape;
    const Vec3f p = m_bodies[k].toBody(position).to<float>();
    SignedDistanceView::Value value;
    if (shape.field->view({}).sample(p.x, p.y, p.z, value) && value.distance < -0.25f * m_spacing)
      return true;
  }
  return false;
}

bool SolidTest::operator()(const Vec3d& position) const {
  const Vec3f p = (position - m_origin).to<float>();
  bool inside = inBody(position);
  m_walls.near(p.x, p.y, p.z, m_spacing,
               [&](const WallContact& wall) { inside = inside || wall.distance < -0.25f * m_spacing; });
  return inside;
}

}  // namespace spin
