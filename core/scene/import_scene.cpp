// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/scene/import_scene.h"

#include <cmath>
#include <filesystem>

#include "core/fields/terrain_surface.h"
#include "core/nodes/camera_node.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"

namespace spin {
namespace {

/// In real time nobody sees the cover grow: 5 s of film show four hours.
constexpr double kNewTimeScale = 2880.0;

bool isRealTime(const SceneNode& simulation) {
  const auto* settings = simulation.as<SimulationNode>();
  return settings && settings->timeScale == SimulationNode().timeScale &&
         !simulation.curves.contains("time_scale");
}

}  // namespace

SceneNode importedNode(const Scene& scene, const NodeType& type, const std::string& file,
                       const std::string& name, const ImportOptions& options) {
  const bool terrain = &type == &kTerrainType;
  const std::string stem = std::filesystem::path(file).stem().string();
  SceneNode node = makeNode(type, scene.freeId(terrain ? type.id : stem), name.empty() ? stem : name);
  if (terrain) {
    setProperty(node, "epsg", static_cast<std::int64_t>(options.epsg));
    setProperty(node, "cell_size_m", options.cellSize);
    setProperty(node, "height_unit_m", options.heightScale);
    setProperty(node, "has_no_data", !std::isnan(options.noDataValue));
    if (!std::isnan(options.noDataValue)) setProperty(node, "no_data", options.noDataValue);
  } else {
    setProperty(node, "up_axis", static_cast<std::int64_t>(options.upAxis));
    setProperty(node, "unit_m", options.unitScale);
  }
  return node;
}

void setProperty(SceneNode& node, const std::string& property, const Value& value) {
  const PropertyInfo* info = node.type->find(property);
  SPIN_CHECK(info, "no property " + property);
  setPlainValue(node, *info, value);
}

Status checkProperties(const SceneNode& node) {
  for (const PropertyRow& row : node.type->properties)
    if (Status valid = validate(row, plainValue(node, row)); !valid) return valid;
  return {};
}

SceneSetUp snowSetUp(const Scene& scene) {
  const SceneNode* simulation = scene.firstOf(kSimulationType);
  if (scene.firstOf(kTerrainType) || scene.firstOf(kSnowfallType) || !simulation || !isRealTime(*simulation))
    return {};
  SceneSetUp setUp;
  setUp.changes.push_back({simulation->id, "time_scale", kNewTimeScale});
  setUp.added.push_back(makeNode(kSnowfallType, scene.freeId(kSnowfallType.id), kSnowfallType.label));
  return setUp;
}

SceneSetUp cameraSetUp(const Scene& scene, const FirstView& view) {
  const SceneNode* node = scene.firstOf(kCameraType);
  const auto* camera = node ? node->as<CameraNode>() : nullptr;
  const CameraNode untouched;
  if (!camera || camera->position != untouched.position || camera->target != untouched.target) return {};
  SceneSetUp setUp;
  setUp.changes.push_back({node->id, "position_m", view.position});
  setUp.changes.push_back({node->id, "target_m", view.target});
  return setUp;
}

void applySetUp(const SceneSetUp& setUp, Scene& scene) {
  for (const SceneSetUp::Change& change : setUp.changes) {
    SceneNode* node = scene.find(change.node);
    SPIN_CHECK(node, "no node " + change.node);
    setProperty(*node, change.property, change.value);
  }
  for (const SceneNode& node : setUp.added) {
    const Status added = scene.append(node);
    SPIN_CHECK(added.ok(), added.error().text());
  }
}

std::optional<Vec3d> cameraTarget(const Scene& scene) {
  const SceneNode* node = scene.firstOf(kCameraType);
  const auto* camera = node ? node->as<CameraNode>() : nullptr;
  if (!camera || !scene.firstOf(kTerrainType)) return {};
  return camera->target;
}

Vec3d standingPlace(Vec3d lookedAt, const Raster<float>* heights) {
  const Vec3d rounded{std::round(lookedAt.x), std::round(lookedAt.y), 0.0};
  if (!heights) return rounded;
  const TerrainSurface surface(*heights);
  if (surface.heightAt(rounded.x, rounded.y)) return rounded;
  if (surface.heightAt(lookedAt.x, lookedAt.y)) return {lookedAt.x, lookedAt.y, 0.0};
  const double column = (lookedAt.x - heights->originX) / heights->cellSize;
  const double row = (lookedAt.y - heights->originY) / heights->cellSize;
  const Vec3d near = groundNear(*heights, column, row).value_or(rounded);
  return {near.x, near.y, 0.0};
}

}  // namespace spin
