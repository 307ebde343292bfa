// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_estimate.h"

#include <fmt/format.h>

#include <algorithm>

namespace spin {
namespace {

constexpr double kFilled = 0.7, kFilledPlan = 0.15, kCloudHeight = 60.0;  // m
constexpr double kSmallBox = 3e5;                                         // m3

}  // namespace

double filledCells(const CloudScene& cloud) {
  const Vec3d size = cloud.box.size();
  const double cell = cloud.air.cell, wide = kSmallBox + kFilledPlan * size.x * size.y * kCloudHeight;
  return std::min(kFilled * cloud.cells(), wide / (cell * cell * cell));
}

std::optional<FlowIssue> memoryIssue(const CloudScene& cloud, const std::string& node, double available) {
  const double cells = filledCells(cloud), bytes = cells * kCloudWorkBytes;
  if (bytes <= available) return std::nullopt;
  return FlowIssue{
      node,
      fmt::format("about {:.3g} million cells of {:.3g} m take {:.1f} GB of memory and {:.1f} GB "
                  "are there: make cell_m, or the flow's spacing, larger",
                  cells * 1e-6, cloud.air.cell, bytes * 1e-9, available * 1e-9),
      true};
}

std::vector<FlowIssue> findCloudIssues(const SceneSnapshot& scene) {
  const SceneNode* air = scene.first<AirNode>();
  if (!air || !sceneHasCloud(scene)) return {};
  const std::string& node = air->id;
  const Result<CloudScene> made = makeCloudScene(scene, {}, false);
  if (!made) return {{node, made.error().text(), true}};
  if (const auto issue = memoryIssue(*made, node)) return {*issue};
  return {};
}

}  // namespace spin
