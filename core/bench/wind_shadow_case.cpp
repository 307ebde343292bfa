// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/worst.h"
#include "core/snow/exposure_process.h"

namespace spin {
namespace {

constexpr double kHeight = 3.0;  ///< m, of the wall
constexpr double kWallX = 100.0, kWallY = 100.0;

std::shared_ptr<const ModelData> wall() {
  Mesh mesh;
  mesh.positions = {{0, -30, -1}, {0, 30, -1}, {0, 30, kHeight}, {0, -30, kHeight}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  auto model = std::make_shared<ModelData>();
  model->meshes = {std::move(mesh)};
  model->materials.resize(1);
  model->instances = {{0, Transform{}}};
  return model;
}

SceneSnapshot wallScene(double wind, double cell) {
  SnowBenchScene options;
  options.houses = 0;
  options.holes = false;
  options.cells = 41;
  options.weather.windSpeed = wind;
  options.weather.windFromDegrees = 270.0;  // it blows towards +x
  options.snowfall.fallSpreadDegrees = 0.0;
  options.snowfall.flakeCount = 0;
  options.simulation.exposureNoise = 0.0;
  SceneSnapshot scene = snowBenchSnapshot(options);
  auto terrain = std::make_shared<TerrainData>(*scene.terrain);
  std::fill(terrain->heights.values.begin(), terrain->heights.values.end(), 0.0f);
  scene.terrain = terrain;
  TerrainNode detail;
  detail.coverDetailCell = cell;
  detail.coverDetailMargin = 40.0;
  for (SceneNode& node : scene.nodes)
    if (node.type == &kTerrainType) node.data = std::make_shared<TerrainNode>(detail);
  ModelNode placed;
  placed.position = {kWallX, kWallY, 0.0};
  SceneNode node = makeNode(kModelType, "wall", "wall");
  node.data = std::make_shared<ModelNode>(placed);
  scene.nodes.push_back(node);
  scene.models["wall"] = wall();
  return scene;
}

/// Where the exposure behind the wall reaches a half, m from the wall, along the row through its middle.
double dryLength(const Raster<float>& grid, const std::vector<float>& exposure) {
  const int j = grid.row(kWallY + 0.25 * grid.cellSize);
  double dry = 0.0;
  for (int i = 0; i < grid.width; ++i)
    if (grid.x(i) > kWallX) dry += (1.0 - static_cast<double>(exposure[grid.index(i, j)])) * grid.cellSize;
  return dry;
}

Result<BenchRow> measure(const BenchOptions& options, double wind, double cell) {
  BenchRow row;
  row.caseId = "wind-shadow";
  row.settings = {{"wind_m_s", fmt::format("{:g}", wind)}, {"texel_m", fmt::format("{:g}", cell)}};
  const BenchMeter meter;
  const SceneSnapshot scene = wallScene(wind, cell);
  CpuBackend backend(options.threads);
  const CancelToken cancel;
  const SnowGroundPointer ground = makeSnowGround(scene);
  const auto standing = makeSnowScene(scene, *ground, 0.0, options.makeRayScene);
  SPIN_CHECK(standing.has_value(), "nobody cancels it");
  const auto field =
      makeExposureField(scene, *ground, *standing, exposureSettings(scene, 0.0), {backend, cancel, {}});
  if (!field) return field.error();
  SPIN_CHECK(ground->terrain.size() == 2, "the wall has one fine grid round it");
  const std::size_t g = ground->terrain[1].grid;
  const double fallSpeed = snowWeatherAt(scene, 0.0).spectrum.meanFallSpeed;
  const double expected = kHeight * wind / fallSpeed;
  const double measured = dryLength(ground->layout->grids[g].base, field->grids[g].exposure);
  row.addFigure("dry_length", measured, "m");
  row.addFigure("expected", expected, "m");
  row.addError("error_in_texels", std::abs(measured - expected) / ground->layout->grids[g].base.cellSize, "1",
               1.0);
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const double cell : options.quick ? std::vector<double>{0.5} : std::vector<double>{1.0, 0.5, 0.25})
    for (const double wind : {0.0, 1.0, 4.0, 9.0}) {
      auto row = measure(options, wind, cell);
      if (!row) return row.error();
      rows.push_back(std::move(row.value()));
    }
  return rows;
}

}  // namespace

BenchCase windShadowCase() {
  return {"wind-shadow", "ground that stays dry behind a wall in driven snow", "dry length L = H U/w_t", run};
}

}  // namespace spin
