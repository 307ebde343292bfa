// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_bench_scene.h"
#include "core/bench/worst.h"
#include "core/physics/blowing_snow.h"
#include "core/physics/snow_repose.h"
#include "core/snow/ground_wind.h"
#include "core/snow/snow_drift.h"
#include "core/snow/snow_smoothing.h"

namespace spin {
namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// What lies in a valley with houses, and where it went.
struct Ground {
  std::shared_ptr<const CoverGraph> graph;
  std::vector<double> depth, swe;
  double emitted = 0.0, left = 0.0, blownIn = 0.0, blownOut = 0.0, slid = 0.0, shed = 0.0, drifted = 0.0;

  double lying() const {
    double sum = 0.0;
    for (std::uint32_t c = 0; c < swe.size(); ++c) sum += swe[c] * static_cast<double>(graph->area(c));
    return sum;
  }
  double imbalance() const {
    const double sources = emitted + blownIn;
    return std::abs(sources - lying() - left - blownOut) / sources;
  }
  void snow(double amount, const CounterRandom& random, std::uint64_t step) {
    for (std::uint32_t c = 0; c < swe.size(); ++c) {
      if (!(graph->area(c) > 0.0f)) continue;
      const double gain = amount * 2.0 * random.uniformDouble(step * swe.size() + c);
      swe[c] += gain, depth[c] += gain / 110.0;
      emitted += gain * static_cast<double>(graph->area(c));
    }
  }
};

struct Times {
  double wind = 0.0, shelter = 0.0, slides = 0.0, smoothing = 0.0, drift = 0.0;
};

/// Snowfall, slides, smoothing and drift by turns.
class Storm {
 public:
  Storm(const SceneSnapshot& scene, const BenchOptions& options)
      : m_backend(options.threads), m_ground(makeSnowGround(scene)) {
    const auto standing = makeSnowScene(scene, *m_ground, 0.0, options.makeRayScene);
    SPIN_CHECK(standing.has_value(), "nobody cancels it");
    ground.graph = std::make_shared<const CoverGraph>(makeCoverGraph(*m_ground, &*standing));
    ground.depth.assign(ground.graph->size(), 0.0);
    ground.swe = ground.depth;
    m_obstacles = makeWindObstacles(scene, *m_ground, standing->models);
    const auto start = std::chrono::steady_clock::now();
    auto field = WindField::make(scene.terrain->heights, m_obstacles.tops, {}, m_backend);
    SPIN_CHECK(field.ok(), "the valley has ground");
    m_field = std::move(*field);
    times.wind = secondsSince(start);
  }

  void turnTo(Vec2d wind) {
    const auto start = std::chrono::steady_clock::now();
    m_wind = groundWind(*ground.graph, *m_field, m_obstacles, wind, m_drift.roughness, m_shelter, m_backend);
    times.shelter = secondsSince(start);
  }

  void step(double snowfall, double seconds, std::uint64_t number) {
    ground.snow(snowfall, {77, 5}, number);
    const CarriedSnow snow{ground.depth.data(), ground.swe.data()};
    slide(snow);
    SmoothingSettings smoothing;
    smoothing.spread = 0.01;
    auto start = std::chrono::steady_clock::now();
    smoothSnow(*ground.graph, snow, smoothing, m_backend);
    times.smoothing = secondsSince(start);
    start = std::chrono::steady_clock::now();
    blow(snow, seconds);
    times.drift = secondsSince(start);
  }

  Ground ground;
  Times times;
  std::size_t unsettled = 0;
  const WindField& field() const { return *m_field; }

 private:
  void slide(const CarriedSnow& snow) {
    const auto start = std::chrono::steady_clock::now();
    if (!m_slides) m_slides.emplace(ground.graph);
    const std::vector<float> tangents(ground.graph->size(),
                                      static_cast<float>(SnowRepose{}.tangent(0.0, 1.0)));
    const SlideTotals totals = m_slides->settle(snow, tangents.data(), {}, m_backend);
    ground.left += totals.left[1], ground.slid += totals.slid[1], ground.shed += totals.shed[1];
    unsettled = totals.unsettled;
    times.slides = secondsSince(start);
  }
  void blow(const CarriedSnow& snow, double seconds) {
    std::vector<float> friction, threshold(ground.graph->size());
    m_wind.sheltered(snow[0], m_shelter, m_backend, friction);
    for (std::size_t c = 0; c < threshold.size(); ++c) {
      const double density = snow[0][c] > 0.0 ? snow[1][c] / snow[0][c] : 100.0;
      threshold[c] = static_cast<float>(driftThreshold(-8.0, density, 0.0, m_drift.roughness));
    }
    SnowDrift drift(ground.graph);
    drift.setDirections(m_wind.direction);
    const DriftTotals totals = drift.blow(snow, 1, friction, threshold, m_drift, seconds);
    ground.blownIn += totals.blownIn[1], ground.blownOut += totals.blownOut[1];
    ground.drifted += totals.eroded[1];
  }

