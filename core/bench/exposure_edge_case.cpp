// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/snow/snow_scene.h"

namespace spin {
namespace {

constexpr double kHeight = 4.0;  ///< m, of the roof's edge above the ground

/// A wide roof that ends at x = 0, over level ground.
SnowScene roofScene(const RaySceneFactory& makeRayScene) {
  SnowScene scene;
  scene.rays = makeRayScene();
  const auto h = static_cast<float>(kHeight);
  scene.rays->addTriangles({{-200, -200, h}, {0, -200, h}, {0, 200, h}, {-200, 200, h}}, {0, 1, 2, 0, 2, 3});
  scene.rays->addTriangles({{-200, -200, 0}, {200, -200, 0}, {200, 200, 0}, {-200, 200, 0}},
                           {0, 1, 2, 0, 2, 3});
  scene.rays->commit();
  return scene;
}

/// Share of a planar fan of fall directions, even in angle within +-spread, that reaches the ground at x.
double fanExposure(const SnowScene& scene, double x, double spread, int rays) {
  std::vector<Ray> fan;
  for (int k = 0; k < rays; ++k) {
    const double angle = spread * (2.0 * (k + 0.5) / rays - 1.0);
    fan.push_back(scene.towardsSky({x, 0, 0}, {0, 0, 1}, {std::sin(angle), 0, -std::cos(angle)}));
  }
  std::vector<std::uint8_t> blocked(fan.size());
  scene.rays->occludedMany(fan.data(), fan.size(), blocked.data());
  return static_cast<double>(std::count(blocked.begin(), blocked.end(), 0)) / rays;
}

BenchRow measure(const BenchOptions& options, double spreadDegrees, int rays) {
  BenchRow row;
  row.caseId = "exposure-edge";
  row.settings = {{"spread_deg", std::to_string(static_cast<int>(spreadDegrees))},
                  {"rays", std::to_string(rays)}};
  const BenchMeter meter;
  const SnowScene scene = roofScene(options.makeRayScene);
  row.settings["caster"] = scene.rays->name();
  const double spread = degreesToRadians(spreadDegrees);
  double worst = 0.0;
  for (double x = -6.0; x <= 6.0; x += 0.017) {
    const double expected = std::clamp((spread - std::atan(-x / kHeight)) / (2.0 * spread), 0.0, 1.0);
    worst = std::max(worst, std::abs(fanExposure(scene, x, spread, rays) - expected));
  }
  row.addError("exposure_error_max", worst, "1", 0.01);
  meter.finish(row);
  return row;
}

}  // namespace

BenchCase exposureEdgeCase() {
  return {"exposure-edge", "shelter behind a roof's edge", "closed form: clamp((a - atan(-x/H))/(2a), 0, 1)",
          [](const BenchOptions& options) -> Result<std::vector<BenchRow>> {
            std::vector<BenchRow> rows;
            for (const double spread : {5.0, 15.0, 45.0})
              for (const int rays : {64, 1024}) rows.push_back(measure(options, spread, rays));
            return rows;
          }};
}

}  // namespace spin
