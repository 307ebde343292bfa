// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/snow_run.h"
#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "core/snow/flake_field.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

template <class T>
SceneNode nodeOf(const NodeType& type, const T& data) {
  SceneNode node = makeNode(type, type.id, type.id);
  node.data = std::make_shared<T>(data);
  return node;
}

/// Mass flux of the scaled spectrum by a plain trapezoidal sum, apart from the quadrature that scales it.
double fluxOf(const SizeSpectrum& spectrum) {
  constexpr int kSteps = 200000;
  const double end = 50.0 / spectrum.slope, h = end / kSteps;
  double sum = 0.0;
  for (int k = 1; k < kSteps; ++k) {
    const double x = k * h, m = massOfMeltedDiameter(x);
    sum += spectrum.intercept * std::exp(-spectrum.slope * x) * m *
           spectrum.law.terminalSpeed(spectrum.law.diameterOfMass(m));
  }
  return sum * h;
}

struct Drawn {
  double moments[3] = {};  ///< mean melted diameter, its square, its cube; m, m2, m3
  double flux = 0.0;       ///< kg/(m2 s)
};

/// What the flakes of a frame add up to.
Drawn drawnFrom(const FallingFlakes& flakes, const SnowfallNode& snowfall) {
  Drawn drawn;
  const auto groups = flakeGroups(snowfall, flakes.numberDensity);
  const FlakeField field(flakes.seed, groups);
  const double n = static_cast<double>(field.size());
  std::size_t k = 0;
  for (const FlakeGroup& group : groups)
    for (std::uint32_t flake = 0; flake < group.flakes(); ++flake, ++k) {
      const FlakeClass one = flakeAt(flakes, field.classOf(k));
      const double x = meltedDiameterOfMass(one.mass);
      drawn.moments[0] += x / n, drawn.moments[1] += x * x / n, drawn.moments[2] += x * x * x / n;
      drawn.flux += group.weight / std::pow(group.box, 3) * one.mass * one.fallSpeed /
                    static_cast<double>(groups.size());
    }
  return drawn;
}

Result<BenchRow> measure(FlakeType type, const char* id, double rate, int flakes) {
  BenchRow row;
  row.caseId = "size-spectrum";
  row.settings = {{"type", id}, {"rate_mm_h", fmt::format("{:g}", rate)}, {"flakes", std::to_string(flakes)}};
  const BenchMeter meter;
  WeatherNode weather;
  weather.precipitationRate = millimetresPerHourToSi(rate);
  SnowfallNode snowfall;
  snowfall.type = type;
  snowfall.flakeCount = flakes;
  SceneSnapshot scene;
  scene.nodes = {nodeOf(kWeatherType, weather), nodeOf(kSnowfallType, snowfall),
                 nodeOf(kSimulationType, SimulationNode{})};
  SnowRun run(scene, makeBvhRayScene);
  if (const Status status = run.run(2); !status) return status.error();
  const Frame frame = run.frame();
  const SizeSpectrum spectrum = makeSizeSpectrum(fallLaw(type), weather.precipitationRate);
  const Drawn drawn = drawnFrom(frame.part<FlakesPart>("flakes")->flakes, snowfall);
  // Moments of an exponential law in the published slope: n!/Lambda^n.
  const double lambda = 2290.0 * std::pow(rate, -0.45);
  row.addError("moment_1_error", std::abs(drawn.moments[0] * lambda - 1.0), "1", 0.02);
  row.addError("moment_2_error", std::abs(drawn.moments[1] * lambda * lambda / 2.0 - 1.0), "1", 0.02);
  row.addError("moment_3_error", std::abs(drawn.moments[2] * std::pow(lambda, 3) / 6.0 - 1.0), "1", 0.02);
  row.addError("flux_error", std::abs(fluxOf(spectrum) / weather.precipitationRate - 1.0), "1", 1e-3);
  row.addError("drawn_flux_error", std::abs(drawn.flux / weather.precipitationRate - 1.0), "1", 0.02);
  row.addFigure("flakes_per_m3", spectrum.numberDensity, "1/m3");
  row.addFigure("flakes_per_m3_unscaled", publishedSpectrumIntercept(weather.precipitationRate) / lambda,
                "1/m3");
  row.addFigure("mean_fall_speed", spectrum.meanFallSpeed, "m/s");
  meter.finish(row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  const std::vector<double> rates =
      options.quick ? std::vector<double>{1.0, 5.0} : std::vector<double>{0.5, 1, 2, 5, 10};
  for (const double rate : rates)
    for (const auto& [type, id] : {std::pair{FlakeType::UnrimedDendriteAggregate, "dendrite_aggregate"},
                                   {FlakeType::RimedDendriteAggregate, "rimed_aggregate"},
                                   {FlakeType::HexagonalGraupel, "graupel"}}) {
      auto row = measure(type, id, rate, 20000);
      if (!row) return row.error();
      rows.push_back(std::move(row.value()));
    }
  return rows;
}

}  // namespace

BenchCase sizeSpectrumCase() {
  return {"size-spectrum", "moments and mass flux of the flakes drawn", "Sekhon and Srivastava 1970", run};
}

}  // namespace spin