  CpuBackend m_backend;
  SnowGroundPointer m_ground;
  WindObstacles m_obstacles;
  std::optional<WindField> m_field;
  GroundWind m_wind;
  ShelterSettings m_shelter;
  DriftSettings m_drift;
  std::optional<SnowSlides> m_slides;
};

BenchRow massRow(const BenchOptions& options, double wind) {
  BenchRow row;
  row.caseId = "drift-mass";
  row.settings = {{"wind_m_s", fmt::format("{:g}", wind)}};
  const BenchMeter meter;
  SnowBenchScene build;
  build.cells = options.quick ? 40 : 128;
  Storm storm(snowBenchSnapshot(build), options);
  double imbalance = 0.0;
  for (std::uint64_t step = 0; step < 6; ++step) {
    const double turn = 0.9 * static_cast<double>(step);
    storm.turnTo({wind * std::cos(turn), wind * std::sin(turn)});
    storm.step(8.0, 1800.0, step);
    imbalance = worse(imbalance, storm.ground.imbalance());
  }
  row.addError("imbalance", imbalance, "1", 1e-9);
  row.addFigure("emitted", storm.ground.emitted, "kg");
  row.addFigure("slid", storm.ground.slid, "kg");
  row.addFigure("shed_off_models", storm.ground.shed, "kg");
  row.addFigure("slid_out", storm.ground.left, "kg");
  row.addFigure("taken_up_by_wind", storm.ground.drifted, "kg");
  row.addFigure("blown_in", storm.ground.blownIn, "kg");
  row.addFigure("blown_out", storm.ground.blownOut, "kg");
  meter.finish(row);
  return row;
}

/// Seconds for a million cells of a valley.
BenchRow speedRow(const BenchOptions& options) {
  BenchRow row;
  row.caseId = "drift-mass";
  const BenchMeter meter;
  SnowBenchScene build;
  build.cells = options.quick ? 100 : 1000;
  build.houses = 0;
  Storm storm(snowBenchSnapshot(build), options);
  for (std::uint64_t step = 0; step < 3; ++step) {
    storm.turnTo({9.0, 4.0});
    storm.step(5.0, 1800.0, step);
  }
  const double million = static_cast<double>(storm.ground.graph->size()) / 1e6;
  row.settings = {{"cells", fmt::format("{}", storm.ground.graph->size())}};
  row.addTime("slides_per_million_cells", storm.times.slides / million, "s");
  row.addTime("smoothing_per_million_cells", storm.times.smoothing / million, "s");
  row.addTime("drift_per_million_cells", storm.times.drift / million, "s");
  row.addTime("shelter_per_million_cells", storm.times.shelter / million, "s");
  row.addTime("wind_field", storm.times.wind, "s");
  row.addFigure("wind_divergence", storm.field().divergence(), "1");
  row.addFigure("unsettled_cells", static_cast<double>(storm.unsettled), "1");
  meter.finish(row);
  return row;
}

}  // namespace

BenchCase driftMassCase() {
  return {"drift-mass", "snow that slides, is smoothed and drifts in a valley with houses; time of each",
          "emitted + blown in = lying + slid out + blown out",
          [](const BenchOptions& options) -> Result<std::vector<BenchRow>> {
            std::vector<BenchRow> rows;
            const std::vector<double> winds =
                options.quick ? std::vector<double>{12.0} : std::vector<double>{0.0, 8.0, 15.0, 60.0};
            for (const double wind : winds) rows.push_back(massRow(options, wind));
            rows.push_back(speedRow(options));
            return rows;
          }};
}

}  // namespace spin
