// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/units.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/scene_weather.h"
#include "core/snow/wind_field.h"

namespace spin {
namespace {

/// Cells of the box, at most: its cloud would take some hundred GB.
constexpr double kMostCells = 4e9;
/// Bricks along an axis, at most.
constexpr double kMostBricks = 1 << 20;
/// Of the standard atmosphere near the ground, m.
constexpr double kScaleHeight = 8434.0;
/// Of the wind's profile over the ground, m.
constexpr double kRoughness = 0.01;
/// Crests speed the wind up to twice what it is over level ground at that height; at cliffs, which columns
/// that follow the ground cannot show, the solved wind may be a hundred times as fast.
constexpr double kMostSpeedUp = 2.0;

double pressureOf(const SceneSnapshot& scene) {
  const WeatherNode weather = scene.settings<WeatherNode>(0.0);
  return 101325.0 * std::exp(-(weather.altitudeKnown ? weather.altitude : 0.0) / kScaleHeight);
}

/// The weather's wind as it goes over the land: solved so that no air is lost or made, since what blows into
/// a cliff would set the whole air in motion.
Result<std::function<Vec3d(Vec3d)>> windOver(const SceneSnapshot& scene, const CancelToken& cancel) {
  std::function<Vec3d(Vec3d)> none;
  if (!scene.first<WeatherNode>()) return none;
  const WeatherNode weather = scene.settings<WeatherNode>(0.0);
  const Vec3d wind = windVector(weather.windSpeed, weather.windFromDegrees);
  if (length(wind) == 0.0) return none;
  if (!scene.terrain || scene.terrain->heights.empty())
    return std::function<Vec3d(Vec3d)>([wind](Vec3d p) { return wind * logProfile(p.z, kRoughness); });
  WindSettings settings;
  settings.roughness = kRoughness;
  settings.cancel = &cancel;
  CpuBackend backend;
  const Result<WindField> solved = WindField::make(scene.terrain->heights, {}, settings, backend);
  if (!solved) return solved.error();
  return std::function<Vec3d(Vec3d)>([field = *solved, plan = Vec2d{wind.x, wind.y}](Vec3d p) {
    const double above = p.z - field.groundHeight(p.x, p.y);
    if (!(above > 0.0)) return Vec3d{};
    const Vec3d here = field.at(p.x, p.y, above, plan);
    const double most = kMostSpeedUp * std::hypot(plan.x, plan.y) * logProfile(above, kRoughness),
                 speed = length(here);
    return speed > most ? here * (most / speed) : here;
  });
}

AirConfig configOf(const AirNode& node, const SurroundingAir& air, const Box3d& box, double cell) {
  AirConfig c;
  c.cell = cell;
  c.origin = box.min;
  const int cells[3] = {kBrickX, kBrickY, kBrickZ};
  for (int axis = 0; axis < 3; ++axis)
    c.highBrick[static_cast<std::size_t>(axis)] =
        std::max(static_cast<std::int32_t>(std::ceil(box.size()[axis] / (cell * cells[axis]) - 1e-9)), 1);
  c.temperature = air.temperature, c.pressure = air.pressure, c.humidity = air.humidity;
  c.buoyancy = static_cast<AirBuoyancy>(node.lift);
  c.evaporates = node.evaporates;
  c.viscosity = node.eddyViscosity;
  c.smagorinsky = node.smallEddies;
  c.settling = {sphereTerminalSpeed(node.mistDiameter, kWaterDensity, air.carrier),
                sphereTerminalSpeed(node.grainDiameter, kIceDensity, air.carrier)};
  c.advection = static_cast<AirAdvection>(node.advection);
  c.reflection = node.reflection;
  c.solver = static_cast<AirPressure>(node.solver);
  c.tolerance = node.tolerance;
  return c;
}

}  // namespace

double CloudScene::cells() const {
  double product = static_cast<double>(kBrickCells);
  for (std::size_t axis = 0; axis < 3; ++axis)
    product *= static_cast<double>(air.highBrick[axis] - air.lowBrick[axis]);
  return product;
}

bool sceneHasCloud(const SceneSnapshot& scene) {
  return scene.first<AirNode>() && sceneHasFlow(scene);
}

Result<CloudScene> makeCloudScene(const SceneSnapshot& scene, const CancelToken& cancel, bool withSolids) {
  CloudScene made;
  const SceneNode* airNode = scene.first<AirNode>();
  const AirNode node = scene.settings<AirNode>(0.0);
  const FlowScene flow = makeFlowScene(scene, 0.0, withSolids);
  if (const FlowIssue* issue = flow.fatal())
    return badInput("The air cannot start", issue->node, issue->text);
  const double cell = node.cell > 0.0 ? node.cell : 4.0 * flow.config.spacing;
  made.box.min = flow.config.domainMin - Vec3d{node.margin, node.margin, 0.0};
  made.box.max = flow.config.domainMax + Vec3d{node.margin, node.margin, node.headroom};
  for (int axis = 0; axis < 3; ++axis)
    if (made.box.size()[axis] / (4.0 * cell) > kMostBricks)
      return badInput(
          "The air cannot start", airNode ? airNode->id : std::string(),
          fmt::format("its box is {:.3g} m long with cells of {:.3g} m", made.box.size()[axis], cell),
          "Make cell_m larger or the flow's domain smaller");
  const AirNow now = airAt(scene, 0.0);
  made.surrounding = SurroundingAir::of(now.temperature, pressureOf(scene), now.relativeHumidity);
  made.air = configOf(node, made.surrounding, made.box, cell);
  made.air.gravity = flow.config.gravity;
  made.air.stop = [cancel] { return cancel.cancelled(); };
  if (made.cells() > kMostCells)
    return badInput("The air cannot start", airNode ? airNode->id : std::string(),
                    fmt::format("its box holds {:.2g} cells of {:.3g} m", made.cells(), cell),
                    "Make cell_m, or the flow's spacing, larger");
  made.flow = flow.config;
  made.flow.walls.meshes.clear();
  made.flow.bodies.clear();
  if (!withSolids) return made;
  Result<CloudSolids> solids = CloudSolids::make(scene, flow, cell, cancel);
  if (!solids) return solids.error();
  made.solids = std::move(*solids);
  Result<std::function<Vec3d(Vec3d)>> wind = windOver(scene, cancel);
  if (!wind) return wind.error();
  made.air.wind = std::move(*wind);
  made.air.solids = made.solids.airSolids();
  return made;
}

}  // namespace spin
