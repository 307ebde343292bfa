// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/app/flow_defaults.h"

#include <algorithm>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "editor/viewport/scene_picker.h"
#include "editor/viewport/viewport.h"

namespace spin {
namespace {

/// Steepest way down over about `reach` m; south on level ground.
Vec2d downhill(const ViewSight& sight, Vec3d at, double reach) {
  if (!sight.terrain) return {0.0, -1.0};
  const TerrainSurface surface(sight.terrain->heights);
  const double r = std::max(reach, sight.terrain->heights.cellSize);
  const double dx = surface.nearestHeight(at.x + r, at.y) - surface.nearestHeight(at.x - r, at.y);
  const double dy = surface.nearestHeight(at.x, at.y + r) - surface.nearestHeight(at.x, at.y - r);
  const double size = std::hypot(dx, dy);
  return size > 1e-3 * r ? Vec2d{-dx / size, -dy / size} : Vec2d{0.0, -1.0};
}

/// A length that is a good part of the view, to two figures.
double sizeFor(double distance, double share, double least, double most) {
  const double size = std::clamp(share * distance, least, most);
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 1.0) * 5.0;
  return std::max(std::round(size / step) * step, least);
}

/// As somebody would write it: to centimetres.
double tidy(double v) {
  return std::round(100.0 * v) / 100.0;
}
Vec2d tidy(Vec2d v) {
  return {tidy(v.x), tidy(v.y)};
}
Vec3d tidy(Vec3d v) {
  return {tidy(v.x), tidy(v.y), tidy(v.z)};
}

}  // namespace

ViewSight sightOf(const Viewport& viewport) {
  const ViewportContext seen = viewport.context();
  ViewSight sight;
  const RenderCamera& camera = seen.view.camera();
  sight.eye = camera.position;
  sight.target = camera.target;
  sight.fovDegrees = camera.fovDegrees;
  if (!seen.scene) return sight;
  const Vec2d middle{0.5 * seen.view.width(), 0.5 * seen.view.height()};
  sight.place = pickTerrain(*seen.scene, seen.view.ray(middle));
  sight.terrain = seen.scene->terrain;
  if (sight.place) sight.distance = length(*sight.place - seen.view.camera().position);
  return sight;
}

edit::PropertyValues placedDefaults(const NodeType& type, const ViewSight& sight,
                                    const std::string& selected) {
  if (&type == &kRigidBodyType)
    return selected.empty() ? edit::PropertyValues{} : edit::PropertyValues{{"model", selected}};
  if (&type == &kCameraType)
    return {{"position_m", tidy(sight.eye)}, {"target_m", tidy(sight.target)}, {"fov_deg", sight.fovDegrees}};
  if (!sight.place) return {};
  const Vec3d at = tidy(*sight.place);
  if (&type == &kAvalancheReleaseType) {
    const double half = 0.5 * sizeFor(sight.distance, 0.25, 4.0, 200.0);
    const Vec2d d = downhill(sight, at, half), across{-d.y, d.x};
    const auto corner = [&](double a, double b) {
      return tidy(Vec2d{at.x + half * (a * across.x + b * d.x), at.y + half * (a * across.y + b * d.y)});
    };
    return {{"outline_m", PlanPoints{corner(-1.3, -1), corner(1.3, -1), corner(1.3, 1), corner(-1.3, 1)}}};
  }
  if (&type == &kWaterSourceType) {
    const double half = 0.5 * sizeFor(sight.distance, 0.08, 1.0, 20.0);
    const Vec2d d = downhill(sight, at, half), across{-d.y, d.x};
    return {{"position_m", tidy(Vec3d{at.x - half * across.x, at.y - half * across.y, 0.0})},
            {"end_m", tidy(Vec3d{at.x + half * across.x, at.y + half * across.y, 0.0})},
            {"velocity_m_s", tidy(Vec3d{2.0 * d.x, 2.0 * d.y, 0.0})}};
  }
  if (&type == &kHeatSourceType)
    return {{"position_m", Vec3d{at.x, at.y, 0.0}}, {"radius_m", sizeFor(sight.distance, 0.05, 1.0, 200.0)}};
  if (&type == &kFlowSinkType) {
    const double side = sizeFor(sight.distance, 0.15, 2.0, 100.0);
    return {{"position_m", at}, {"size_m", Vec3d{side, side, side}}};
  }
  return {};
}

}  // namespace spin
