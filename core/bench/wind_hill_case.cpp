// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/snow/wind_field.h"

namespace spin {
namespace {

/// Height z(r) = h/(1 + (r/L)^2) of a ridge or a round hill: L is half its width at half its height.
Raster<float> hill(int cells, double cell, double height, double halfWidth, bool round) {
  Raster<float> ground(cells, cells, 0.0, 0.0, cell);
  const double middle = 0.5 * cell * (cells - 1);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const double x = ground.x(i) - middle, y = round ? ground.y(j) - middle : 0.0;
      ground.at(i, j) = static_cast<float>(height / (1.0 + (x * x + y * y) / (halfWidth * halfWidth)));
    }
  return ground;
}

Result<BenchRow> measure(const BenchOptions& options, double height, double halfWidth, bool round) {
  BenchRow row;
  row.caseId = "wind-hill";
  row.settings = {{"shape", round ? "hill" : "ridge"},
                  {"height_m", fmt::format("{:g}", height)},
                  {"half_width_m", fmt::format("{:g}", halfWidth)}};
  const BenchMeter meter;
  CpuBackend backend(options.threads);
  const int cells = options.quick ? 64 : 128;
  const double cell = 12.8 * halfWidth / cells;
  const auto field = WindField::make(hill(cells, cell, height, halfWidth, round), {}, {}, backend);
  if (!field) return field.error();
  const double middle = 0.5 * cell * (cells - 1);
  // Taylor and Lee 1984; their guide holds for h/L up to a half.
  const double expected = (round ? 1.6 : 2.0) * height / halfWidth;
  const double measured = field->speedUp(middle, middle, 2.0, {10.0, 0.0}) - 1.0;
  row.addFigure("speed_up_at_2_m", measured, "1");
  row.addFigure("guide", expected, "1");
  row.addError("relative_error", std::abs(measured / expected - 1.0), "1", 0.25);
  const double decay = std::exp(-(round ? 4.0 : 3.0) * 0.25);
  row.addFigure("speed_up_at_quarter_half_width",
                field->speedUp(middle, middle, 0.25 * halfWidth, {10.0, 0.0}) - 1.0, "1");
  row.addFigure("guide_there", expected * decay, "1");
  row.addFigure("before_the_hill", field->speedUp(middle - 3.0 * halfWidth, middle, 2.0, {10.0, 0.0}) - 1.0,
                "1");
  row.addError("divergence", field->divergence(), "1", 1e-4);
  row.addFigure("iterations", field->iterations(), "1");
  meter.finish(row);
  return row;
}

}  // namespace

BenchCase windHillCase() {
  return {"wind-hill", "speed-up of the mass-consistent wind on crests",
          "Taylor and Lee 1984: 2 h/L on ridges, 1.6 h/L on round hills",
          [](const BenchOptions& options) -> Result<std::vector<BenchRow>> {
            std::vector<BenchRow> rows;
            for (const bool round : {false, true})
              for (const auto& [height, halfWidth] :
                   {std::pair{10.0, 100.0}, {20.0, 200.0}, {40.0, 200.0}, {100.0, 1000.0}, {400.0, 1000.0}}) {
                auto row = measure(options, height, halfWidth, round);
                if (!row) return row.error();
                rows.push_back(std::move(row.value()));
              }
            return rows;
          }};
}

}  // namespace spin
