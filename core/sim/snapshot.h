// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/fields/mesh.h"
#include "core/fields/raster.h"
#include "core/fields/weather_series.h"
#include "core/property/scene_node.h"

namespace spin {

/// A frame and its times. Frame 0 is the initial state.
struct FrameTime {
  int frame = 0;
  double film = 0.0;     ///< s of film: frame / frame_rate
  double weather = 0.0;  ///< s of weather: film * time_scale
};

/// Everything a simulation or a picture needs, frozen: nodes (copies that share data), decoded assets,
/// painted rasters. Immutable after construction; shared between threads.
struct SceneSnapshot {
  std::vector<SceneNode> nodes;                ///< all nodes, disabled ones too
  std::shared_ptr<const TerrainData> terrain;  ///< null: no terrain; vertical_scale is applied
  std::map<std::string, std::shared_ptr<const ModelData>> models;  ///< by id of the model node
  std::shared_ptr<const WeatherSeries> weather;                    ///< record of the weather node; null: none
  std::map<std::string, Hash128> assetHashes;  ///< content of each node's file, by node id

  /// The first enabled node of a type; nullptr if there is none.
  template <class T>
  const SceneNode* first() const {
    for (const SceneNode& node : nodes)
      if (node.enabled && node.as<T>()) return &node;
    return nullptr;
  }
  /// All enabled nodes of a type, in scene order.
  template <class T>
  std::vector<const SceneNode*> all() const {
    std::vector<const SceneNode*> found;
    for (const SceneNode& node : nodes)
      if (node.enabled && node.as<T>()) found.push_back(&node);
    return found;
  }
  /// Evaluated properties of the first enabled node of a type at a film time; defaults if there is none.
  template <class T>
  T settings(double filmTime) const {
    const SceneNode* node = first<T>();
    return node ? static_cast<const T&>(*evaluate(*node, filmTime)) : T{};
  }

  FrameTime timeOf(int frame) const;
  /// Placement of a model node at a film time: model space (m, z up) to local metres, standing on the terrain
  /// where the node says so (the ground under its position; z 0 where there is no terrain).
  Transform modelTransform(const SceneNode& model, double filmTime) const;
  /// Adds to the hasher every property of the node that affects the simulation, evaluated at the film time,
  /// and the content of its asset and painted layer.
  void hashNode(const SceneNode& node, double filmTime, Hasher& hasher) const;
};

using SnapshotPointer = std::shared_ptr<const SceneSnapshot>;

}  // namespace spin
