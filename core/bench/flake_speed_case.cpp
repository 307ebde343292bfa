// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_run.h"
#include "core/nodes/settings_nodes.h"
#include "core/snow/flake_field.h"

namespace spin {
namespace {

template <class T>
SceneNode nodeOf(const NodeType& type, const T& data) {
  SceneNode node = makeNode(type, type.id, type.id);
  node.data = std::make_shared<T>(data);
  return node;
}

struct Seconds {
  double wall = 0.0, cpu = 0.0;  ///< median wall time, mean processor time of all threads
  double seen = 0.0;             ///< flakes told on average
};

/// Looks at the flakes again and again, from places that go along.
Seconds timeLooks(const FlakeField& field, const FallingFlakes& flakes, const std::vector<FlakeGroup>& groups,
                  FlakeView view, CpuBackend& backend, Isa isa, int looks) {
  FlakeRecords seen;
  field.look(flakes, groups, view, backend, seen, isa);  // memory comes with the first
  std::vector<double> walls;
  Seconds seconds;
  const std::clock_t cpuStart = std::clock();
  for (int k = 0; k < looks; ++k) {
    view.eye.x += 0.1;
    const auto start = std::chrono::steady_clock::now();
    field.look(flakes, groups, view, backend, seen, isa);
    walls.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    seconds.seen += static_cast<double>(seen.count) / looks;
  }
  seconds.cpu = static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC / looks;
  std::nth_element(walls.begin(), walls.begin() + looks / 2, walls.end());
  seconds.wall = walls[static_cast<std::size_t>(looks / 2)];
  return seconds;
}

FlakeView viewOf(bool camera) {
  FlakeView view;
  view.eye = {100.0, 50.0, 20.0};
  if (!camera) {
    view.leastFade = -1.0;
    return view;
  }
  view.tangentY = std::tan(degreesToRadians(22.5));
  view.tangentX = view.tangentY * 16.0 / 9.0;
  return view;
}

BenchRow measure(const FlakeField& field, const FallingFlakes& flakes, const std::vector<FlakeGroup>& groups,
                 bool camera, const BenchOptions& options, Isa isa) {
  const BenchMeter meter;
  BenchRow row;
  row.caseId = "flake-speed";
  row.settings = {{"flakes", fmt::format("{}", field.size())},
                  {"told", camera ? "in view of a camera" : "all, with velocity and fading"}};
  CpuBackend backend(options.threads);
  const Seconds seconds =
      timeLooks(field, flakes, groups, viewOf(camera), backend, isa, options.quick ? 5 : 31);
  const double million = 1e6 / static_cast<double>(field.size());
  BenchMetric frame{seconds.wall * million, "s"};
  frame.isTime = true;
  frame.hasBar = backend.threads() == 2;
  frame.bar = 0.015;
  frame.pass = !frame.hasBar || frame.value <= frame.bar;
  row.metrics.emplace_back("seconds_per_million_flakes", frame);
  // Says on a busy machine what a free one would do.
  row.addTime("cpu_seconds_per_million_flakes", seconds.cpu * million, "s");
  row.addFigure("flakes_told", seconds.seen, "1");
  meter.finish(row);
  row.isa = isaName(isa);
  row.threads = backend.threads();
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  WeatherNode weather;
  weather.windSpeed = 6.0;
  SnowfallNode snowfall;
  snowfall.flakeCount = options.quick ? 100'000 : 1'000'000;
  SceneSnapshot scene;
  scene.nodes = {nodeOf(kWeatherType, weather), nodeOf(kSnowfallType, snowfall),
                 nodeOf(kSimulationType, SimulationNode{})};
  SnowRun fall(scene, makeBvhRayScene);
  if (const Status status = fall.run(48); !status) return status.error();
  const Frame frame = fall.frame();
  const FallingFlakes& flakes = frame.part<FlakesPart>("flakes")->flakes;
  const auto groups = flakeGroups(snowfall, flakes.numberDensity);
  const FlakeField field(flakes.seed, groups);
  std::vector<Isa> sets = runnableIsas();
  if (options.isa != "auto" || options.quick) {
    const Result<Isa> isa = chooseIsa(options.isa);
    if (!isa) return isa.error();
    sets = {*isa};
  }
  std::vector<BenchRow> rows;
  for (auto isa = sets.rbegin(); isa != sets.rend(); ++isa)
    for (const bool camera : {false, true})
      rows.push_back(measure(field, flakes, groups, camera, options, *isa));
  return rows;
}

}  // namespace

BenchCase flakeSpeedCase() {
  return {"flake-speed",
          "places, velocities and fading of a million falling flakes in gusts, for one picture",
          "15 ms on two threads", run};
}

}  // namespace spin
