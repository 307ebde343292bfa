// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/flow/flow_process.h"
#include "core/nodes/flow_nodes.h"
#include "core/nodes/ground_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/runner.h"

namespace spin::test {

/// A scene in the making: coarse particles and ten frames a second.
struct FlowTestScene {
  FlowSettingsNode settings;
  SimulationNode simulation;
  SceneSnapshot snapshot;

  FlowTestScene() {
    settings.spacing = 0.1;
    settings.margin = 2.0;
    settings.headroom = 2.0;
    simulation.frameRate = 10.0;
    simulation.checkpointInterval = 3;
    simulation.lastFrame = 20;
  }
  template <class T>
  FlowTestScene& add(const NodeType& type, const std::string& id, const T& data) {
    SceneNode node = makeNode(type, id, id);
    node.data = std::make_shared<T>(data);
    snapshot.nodes.push_back(std::move(node));
    return *this;
  }
  /// Terrain of w x h points with heights z(x, y).
  template <class Z>
  FlowTestScene& land(int w, int h, double cell, const Z& z) {
    auto data = std::make_shared<TerrainData>();
    data->heights = Raster<float>(w, h, 0.0, 0.0, cell);
    for (int j = 0; j < h; ++j)
      for (int i = 0; i < w; ++i)
        data->heights.at(i, j) = static_cast<float>(z(data->heights.x(i), data->heights.y(j)));
    snapshot.terrain = data;
    return add(kTerrainType, "terrain", TerrainNode{});
  }
  SceneSnapshot build() const {
    FlowTestScene copy = *this;
    copy.add(kFlowSettingsType, "flow_settings", settings);
    copy.add(kSimulationType, "simulation", simulation);
    return copy.snapshot;
  }
};

/// A cube of edge `size` about its origin, as a model.
inline std::shared_ptr<const ModelData> cubeModel(float size) {
  Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.positions.push_back(
        {(k & 1 ? 0.5f : -0.5f) * size, (k & 2 ? 0.5f : -0.5f) * size, (k & 4 ? 0.5f : -0.5f) * size});
  mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  auto model = std::make_shared<ModelData>();
  model->meshes = {std::move(mesh)};
  model->materials.resize(1);
  model->instances = {{0, Transform{}}};
  return model;
}

/// A cube in the scene and the body that makes it solid.
inline void addCube(FlowTestScene& scene, const std::string& id, float size, Vec3d position,
                    RigidMotion motion) {
  ModelNode model;
  model.position = position;
  RigidBodyNode body;
  body.model = id;
  body.motion = motion;
  body.density = 250.0;
  scene.snapshot.models[id] = cubeModel(size);
  scene.add(kModelType, id, model).add(kRigidBodyType, id + "_body", body);
}

inline AvalancheReleaseNode squareRelease(double low, double high, double depth) {
  AvalancheReleaseNode release;
  release.outline = {{low, low}, {high, low}, {high, high}, {low, high}};
  release.depth = depth;
  return release;
}

/// 16 x 12 m that fall by one half towards +x and run out level.
inline FlowTestScene& slopeScene(FlowTestScene& scene) {
  scene.land(33, 25, 0.5, [](double x, double) { return x < 10.0 ? 5.0 - 0.5 * x : 0.0; });
  return scene;
}

/// A slab, a source and a sink on that slope: everything that a checkpoint must hold.
inline SceneSnapshot busyScene() {
  FlowTestScene scene;
  slopeScene(scene);
  scene.settings.spacing = 0.2;
  AvalancheReleaseNode early = squareRelease(2.0, 4.0, 0.6);
  AvalancheReleaseNode late = squareRelease(7.0, 8.0, 0.4);
  late.releaseTime = 0.33;
  late.material = FlowMaterialKind::Water;
  WaterSourceNode source;
  source.position = {1.0, 8.0, 0.1};
  source.end = {1.0, 10.0, 0.1};
  source.velocity = {2.0, 0.0, 0.0};
  source.flowPerMetre = 0.7;
  source.start = 0.15;
  addCube(scene, "crate", 0.8f, {6.5, 3.0, 0.5}, RigidMotion::Dynamic);
  addCube(scene, "pillar", 1.0f, {8.0, 5.0, 0.4}, RigidMotion::Static);
  FlowSinkNode sink;
  sink.position = {9.0, 6.0, 0.5};
  sink.size = {1.0, 12.0, 3.0};
  WeatherNode weather;
  weather.windSpeed = 10.0;
  scene.settings.windDrag = 0.05;
  scene.add(kAvalancheReleaseType, "early", early).add(kAvalancheReleaseType, "late", late);
  scene.add(kWaterSourceType, "source", source).add(kFlowSinkType, "sink", sink);
  scene.add(kWeatherType, "weather", weather);
  return scene.build();
}

inline RunOptions flowOptions(int lastFrame, int threads = 2) {
  RunOptions options;
  options.lastFrame = lastFrame;
  options.threads = threads;
  options.types = {flowProcessType()};
  return options;
}

inline const ParticleSet& flowOf(const Frame& frame) {
  const auto* part = frame.part<ParticlePart>("flow");
  SPIN_CHECK(part, "the frame has no flow");
  return part->particles;
}

inline const std::vector<float>& valuesOf(const ParticleSet& set, const std::string& attribute) {
  const ParticleAttribute* found = set.find(attribute);
  SPIN_CHECK(found, "no attribute " + attribute);
  return found->values;
}

}  // namespace spin::test
