// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "core/base/units.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"
#include "core/physics/heat_row.h"
#include "core/snow/snow_cells.h"

namespace spin {
namespace {

using Totals = SnowStepTotals;
using Rows = Result<std::vector<BenchRow>>;

/// A cell of wet snow at 0 degC on ground at 0 degC, in air that takes and gives nothing.
SnowCells meltingCell(double swe) {
  SnowParameters p;
  p.emissivity = 0.0f;
  p.windlessExchange = 0.0f;
  p.freshAlbedo = p.oldAlbedo = 0.0f;
  GroundMaterial ground;
  ground.albedo = 0.0f;
  SnowCells cells(1, {ground}, p);
  SnowColumn<float> c = cells.column(0);
  c.albedo = 0.0f;
  c.snow[2].ice = static_cast<float>(swe);
  c.snow[2].depth = static_cast<float>(swe / 300.0);
  cells.setColumn(0, c);
  return cells;
}

Rows runFixedFlux(const BenchOptions& options) {
  CpuBackend backend(1);
  const Result<Isa> isa = chooseIsa(options.isa);
  std::vector<BenchRow> rows;
  for (const double step : {3600.0, 600.0}) {
    const BenchMeter meter;
    BenchRow row;
    row.caseId = "melt-fixed-flux";
    row.settings = {{"step_s", fmt::format("{:g}", step)}};
    SnowCells cells = meltingCell(500.0);
    SnowStepWeather w;
    w.seconds = static_cast<float>(step);
    w.diffuseShortwave = 100.0f;
    w.relativeHumidity = 1.0f;  // over water, which at 0 degC is as over ice
    w.wind = 0.0f;
    double melted = 0.0;
    for (double t = 0.0; t < 86400.0; t += step)
      melted += cells.advance(w, backend, isa ? *isa : bestIsa())[Totals::kMelted];
    row.addFigure("melted", melted, "mm");
    row.addError("relative_error", std::abs(melted / 25.868 - 1.0), "1", 1e-4);
    meter.finish(row);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Greatest error against erfc(z / (2 sqrt(alpha t))) of a step of 1 K at the surface, in layers' middles.
template <int kLayers>
double conductionError(const double (&thickness)[kLayers], double step, double time) {
  constexpr double kConductivity = 0.6276, kHeatCapacity = 2.2e6;
  HeatRow<double, kLayers> row{};
  for (int i = 0; i < kLayers; ++i) {
    row.storage[i] = kHeatCapacity * thickness[i] / step;
    row.resistance[i] = 0.5 * thickness[i] / kConductivity;
  }
  const double steps = std::round(time / step);
  for (double s = 0.0; s < steps; ++s) {
    sweepUp(row);
    sweepDown(row, row.below[0].conductance * (1.0 - row.below[0].temperature), 1.0);
    for (int i = 0; i < kLayers; ++i) row.temperature[i] += row.gain(i) / row.storage[i];
  }
  double worst = 0.0, top = 0.0;
  for (int i = 0; i < kLayers; ++i) {
    const double z = top + 0.5 * thickness[i];
    const double exact = std::erfc(z / (2.0 * std::sqrt(kConductivity / kHeatCapacity * steps * step)));
    worst = worse(worst, std::abs(row.temperature[i] - exact));
    top += thickness[i];
  }
  return worst;
}

Rows runConduction(const BenchOptions& options) {
  constexpr double kDay = 86400.0;
  double fine[100];
  for (double& thickness : fine) thickness = 0.02;
  double own[kSoilLayers];
  for (int i = 0; i < kSoilLayers; ++i) own[i] = static_cast<double>(GroundMaterial{}.thickness[i]);
  std::vector<BenchRow> rows;
  for (const double step : {60.0, 600.0, 3600.0}) {
    if (options.quick && step < 100.0) continue;
    const BenchMeter meter;
    BenchRow row;
    row.caseId = "conduction-step";
    row.settings = {{"layers", "100 of 2 cm"}, {"step_s", fmt::format("{:g}", step)}};
    row.addError("error_after_a_day", conductionError(fine, step, kDay), "K/K", 0.01);
    row.addError("error_after_ten_days", conductionError(fine, step, 10.0 * kDay), "K/K", 0.01);
    meter.finish(row);
    rows.push_back(std::move(row));
  }
  BenchRow row;
  row.caseId = "conduction-step";
  row.settings = {{"layers", "the soil column's four"}, {"step_s", "3600"}};
  for (const double days : {1.0, 10.0, 60.0})
    row.addFigure(fmt::format("error_after_{:g}_days", days), conductionError(own, 3600.0, days * kDay),
                  "K/K");
  rows.push_back(std::move(row));
  return rows;
}

struct Swing {
  double mean, amplitude, reference;  // K; the reference typed in from its paper's table
};
constexpr Swing kSwings[] = {{0.0, 5.0, 1.59155}, {2.0, 5.0, 2.72066}, {-2.0, 5.0, 0.72066}};

/// Mean degrees above zero over a day that cells see in steps, from what they melt.
double steppedDegrees(const Swing& swing, double step, Isa isa) {
  CpuBackend backend(1);
  SnowCells cells = meltingCell(500.0);
  cells.law = MeltLaw::DegreeDay;
  SnowStepWeather w;
  w.seconds = static_cast<float>(step);
  double melted = 0.0;
  for (double t = 0.5 * step; t < 86400.0; t += step) {
    w.airTemperature = static_cast<float>(swing.mean + swing.amplitude * std::sin(2.0 * kPi * t / 86400.0));
    melted += cells.advance(w, backend, isa)[Totals::kMelted];
  }
  return melted / (static_cast<double>(cells.degreeDay.factor) * 86400.0);
}

Rows runDegreeDay(const BenchOptions& options) {
  const Result<Isa> isa = chooseIsa(options.isa);
  std::vector<BenchRow> rows;
  for (const Swing& swing : kSwings) {
    const BenchMeter meter;
    BenchRow row;
    row.caseId = "degree-day";
    row.settings = {{"mean", fmt::format("{:g}", swing.mean)},
                    {"amplitude", fmt::format("{:g}", swing.amplitude)}};
    row.addError("closed_form_error",
                 std::abs(positiveDegreeMean(swing.mean, swing.amplitude) - swing.reference), "K", 1e-4);
    const auto error = [&](double step) {
      return std::abs(steppedDegrees(swing, step, isa ? *isa : bestIsa()) - swing.reference);
    };
    row.addError("error_in_steps_of_60_s", error(60.0), "K", 1e-4);
    row.addFigure("error_in_steps_of_3600_s", error(3600.0), "K");
    meter.finish(row);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

BenchCase meltFixedFluxCase() {
  return {"melt-fixed-flux", "melt of wet snow that absorbs 100 W/m2 for a day",
          "25.868 mm: flux over latent heat", runFixedFlux};
}

BenchCase conductionStepCase() {
  return {"conduction-step", "soil temperatures after a step at the surface", "erfc(z / (2 sqrt(alpha t)))",
          runConduction};
}

BenchCase degreeDayCase() {
  return {"degree-day", "degrees above zero of a day whose temperature swings as a sine",
          "(m arccos(-m/A) + sqrt(A^2 - m^2)) / pi", runDegreeDay};
}

}  // namespace spin
