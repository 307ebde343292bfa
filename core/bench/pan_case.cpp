// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/snow_run.h"
#include "core/nodes/camera_node.h"

namespace spin {
namespace {

struct Pan {
  const char* name;
  Vec3d from, to;  ///< m, of the camera over the film
};

SceneSnapshot seenFrom(const SnowBenchScene& options, const Pan& pan, double seconds) {
  SceneSnapshot scene = snowBenchSnapshot(options);
  SceneNode camera = makeNode(kCameraType, "camera", "camera");
  camera.curves["position_m"].setKey({0.0, pan.from, Interpolation::Linear});
  camera.curves["position_m"].setKey({seconds, pan.to, Interpolation::Linear});
  scene.nodes.push_back(camera);
  return scene;
}

/// Depths of a storm's last frame, m, of all cells one after the other.
Result<std::vector<float>> depthsAfter(const SceneSnapshot& scene, int frames, const BenchOptions& options) {
  SnowRun run(scene, options.makeRayScene, options.threads);
  if (const Status status = run.run(frames); !status) return status.error();
  const Frame frame = run.frame();
  const auto* cover = frame.part<CoverPart>("cover");
  SPIN_CHECK(cover, "the frame has a cover");
  std::vector<float> depths;
  for (const CoverPart::Values& grid : cover->values)
    depths.insert(depths.end(), grid.depth.begin(), grid.depth.end());
  return depths;
}

/// Largest change of a depth over the mean depth.
double largestChange(const std::vector<float>& a, const std::vector<float>& b) {
  double largest = 0.0, sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) {
    largest = std::max(largest, std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c])));
    sum += static_cast<double>(a[c]);
  }
  return sum > 0.0 ? largest * static_cast<double>(a.size()) / sum : HUGE_VAL;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  SnowBenchScene bench;
  bench.cells = options.quick ? 48 : 128;
  bench.weather.windSpeed = 3.0;
  bench.simulation.timeScale = 3600.0 * 24.0;  // an hour a frame
  bench.snowfall.flakeCount = 5000;
  const int frames = options.quick ? 2 : 24;
  const double seconds = static_cast<double>(frames) / 24.0;
  const Pan still{"still", {60, 60, 60}, {60, 60, 60}};
  const Pan pans[] = {{"across", {-200, 300, 20}, {900, 320, 25}}, {"towards", {60, 60, 600}, {300, 300, 8}}};
  std::vector<BenchRow> rows;
  for (const ExposureMethod method : {ExposureMethod::Rays, ExposureMethod::Maps}) {
    bench.simulation.exposureMethod = method;
    const auto held = depthsAfter(seenFrom(bench, still, seconds), frames, options);
    if (!held) return held.error();
    for (const Pan& pan : pans) {
      if (options.quick && &pan != pans) continue;
      BenchRow row;
      row.caseId = "pan";
      row.settings = {{"camera", pan.name}, {"exposure", method == ExposureMethod::Rays ? "rays" : "maps"}};
      const BenchMeter meter;
      const auto panned = depthsAfter(seenFrom(bench, pan, seconds), frames, options);
      if (!panned) return panned.error();
      SPIN_CHECK(panned->size() == held->size(), "the cover stands in the world");
      row.addFigure("cells", static_cast<double>(held->size()), "1");
      row.addFigure("deepest", static_cast<double>(*std::max_element(held->begin(), held->end())), "m");
      row.addError("largest_change", largestChange(*held, *panned), "1", 0.01);
      meter.finish(row);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace

BenchCase panCase() {
  return {"pan", "stored depth of a storm seen by a camera that flies, against one that stands",
          "the camera changes no depth", run};
}

}  // namespace spin
