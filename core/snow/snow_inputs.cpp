// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_inputs.h"

#include "core/nodes/cover_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/snow/ground_layers.h"

namespace spin {

bool snowHasGround(const SceneSnapshot& scene) {
  if (!scene.first<SnowfallNode>()) return false;
  if (scene.terrain && !scene.terrain->heights.empty()) return true;
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto found = scene.models.find(node->id);
    if (found != scene.models.end() && found->second && found->second->triangleCount() > 0) return true;
  }
  return false;
}

bool modelTurns(const SceneNode& model) {
  for (const char* property : {"rotation_deg", "scale"}) {
    const auto curve = model.curves.find(property);
    if (curve == model.curves.end()) continue;
    for (const Key& key : curve->second.keys())
      if (!(key.value == curve->second.keys().front().value)) return true;
  }
  return false;
}

void hashSnowWeather(const StepInput& input, Hasher& hasher) {
  for (const FrameTime& time : {input.from, input.to}) hasher.add(time.film).add(time.weather);
  const auto hashAll = [&](const auto& nodes) {
    for (const SceneNode* node : nodes)
      for (const double film : {input.from.film, middleFilm(input), input.to.film})
        input.scene.hashNode(*node, film, hasher);
  };
  hashAll(input.scene.all<WeatherNode>());
  hashAll(input.scene.all<SnowfallNode>());
  hashAll(input.scene.all<SimulationNode>());
  // The light of pictures counts only where it melts.
  for (const double film : {input.from.film, middleFilm(input), input.to.film}) {
    const auto weather = input.scene.settings<WeatherNode>(film);
    if (weather.sun == MeltingSun::Pictured)
      hasher.add(weather.sunAzimuthDegrees).add(weather.sunElevationDegrees);
  }
}

void hashSnowGround(const StepInput& input, Hasher& hasher) {
  hasher.add(input.scene.terrain != nullptr);
  for (const SceneNode* node : input.scene.all<TerrainNode>())
    input.scene.hashNode(*node, middleFilm(input), hasher);
  for (const SceneNode* node : input.scene.all<ModelNode>()) {
    input.scene.hashNode(*node, middleFilm(input), hasher);
    // A key at any time decides whether the model has patches at all.
    hasher.add(modelTurns(*node));
  }
}

void hashSnowCover(const StepInput& input, Hasher& hasher) {
  const auto hashAll = [&](const auto& nodes) {
    for (const SceneNode* node : nodes)
      for (const double film : {input.from.film, middleFilm(input), input.to.film})
        input.scene.hashNode(*node, film, hasher);
  };
  hashAll(input.scene.all<SnowCoverNode>());
  hashAll(input.scene.all<HeatSourceNode>());
  hashGroundLayers(input, hasher);
  hashKeepClear(input, hasher);
}

}  // namespace spin
