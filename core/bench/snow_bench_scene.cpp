// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/snow_bench_scene.h"

#include <cmath>
#include <limits>

namespace spin {
namespace {

void addQuad(Mesh& mesh, Vec3f a, Vec3f b, Vec3f c, Vec3f d) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
  mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
}

/// Valley along y: a flat floor, slopes on both sides, gullies across them, a gentle fall along it.
double valleyHeight(double x, double y, double extent) {
  const double across = std::abs(x / extent - 0.5) * 2.0;
  const double slope = std::max(0.0, across - 0.25) / 0.75;
  const double gullies = 0.06 * std::sin(y * 0.05) * slope + 0.02 * std::sin(0.11 * x + 0.07 * y);
  return extent * (0.45 * slope * slope * (1.4 - 0.4 * slope) + 0.25 * gullies + 0.03 * y / extent);
}

template <class T>
SceneNode nodeOf(const NodeType& type, const std::string& id, const T& data) {
  SceneNode node = makeNode(type, id, id);
  node.data = std::make_shared<T>(data);
  return node;
}

TerrainData valley(const SnowBenchScene& options) {
  TerrainData terrain;
  terrain.heights = Raster<float>(options.cells, options.cells, 0.0, 0.0, options.cellSize);
  Raster<float>& h = terrain.heights;
  const double extent = options.cellSize * (options.cells - 1);
  for (int j = 0; j < h.height; ++j)
    for (int i = 0; i < h.width; ++i) {
      const double x = h.x(i), y = h.y(j);
      const bool lake = std::hypot(x - 0.4 * extent, y - 0.75 * extent) < 0.06 * extent;
      const bool corner = x + y < 0.3 * extent;
      const bool hole = options.holes && (lake || corner);
      h.at(i, j) =
          hole ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(valleyHeight(x, y, extent));
    }
  return terrain;
}

}  // namespace

std::shared_ptr<const ModelData> benchHouse(double width, double length, double wall, double ridge) {
  const auto x = static_cast<float>(0.5 * width), y = static_cast<float>(0.5 * length);
  const auto w = static_cast<float>(wall), r = static_cast<float>(ridge);
  constexpr float kEaves = 0.6f, kThick = 0.2f;
  Mesh walls;
  addQuad(walls, {-x, -y, 0}, {-x, y, 0}, {x, y, 0}, {x, -y, 0});
  addQuad(walls, {-x, -y, w}, {x, -y, w}, {x, y, w}, {-x, y, w});
  addQuad(walls, {-x, -y, 0}, {x, -y, 0}, {x, -y, w}, {-x, -y, w});
  addQuad(walls, {x, -y, 0}, {x, y, 0}, {x, y, w}, {x, -y, w});
  addQuad(walls, {x, y, 0}, {-x, y, 0}, {-x, y, w}, {x, y, w});
  addQuad(walls, {-x, y, 0}, {-x, -y, 0}, {-x, -y, w}, {-x, y, w});
  Mesh roof;
  const float ex = x + kEaves, ey = y + kEaves, drop = (r - w) * kEaves / x;
  const float low = w - drop, high = r, under = kThick;
  // Two slabs that meet at the ridge: upper sides, undersides and rims.
  addQuad(roof, {-ex, -ey, low}, {0, -ey, high}, {0, ey, high}, {-ex, ey, low});
  addQuad(roof, {0, -ey, high}, {ex, -ey, low}, {ex, ey, low}, {0, ey, high});
  addQuad(roof, {-ex, ey, low - under}, {0, ey, high - under}, {0, -ey, high - under},
          {-ex, -ey, low - under});
  addQuad(roof, {0, ey, high - under}, {ex, ey, low - under}, {ex, -ey, low - under}, {0, -ey, high - under});
  addQuad(roof, {-ex, -ey, low}, {-ex, ey, low}, {-ex, ey, low - under}, {-ex, -ey, low - under});
  addQuad(roof, {ex, ey, low}, {ex, -ey, low}, {ex, -ey, low - under}, {ex, ey, low - under});
  for (const float s : {-1.0f, 1.0f}) {
    const Vec3f l{-ex, s * ey, low}, m{0, s * ey, high}, e{ex, s * ey, low};
    const Vec3f down{0, 0, -under};
    if (s < 0.0f) {
      addQuad(roof, l + down, m + down, m, l);
      addQuad(roof, m + down, e + down, e, m);
    } else {
      addQuad(roof, l, m, m + down, l + down);
      addQuad(roof, m, e, e + down, m + down);
    }
  }
  auto model = std::make_shared<ModelData>();
  model->meshes = {walls, roof};
  model->materials.resize(1);
  model->instances = {{0, Transform{}}, {1, Transform{}}};
  return model;
}

SceneSnapshot snowBenchSnapshot(const SnowBenchScene& options) {
  SceneSnapshot scene;
  scene.terrain = std::make_shared<TerrainData>(valley(options));
  scene.nodes.push_back(nodeOf(kTerrainType, "terrain", TerrainNode{}));
  const double extent = options.cellSize * (options.cells - 1);
  for (int k = 0; k < options.houses; ++k) {
    ModelNode house;
    house.position = {extent * (0.42 + 0.05 * k), extent * (0.35 + 0.04 * k), -0.5};
    house.rotationDegrees = {0, 0, 25.0 * k};
    const std::string id = "house" + std::to_string(k);
    scene.nodes.push_back(nodeOf(kModelType, id, house));
    scene.models[id] = benchHouse(8.0, 11.0, 4.0, 7.5);
  }
  scene.nodes.push_back(nodeOf(kWeatherType, "weather", options.weather));
  scene.nodes.push_back(nodeOf(kSnowfallType, "snowfall", options.snowfall));
  scene.nodes.push_back(nodeOf(kSimulationType, "simulation", options.simulation));
  return scene;
}

}  // namespace spin
