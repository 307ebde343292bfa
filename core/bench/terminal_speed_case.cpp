// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/bench/bench_case.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"
#include "core/nodes/weather_nodes.h"
#include "core/physics/drag.h"
#include "core/snow/snow_weather.h"

namespace spin {
namespace {

constexpr Vec3d kDown{0.0, 0.0, -kStandardGravity};

/// Velocity relative to the air after five relaxation times in steps of h, by the flakes' own integrator.
Vec3d relativeVelocityAfterFive(double terminalSpeed, Vec3d start, Vec3d wind, double h) {
  const double end = 5.0 * relaxationTime(terminalSpeed, kStandardGravity);
  Vec3d velocity = start;
  for (double t = 0.0; t < end - 1e-12; t += h)
    dragAdvance(velocity, wind, terminalSpeed, kDown, std::min(h, end - t));
  return velocity - wind;
}

struct TypeName {
  FlakeType type;
  const char* id;
  double speedAt1mm, exponent;  ///< Locatelli and Hobbs 1974, typed in again, not read from the law
};
constexpr TypeName kTypes[] = {{FlakeType::UnrimedDendriteAggregate, "dendrite_aggregate", 0.8, 0.16},
                               {FlakeType::RimedDendriteAggregate, "rimed_aggregate", 0.79, 0.27},
                               {FlakeType::HexagonalGraupel, "graupel", 0.86, 0.25}};

BenchRow measure(const TypeName& name, double h) {
  BenchRow row;
  row.caseId = "terminal-speed";
  row.settings = {{"type", name.id}, {"step_s", fmt::format("{:.4g}", h)}};
  const BenchMeter meter;
  const FlakeFallLaw& law = fallLaw(name.type);
  double fromRest = 0.0, fromFast = 0.0, sideways = 0.0;
  for (const double millimetres : {0.5, 1.0, 2.0, 4.0, 8.0, 12.0}) {
    const double reference = name.speedAt1mm * std::pow(millimetres, name.exponent);
    const double v = law.terminalSpeed(millimetres * 1e-3);
    const auto error = [&](Vec3d relative) { return std::abs(-relative.z / reference - 1.0); };
    fromRest = worse(fromRest, error(relativeVelocityAfterFive(v, {}, {}, h)));
    fromFast = worse(fromFast, error(relativeVelocityAfterFive(v, {0, 0, -10}, {}, h)));
    const Vec3d blown = relativeVelocityAfterFive(v, {}, {10, 5, 0}, h);
    sideways = worse(sideways, std::hypot(blown.x, blown.y) / reference);
  }
  row.addError("speed_error_from_rest", fromRest, "1", 0.01);
  row.addError("speed_error_from_10_m_s", fromFast, "1", 0.01);
  row.addFigure("slip_against_wind", sideways, "1");
  meter.finish(row);
  return row;
}

}  // namespace

BenchCase terminalSpeedCase() {
  return {"terminal-speed", "fall speed after five relaxation times by the drag law",
          "Locatelli and Hobbs 1974", [](const BenchOptions&) -> Result<std::vector<BenchRow>> {
            std::vector<BenchRow> rows;
            for (const TypeName& name : kTypes)
              for (const double h : {1.0, 1.0 / 24.0, 1.0 / 240.0}) rows.push_back(measure(name, h));
            return rows;
          }};
}

}  // namespace spin
