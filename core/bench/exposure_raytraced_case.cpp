// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/bench/bench_case.h"
#include "core/bench/exposure_trial.h"
#include "core/bench/snow_bench_scene.h"

namespace spin {
namespace {

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const double wind : {2.0, 0.0}) {
    if (options.quick && wind == 0.0) continue;
    SnowBenchScene build;
    build.weather.windSpeed = wind;
    ExposureTrial trial = exposureTrial(std::make_shared<SceneSnapshot>(snowBenchSnapshot(build)), options);
    trial.settings = {{"scene", "valley"}, {"wind_m_s", fmt::format("{:g}", wind)}};
    auto measured = compareExposure(trial, options);
    if (!measured) return measured.error();
    for (BenchRow& row : measured.value()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchCase exposureRaytracedCase() {
  return {"exposure-raytraced", "exposure of the cover's cells in a valley with houses",
          "plain random rays over the same cells, 65,536 a cell (4,096 with --quick)", run};
}

}  // namespace spin
