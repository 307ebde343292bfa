// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/cloud/cloud_estimate.h"
#include "core/fields/terrain_surface.h"
#include "core/flow/flow_estimate.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/cli/commands.h"

namespace spin {
namespace {

using Problems = std::vector<SceneProblem>;

void checkSettings(const SceneSnapshot& scene, Problems& problems) {
  const SceneNode* node = scene.first<SimulationNode>();
  if (!node) return;
  const SimulationNode settings = scene.settings<SimulationNode>(0.0);
  if (settings.firstFrame > settings.lastFrame)
    problems.push_back(
        {node->id,
         fmt::format("first_frame {} lies after last_frame {}", settings.firstFrame, settings.lastFrame),
         true});
  if (settings.holdsBelowDegrees > settings.shedsAboveDegrees)
    problems.push_back(
        {node->id,
         fmt::format("holds_below_deg {} is above sheds_above_deg {}: no slope can be between them",
                     settings.holdsBelowDegrees, settings.shedsAboveDegrees),
         true});
  if (settings.timeScale == 0.0)
    problems.push_back({node->id, "time_scale is 0: no weather passes and no cover grows", false});
}

void checkSnowfall(const SceneSnapshot& scene, Problems& problems) {
  const SceneNode* snowfall = scene.first<SnowfallNode>();
  if (!snowfall) return;
  if (!scene.first<WeatherNode>())
    problems.push_back(
        {snowfall->id, "there is no weather node: its default precipitation and wind are used", false});
  if (!scene.terrain && scene.models.empty())
    problems.push_back({snowfall->id, "there is neither terrain nor model for the snow to lie on", false});
}

void checkLayers(const SceneSnapshot& scene, Problems& problems) {
  for (const SceneNode& node : scene.nodes) {
    int width = 0, height = 0;
    if (const auto* types = std::get_if<TiledRaster<std::uint8_t>>(&node.painted))
      width = types->width(), height = types->height();
    if (const auto* reals = std::get_if<TiledRaster<float>>(&node.painted))
      width = reals->width(), height = reals->height();
    if (width == 0) continue;
    if (!scene.terrain)
      problems.push_back({node.id, "it is painted, but there is no terrain under it", true});
    else if (width != scene.terrain->heights.width || height != scene.terrain->heights.height)
      problems.push_back({node.id,
                          fmt::format("it is painted at {} x {} cells and the terrain has {} x {}", width,
                                      height, scene.terrain->heights.width, scene.terrain->heights.height),
                          true});
  }
}

void checkFlow(const SceneSnapshot& scene, Problems& problems) {
  if (!sceneHasFlow(scene)) return;
  const auto flow = findFlowIssues(scene), air = findCloudIssues(scene);
  for (const auto* issues : {&flow, &air})
    for (const FlowIssue& issue : *issues) problems.push_back({issue.node, issue.text, issue.fatal});
}

double distanceInPlan(const Box3d& box, Vec3d p) {
  return std::hypot(std::max({box.min.x - p.x, 0.0, p.x - box.max.x}),
                    std::max({box.min.y - p.y, 0.0, p.y - box.max.y}));
}

void checkModels(const SceneSnapshot& scene, Problems& problems) {
  if (!scene.terrain) return;
  const TerrainSurface surface(scene.terrain->heights);
  const Box3d land = boundsOf(scene.terrain->heights);
  const double width = std::max(land.size().x, land.size().y);
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto* model = node->as<ModelNode>();
    const Vec3d place = scene.modelTransform(*node, 0.0).translation;
    const double away = distanceInPlan(land, place);
    if (away > width)
      problems.push_back({node->id,
                          fmt::format("it stands {:.1f} km outside the terrain: the air over all of that is "
                                      "simulated, and the mass budget loses digits",
                                      away * 1e-3),
                          false});
    if (model && model->onGround && !surface.heightAt(place.x, place.y))
      problems.push_back({node->id,
                          "it should stand on the ground, but lies outside the terrain or over a hole of it",
                          false});
  }
}

}  // namespace

std::vector<SceneProblem> findProblems(const OpenedScene& opened) {
  Problems problems;
  for (const AssetLibrary::Issue& issue : opened.issues)
    problems.push_back({issue.node, issue.error.text(), !issue.usable});
  const SceneSnapshot& scene = *opened.snapshot;
  checkSettings(scene, problems);
  checkSnowfall(scene, problems);
  checkLayers(scene, problems);
  checkModels(scene, problems);
  checkFlow(scene, problems);
  return problems;
}

}  // namespace spin
