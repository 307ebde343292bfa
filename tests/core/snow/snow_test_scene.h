// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <memory>

#include "core/base/units.h"
#include "core/bench/snow_run.h"
#include "core/nodes/cover_nodes.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "core/sim/flakes_part.h"
#include "core/snow/exposure_process.h"
#include "core/snow/snow_processes.h"

namespace spin::test {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

template <class T>
SceneNode node(const NodeType& type, const std::string& id, const T& data) {
  SceneNode made = makeNode(type, id, id);
  made.data = std::make_shared<T>(data);
  return made;
}

/// A scene in the making, with quiet defaults: no wind, no spread, no noise, snow lies as it fell.
struct TestScene {
  WeatherNode weather;
  SnowfallNode snowfall;
  SimulationNode simulation;
  SnowCoverNode cover;
  TerrainNode terrain;
  SceneSnapshot snapshot;

  TestScene() {
    cover.law = CoverLaw::Lies;
    weather.windSpeed = 0.0;
    weather.precipitationRate = 0.002;
    snowfall.fallSpreadDegrees = 0.0;
    snowfall.flakeCount = 100;
    simulation.timeScale = 2400.0;  // 100 s of weather a frame
    simulation.exposureNoise = 0.0;
    simulation.snowSlides = simulation.snowDrifts = false;
    simulation.smoothingWidth = 0.0;
    simulation.exposureRays = 16;
    simulation.newSnowDensity = 100.0;
  }
  /// Terrain of w x h points with heights z(x, y).
  template <class Z>
  TestScene& land(int w, int h, double cell, const Z& z) {
    auto data = std::make_shared<TerrainData>();
    data->heights = Raster<float>(w, h, 0.0, 0.0, cell);
    for (int j = 0; j < h; ++j)
      for (int i = 0; i < w; ++i)
        data->heights.at(i, j) = static_cast<float>(z(data->heights.x(i), data->heights.y(j)));
    snapshot.terrain = data;
    return *this;
  }
  TestScene& model(const std::string& id, std::shared_ptr<const ModelData> data, const ModelNode& placed) {
    snapshot.models[id] = std::move(data);
    snapshot.nodes.push_back(node(kModelType, id, placed));
    return *this;
  }
  SceneSnapshot build() const {
    SceneSnapshot scene = snapshot;
    if (scene.terrain) scene.nodes.push_back(node(kTerrainType, "terrain", terrain));
    scene.nodes.push_back(node(kWeatherType, "weather", weather));
    scene.nodes.push_back(node(kSnowfallType, "snowfall", snowfall));
    scene.nodes.push_back(node(kSnowCoverType, "snow_cover", cover));
    scene.nodes.push_back(node(kSimulationType, "simulation", simulation));
    return scene;
  }
};

inline std::shared_ptr<const ModelData> modelOf(Mesh mesh) {
  auto model = std::make_shared<ModelData>();
  model->meshes = {std::move(mesh)};
  model->materials.resize(1);
  model->instances = {{0, Transform{}}};
  return model;
}

/// A closed box, outward faces, by two opposite corners.
inline Mesh boxMesh(Vec3f a, Vec3f b) {
  Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.positions.push_back({k & 1 ? b.x : a.x, k & 2 ? b.y : a.y, k & 4 ? b.z : a.z});
  mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return mesh;
}

/// An open sheet by three corners and the fourth of the parallelogram.
inline Mesh sheetMesh(Vec3f a, Vec3f b, Vec3f c) {
  Mesh mesh;
  mesh.positions = {a, b, b + c - a, c};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

inline const CoverPart& coverOf(const Frame& frame) {
  const auto* cover = frame.part<CoverPart>("cover");
  SPIN_CHECK(cover, "the frame has no cover");
  return *cover;
}

inline const FallingFlakes& flakesOf(const Frame& frame) {
  const auto* part = frame.part<FlakesPart>("flakes");
  SPIN_CHECK(part, "the frame has no flakes");
  return part->flakes;
}

inline ExposureFieldPointer fieldIn(Exchange& exchange) {
  const auto* field = exchange.find<ExposureFieldPointer>();
  SPIN_CHECK(field, "no exposure was handed on");
  return *field;
}

inline std::size_t gridOf(const CoverPart& cover, const std::string& id) {
  for (std::size_t g = 0; g < cover.layout->grids.size(); ++g)
    if (cover.layout->grids[g].id == id) return g;
  SPIN_CHECK(false, "no grid " + id);
  return 0;
}

/// kg that lie on a grid by the published values.
inline double massOn(const CoverPart& cover, std::size_t g) {
  double sum = 0.0;
  for (std::size_t c = 0; c < cover.values[g].swe.size(); ++c)
    sum += static_cast<double>(cover.values[g].swe[c]) *
           static_cast<double>(cover.layout->grids[g].area.values[c]);
  return sum;
}

inline double areaOf(const CoverPart& cover, std::size_t g) {
  double sum = 0.0;
  for (const float a : cover.layout->grids[g].area.values) sum += static_cast<double>(a);
  return sum;
}

}  // namespace spin::test
