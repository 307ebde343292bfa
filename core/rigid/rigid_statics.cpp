// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigid_statics.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spin {
namespace {

/// The raster as nearestGround reads it, in double.
struct GroundView {
  const float* heights;
  std::int32_t width, height;
  double originX, originY, cell;
};

}  // namespace

void RigidStatics::addPlane(Plane plane) {
  plane.normal = normalized(plane.normal);
  m_planes.push_back(plane);
}
void RigidStatics::setGround(Raster<float> ground) {
  m_ground = std::move(ground);
}
void RigidStatics::addMesh(std::shared_ptr<const SignedDistance> field) {
  m_meshes.push_back(std::move(field));
}

void RigidStatics::near(Vec3d p, double reach,
                        const std::function<void(int part, const StaticContact&)>& visit) const {
  int part = 0;
  for (const Plane& plane : m_planes) {
    const double distance = dot(plane.normal, p - plane.point);
    if (distance < reach) visit(part, {distance, plane.normal});
    ++part;
  }
  if (!m_ground.empty()) {
    const GroundView view{m_ground.values.data(), m_ground.width,   m_ground.height,
                          m_ground.originX,       m_ground.originY, m_ground.cellSize};
    HeightContact<double> c;
    if (nearestGround(view, p.x, p.y, p.z, reach, c))
      visit(part, {c.distance, {c.normal.x, c.normal.y, c.normal.z}});
    ++part;
  }
  for (const auto& mesh : m_meshes) {
    SignedDistanceView::Value value;
    // Relative to the point: floats are exact enough near 0.
    if (mesh->view(p).sample(0.0f, 0.0f, 0.0f, value) && static_cast<double>(value.distance) < reach) {
      const Vec3d g = Vec3f{value.x, value.y, value.z}.to<double>();
      visit(part, {static_cast<double>(value.distance), length(g) > 1e-3 ? normalized(g) : Vec3d{0, 0, 1}});
    }
    ++part;
  }
}

double RigidStatics::highest(Vec3d centre, double radius) const {
  const auto index = [&](double v, double origin, int count) {
    return static_cast<int>(std::clamp((v - origin) / m_ground.cellSize, -1.0, count + 0.0));
  };
  const int i0 = std::max(index(centre.x - radius, m_ground.originX, m_ground.width) - 1, 0),
            i1 = std::min(index(centre.x + radius, m_ground.originX, m_ground.width) + 2, m_ground.width - 1);
  const int j0 = std::max(index(centre.y - radius, m_ground.originY, m_ground.height) - 1, 0),
            j1 = std::min(index(centre.y + radius, m_ground.originY, m_ground.height) + 2,
                          m_ground.height - 1);
  double top = -1e300;
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i) {
      const auto z = static_cast<double>(m_ground.at(i, j));
      if (z > top) top = z;  // a hole is no height
    }
  return top;
}

bool RigidStatics::mayTouch(Vec3d centre, double radius) const {
  for (const Plane& plane : m_planes)
    if (dot(plane.normal, centre - plane.point) < radius) return true;
  if (!m_ground.empty() && centre.z - radius < highest(centre, radius)) return true;
  return std::any_of(m_meshes.begin(), m_meshes.end(), [&](const auto& mesh) {
    const SignedDistanceView v = mesh->view(centre);
    const auto size = static_cast<double>(kFieldBlock / v.cellsPerMetre);
    const auto apart = [&](float low, std::int32_t blocks) {
      const auto from = static_cast<double>(low);
      return from > radius || from + size * blocks < -radius;
    };
    return !apart(v.originX, v.blocksX) && !apart(v.originY, v.blocksY) && !apart(v.originZ, v.blocksZ);
  });
}

}  // namespace spin
