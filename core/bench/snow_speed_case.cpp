// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/snow/ground_materials.h"
#include "core/snow/snow_cells.h"

namespace spin {
namespace {

/// Cells over 2000 m of height and all slopes, a quarter of them each on another ground.
SnowCells valley(std::size_t count) {
  SnowCells cells(count,
                  {groundMaterial(GroundType::Soil), groundMaterial(GroundType::Vegetation),
                   groundMaterial(GroundType::Rock), groundMaterial(GroundType::Asphalt)},
                  {});
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(count);
    cells.setMaterial(i, static_cast<std::uint8_t>(i / 7 % 4));
    cells.setSoil(i, {2.0f, 4.0f, 6.0f, 8.0f});
    cells.setting(kAirOffset)[i] = static_cast<float>(6.0 - 13.0 * at);
    cells.setting(kBeamFactor)[i] = static_cast<float>(0.5 + 0.5 * std::sin(static_cast<double>(i % 360)));
    cells.setting(kSkyView)[i] = static_cast<float>(0.85 + 0.1 * std::cos(static_cast<double>(i % 97)));
  }
  return cells;
}

/// Days that snow, thaw and freeze in turn.
SnowStepWeather hourOf(int hour) {
  SnowStepWeather w;
  const double day = std::max(0.0, std::sin(2.0 * kPi * (hour % 24 - 6) / 24.0));
  w.airTemperature = static_cast<float>(-2.0 + 4.0 * day + 3.0 * std::sin(hour / 30.0));
  w.directShortwave = static_cast<float>(400.0 * day);
  w.diffuseShortwave = static_cast<float>(100.0 * day);
  w.longwave = 270.0f;
  w.snowfall = hour % 40 < 12 ? 1e-3f : 0.0f;
  w.wind = 3.0f;
  w.splitByTemperature = true;
  return w;
}

struct StepSeconds {
  double wall = 0.0, cpu = 0.0;  ///< median wall time, mean processor time of all threads
  double massResidual = 0.0;     ///< share
};

StepSeconds timeHours(SnowCells& cells, CpuBackend& backend, Isa isa, int spinUp, int hours) {
  const double before = cells.mass();
  SnowStepTotals all;
  for (int h = 0; h < spinUp; ++h) all += cells.advance(hourOf(h), backend, isa);
  std::vector<double> walls;
  const std::clock_t cpuStart = std::clock();
  for (int h = 0; h < hours; ++h) {
    const auto start = std::chrono::steady_clock::now();
    all += cells.advance(hourOf(spinUp + h), backend, isa);
    walls.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  StepSeconds seconds;
  seconds.cpu = static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC / hours;
  std::nth_element(walls.begin(), walls.begin() + hours / 2, walls.end());
  seconds.wall = walls[static_cast<std::size_t>(hours / 2)];
  const double fell = all[SnowStepTotals::kSnowIn] + all[SnowStepTotals::kRainIn];
  seconds.massResidual = std::abs(cells.mass() - before - all.massIn()) / fell;
  return seconds;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  const std::size_t count = options.quick ? 100'000 : 1'000'000;
  const int spinUp = options.quick ? 48 : 96;
  std::vector<Isa> sets = runnableIsas();
  if (options.isa != "auto" || options.quick) {
    const Result<Isa> isa = chooseIsa(options.isa);
    if (!isa) return isa.error();
    sets = {*isa};
  }
  std::vector<BenchRow> rows;
  for (auto isa = sets.rbegin(); isa != sets.rend(); ++isa) {
    const BenchMeter meter;
    BenchRow row;
    row.caseId = "snow-speed";
    row.settings = {{"cells", fmt::format("{}", count)}};
    CpuBackend backend(options.threads);
    SnowCells cells = valley(count);
    const StepSeconds seconds = timeHours(cells, backend, *isa, spinUp, 9);
    const double million = 1e6 / static_cast<double>(count);
    BenchMetric hour{seconds.wall * million, "s"};
    hour.isTime = true;
    hour.hasBar = backend.threads() == 2;
    hour.bar = 0.15;
    hour.pass = !hour.hasBar || hour.value <= hour.bar;
    row.metrics.emplace_back("seconds_per_million_cells_and_hour", hour);
    // Says on a busy machine what a free one would do.
    row.addTime("cpu_seconds_per_million_cells_and_hour", seconds.cpu * million, "s");
    row.addError("mass_residual", seconds.massResidual, "1", 1e-6);
    meter.finish(row);
    row.isa = isaName(*isa);
    row.threads = backend.threads();
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchCase snowSpeedCase() {
  return {"snow-speed", "an hour of energy balance for a million snow columns with soil, each computed",
          "0.15 s on two threads; FSM takes about 4 us a column", run};
}

}  // namespace spin
