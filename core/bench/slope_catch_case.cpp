// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/snow_run.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kDensity = 100.0;  ///< kg/m3

SceneSnapshot slopeScene(double degrees, double spreadDegrees) {
  SnowBenchScene options;
  options.houses = 0;
  options.cells = 24;
  options.weather.windSpeed = 0.0;
  options.snowfall.fallSpreadDegrees = spreadDegrees;
  options.snowfall.flakeCount = 0;
  options.simulation.timeScale = 3600.0;
  options.simulation.exposureNoise = 0.0;
  options.simulation.holdsBelowDegrees = options.simulation.shedsAboveDegrees =
      90.0;  // all that arrives stays
  options.simulation.snowSlides = false;
  options.simulation.newSnowDensity = kDensity;
  SceneSnapshot scene = snowBenchSnapshot(options);
  auto terrain = std::make_shared<TerrainData>(*scene.terrain);
  Raster<float>& h = terrain->heights;
  // The line of greatest slope runs askew to the grid and its diagonals.
  const double rise = std::tan(degreesToRadians(degrees));
  for (int j = 0; j < h.height; ++j)
    for (int i = 0; i < h.width; ++i)
      h.at(i, j) = static_cast<float>(rise * (std::cos(0.4) * h.x(i) + std::sin(0.4) * h.y(j)));
  scene.terrain = terrain;
  return scene;
}

Result<BenchRow> measure(const BenchOptions& options, double degrees, double spreadDegrees) {
  BenchRow row;
  row.caseId = "slope-catch";
  row.settings = {{"slope_deg", fmt::format("{:g}", degrees)},
                  {"spread_deg", fmt::format("{:g}", spreadDegrees)}};
  const BenchMeter meter;
  const SceneSnapshot scene = slopeScene(degrees, spreadDegrees);
  SnowRun run(scene, options.makeRayScene, options.threads);
  if (const Status status = run.run(2); !status) return status.error();
  const Frame frame = run.frame();
  const double expected =
      scene.settings<WeatherNode>(0.0).precipitationRate * frame.info.time.weather / kDensity;
  double worst = 0.0, sum = 0.0;
  const auto* cover = frame.part<CoverPart>("cover");
  SPIN_CHECK(cover && !cover->values.empty(), "a slope without cover");
  const std::vector<float>& depth = cover->values[0].depth;
  for (const float d : depth) {
    const double error = static_cast<double>(d) / expected - 1.0;
    worst = worse(worst, std::abs(error));
    sum += error;
  }
  const double mean = std::abs(sum / static_cast<double>(depth.size()));
  if (spreadDegrees == 0.0)
    row.addError("depth_error_max", worst, "1", 1e-3);
  else
    row.addFigure("depth_error_max", worst, "1");
  row.addError("mean_depth_error", mean, "1", 1e-3);
  meter.finish(row);
  return row;
}

}  // namespace

BenchCase slopeCatchCase() {
  return {"slope-catch", "vertical depth that vertical snowfall lays on planes of all slopes",
          "equal depth: rate x time / density",
          [](const BenchOptions& options) -> Result<std::vector<BenchRow>> {
            std::vector<BenchRow> rows;
            for (const double spread : {0.0, 15.0})
              for (const double slope : {0.0, 10.0, 20.0, 30.0, 45.0, 60.0}) {
                auto row = measure(options, slope, spread);
                if (!row) return row.error();
                rows.push_back(std::move(row.value()));
              }
            return rows;
          }};
}

}  // namespace spin
