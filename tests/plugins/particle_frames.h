// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/frame.h"
#include "plugins/host/plugin_host.h"

namespace spin::test {

/// A frame of n flakes at time frame / 24 s with a velocity and a size.
inline Frame flakeFrame(int number, std::size_t n, std::uint64_t firstId = 7) {
  auto part = std::make_shared<ParticlePart>();
  ParticleSet& set = part->particles;
  set.name = "flakes";
  set.weight = 12.5;
  ParticleAttribute velocity{"velocity", "m/s", 3, {}}, size{"size", "m", 1, {}};
  for (std::size_t i = 0; i < n; ++i) {
    const auto v = static_cast<float>(i);
    set.ids.push_back(firstId + i);
    set.positions.push_back({v, 2.0f * v + 0.5f, -v});
    velocity.values.insert(velocity.values.end(), {0.1f * v, 0.0f, -1.0f});
    size.values.push_back(0.001f * v);
  }
  set.attributes = {velocity, size};
  Frame frame;
  frame.info.time = {number, number / 24.0, number * 120.0};
  frame.parts["flakes"] = part;
  return frame;
}

/// A scene with a terrain of 2 x 2 cells, somewhere in Tyrol.
inline SnapshotPointer sceneWithTerrain() {
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(2, 2, 0.0, 0.0, 5.0);
  terrain->geo = {{176975.9368, 376240.3352, 1000.0}, 31287, ""};
  auto scene = std::make_shared<SceneSnapshot>();
  scene->terrain = terrain;
  return scene;
}

}  // namespace spin::test
