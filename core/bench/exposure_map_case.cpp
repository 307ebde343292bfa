// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "core/base/random.h"
#include "core/bench/bench_meter.h"
#include "core/nodes/terrain_node.h"
#include "core/snow/occlusion_map.h"

namespace spin {
namespace {

/// A spruce of whorls of leaning triangles, about 2800 of them, 12 m high.
Mesh spruce() {
  constexpr int kWhorls = 40, kBranches = 35;
  Mesh mesh;
  for (int w = 0; w < kWhorls; ++w)
    for (int b = 0; b < kBranches; ++b) {
      const double z = 1.0 + 11.0 * w / kWhorls, reach = 2.4 * (12.2 - z) / 11.2;
      const double angle = 2.0 * kPi * (b + 0.37 * w) / kBranches;
      const Vec3d out{std::cos(angle), std::sin(angle), 0.0}, side{-out.y, out.x, 0.0};
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const Vec3d& p :
           {Vec3d{0, 0, z + 0.3}, out * reach + Vec3d{0, 0, z - 0.4} + side * 0.15,
            out * reach + Vec3d{0, 0, z - 0.4} - side * 0.15, out * (0.5 * reach) + Vec3d{0, 0, z - 0.3}})
        mesh.positions.push_back(p.to<float>());
      mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 3, first + 1});
    }
  return mesh;
}

/// A valley of 4 x 4 km with a forest in its middle: as many triangles as the village has.
SceneSnapshot forest(std::size_t trees) {
  SceneSnapshot scene;
  auto terrain = std::make_shared<TerrainData>();
  terrain->heights = Raster<float>(401, 401, 0.0, 0.0, 10.0);
  const auto height = [](double x, double y) {
    return 2.5e-4 * (y - 2000.0) * (y - 2000.0) + 15.0 * std::sin(x / 130.0) * std::cos(y / 170.0);
  };
  for (int j = 0; j < 401; ++j)
    for (int i = 0; i < 401; ++i) terrain->heights.at(i, j) = static_cast<float>(height(10.0 * i, 10.0 * j));
  auto model = std::make_shared<ModelData>();
  model->meshes = {spruce()};
  model->materials.resize(1);
  const CounterRandom random{7, 0x74726565u};
  for (std::size_t k = 0; k < trees; ++k) {
    const UInt4 words = random.words(k, 0);
    const double x = 1300.0 + 1400.0 * toUnitDouble(words.x, words.y);
    const double y = 1500.0 + 1000.0 * toUnitDouble(words.z, words.w);
    model->instances.push_back({0, translationOf({x, y, height(x, y)})});
  }
  SceneNode node = makeNode(kModelType, "forest", "forest");
  ModelNode placed;
  placed.onGround = placed.catchesSnow = placed.fineCover = false;
  node.data = std::make_shared<ModelNode>(placed);
  scene.nodes = {makeNode(kTerrainType, "terrain", "terrain"), node};
  scene.terrain = terrain;
  scene.models["forest"] = model;
  return scene;
}

/// Share of points on the ground for which map and ray disagree; points on a shadow's edge count by halves.
double disagreement(const SceneSnapshot& snapshot, const SnowScene& scene, const OcclusionMap& map) {
  constexpr std::uint64_t kPoints = 20000;
  const TerrainSurface surface(snapshot.terrain->heights);
  const CounterRandom random{19, 0x70726f62u};
  double wrong = 0.0;
  for (std::uint64_t k = 0; k < kPoints; ++k) {
    const UInt4 words = random.words(k, 0);
    const double x = 1300.0 + 1400.0 * toUnitDouble(words.x, words.y);
    const double y = 1500.0 + 1000.0 * toUnitDouble(words.z, words.w);
    const double h = 0.5;
    const Vec3d p{x, y, surface.heightAt(x, y).value_or(0.0)};
    const Vec3d normal = normalized(
        Vec3d{surface.heightAt(x - h, y).value_or(p.z) - surface.heightAt(x + h, y).value_or(p.z),
              surface.heightAt(x, y - h).value_or(p.z) - surface.heightAt(x, y + h).value_or(p.z), 2.0 * h});
    std::uint8_t blocked = 0;
    const Ray ray = scene.towardsSky(p, normal, map.view().frame.n);
    scene.rays->occludedMany(&ray, 1, &blocked);
    wrong += std::abs(map.openness(p - scene.centre, normal) - (blocked ? 0.0 : 1.0));
  }
  return wrong / static_cast<double>(kPoints);
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const SceneSnapshot snapshot = forest(options.quick ? 60 : 300);
  const SnowGroundPointer ground = makeSnowGround(snapshot);
  const std::optional<SnowScene> scene = makeSnowScene(snapshot, *ground, 0.0, options.makeRayScene);
  const Occluders occluders(snapshot, *scene);
  CpuBackend backend(options.threads);
  std::vector<Vec3d> corners;
  for (int k = 0; k < 8; ++k)
    corners.push_back(Vec3d{k & 1 ? 2700.0 : 1300.0, k & 2 ? 2500.0 : 1500.0, k & 4 ? 110.0 : 0.0} -
                      scene->centre);
  std::vector<BenchRow> rows;
  for (const int size : options.quick ? std::vector<int>{1024} : std::vector<int>{512, 1024, 2048, 4096}) {
    const BenchMeter meter;
    BenchRow row;
    row.caseId = "exposure-map";
    row.settings = {{"map_size", std::to_string(size)}, {"triangles", std::to_string(occluders.size())}};
    const MapView view = MapView::round(corners, normalized(Vec3d{0.8, 0.3, -1.0}), 0.01, size);
    double fastest = 1e9;
    const std::clock_t cpuStart = std::clock();
    constexpr int kTimes = 5;
    for (int k = 0; k < kTimes; ++k) {
      const auto start = std::chrono::steady_clock::now();
      const OcclusionMap map(occluders, view, backend);
      fastest =
          std::min(fastest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    BenchMetric drawing{fastest, "s"};
    drawing.isTime = true;
    drawing.hasBar = backend.threads() == 2 && size == 1024;
    drawing.bar = 0.1;
    drawing.pass = !drawing.hasBar || fastest <= drawing.bar;
    row.metrics.emplace_back("drawing", drawing);
    row.addTime("cpu_seconds", static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC / kTimes, "s");
    row.addFigure("texel", view.texel, "m");
    row.addFigure("mean_error_against_rays",
                  disagreement(snapshot, *scene, OcclusionMap(occluders, view, backend)), "1");
    meter.finish(row);
    row.threads = backend.threads();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchCase exposureMapCase() {
  return {"exposure-map", "an occlusion map of a valley of 4 x 4 km with a million triangles",
          "0.1 s at 1024^2 on two threads; rays along the same direction", run};
}

}  // namespace spin
