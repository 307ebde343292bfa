// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/sph/flow_world.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/sph/body_boundary.h"

namespace spin {
namespace {

/// Points that are summed in one go.
constexpr std::uint32_t kChunk = 64;
/// A body farther off than this from the domain's corner has nothing in it, units.
constexpr double kFarthest = 1073741824.0;

}  // namespace

Result<RigidWorld> makeFlowWorld(const FlowConfig& config) {
  RigidStatics statics;
  for (const auto& plane : config.walls.planes) statics.addPlane({plane.point, plane.normal});
  if (!config.walls.ground.empty()) statics.setGround(config.walls.ground);
  for (const auto& mesh : config.walls.meshes)
    if (mesh.field) statics.addMesh(mesh.field);
  return RigidWorld::make(config.bodies, std::move(statics), config.gravity, config.bodyGroundFriction);
}

BodyPoints makeBodyPoints(const FlowConfig& config) {
  BodyPoints result;
  std::map<const RigidShape*, BodyBoundary> known;
  for (std::uint32_t k = 0; k < config.bodies.size(); ++k) {
    const RigidBodyConfig& body = config.bodies[k];
    const auto [place, fresh] = known.try_emplace(body.shape.get());
    if (fresh) place->second = sampleBody(*body.shape, config.spacing, config.support());
    const BodyBoundary& boundary = place->second;
    const auto first = static_cast<std::uint32_t>(result.points.size());
    for (std::size_t b = 0; b < boundary.positions.size(); ++b) {
      const Vec3f p = boundary.positions[b].to<float>();
      result.points.push_back({p.x, p.y, p.z, boundary.volumes[b], k});
    }
    const auto end = static_cast<std::uint32_t>(result.points.size());
    for (std::uint32_t begin = first; begin < end; begin += kChunk)
      result.chunks.push_back({begin, std::min(begin + kChunk, end), k});
    result.surfaces.push_back(body.surface);
  }
  return result;
}

std::vector<BodyPose> bodyPoses(const std::vector<RigidState>& states, const FlowView& view, Vec3d origin) {
  std::vector<BodyPose> poses;
  const double scale = static_cast<double>(kCellUnits) / static_cast<double>(view.constants.support);
  for (const RigidState& s : states) {
    BodyPose p{};
    const Vec3d units = (s.position - origin) * scale;
    p.there = std::max({std::abs(units.x), std::abs(units.y), std::abs(units.z)}) < kFarthest ? 1 : 0;
    if (p.there != 0) {
      const Vec3d whole{std::floor(units.x), std::floor(units.y), std::floor(units.z)};
      const Vec3f rest = (units - whole).to<float>();
      p.x = static_cast<std::int32_t>(whole.x), p.y = static_cast<std::int32_t>(whole.y),
      p.z = static_cast<std::int32_t>(whole.z);
      p.restX = rest.x, p.restY = rest.y, p.restZ = rest.z;
    }
    const Vec3f ex = s.orientation.rotate({1, 0, 0}).to<float>(),
                ey = s.orientation.rotate({0, 1, 0}).to<float>(),
                ez = s.orientation.rotate({0, 0, 1}).to<float>();
    const float turn[9] = {ex.x, ey.x, ez.x, ex.y, ey.y, ez.y, ex.z, ey.z, ez.z};
    std::copy(turn, turn + 9, p.turn);
    const Vec3f v = s.velocity.to<float>(), w = s.angularVelocity.to<float>();
    p.vx = v.x, p.vy = v.y, p.vz = v.z;
    p.wx = w.x, p.wy = w.y, p.wz = w.z;
    poses.push_back(p);
  }
  return poses;
}

}  // namespace spin
