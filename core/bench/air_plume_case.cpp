// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/bench/air_bench_scene.h"
#include "core/bench/bench_meter.h"
#include "core/bench/straight_line.h"

namespace spin {
namespace {

/// Warm air from a disk on the floor, in air at rest with open sides and an open top.
struct PlumeRun {
  int wide = 64, high = 96;           ///< cells
  double spinUp = 12.0, mean = 24.0;  ///< s
};

constexpr double kWidth = 3.2, kSource = 0.2;  // m
constexpr double kHeat = 0.5;                  // K m3/s

AirConfig plume(const PlumeRun& run) {
  AirConfig c = stillBox({run.wide, run.wide, run.high}, kWidth / run.wide);
  c.closed = {false, false, false, false, true, false};
  c.gravity = {0, 0, -kStandardGravity};
  c.humidity = 0.0;
  return c;
}

/// The disk's cells, each with its share of the heat and a tenth of that at random, without which the plume
/// would stay as even as the lattice.
std::vector<AirSource> sources(const AirConfig& c, int wide, double seconds, std::uint64_t step) {
  const CounterRandom random{41, 2};
  std::vector<AirSource> all;
  for (int j = 0; j < wide; ++j)
    for (int i = 0; i < wide; ++i) {
      const Vec3d p{(i + 0.5) * c.cell, (j + 0.5) * c.cell, 0.5 * c.cell};
      if (std::hypot(p.x - 0.5 * kWidth, p.y - 0.5 * kWidth) > kSource) continue;
      AirSource source;
      source.position = p;
      const auto id = step * 1000003u + static_cast<std::uint64_t>(all.size());
      source.amounts[static_cast<std::size_t>(AirScalar::Warmth)] = 0.9 + 0.2 * random.uniformDouble(id);
      all.push_back(source);
    }
  for (AirSource& source : all)
    source.amounts[static_cast<std::size_t>(AirScalar::Warmth)] *=
        kHeat * seconds / static_cast<double>(all.size());
  return all;
}

/// Mean vertical velocity of every cell.
struct MeanFlow {
  std::vector<double> w;
  int samples = 0;

  void add(const AirBox& box) {
    w.resize(static_cast<std::size_t>(box.cells()[0]) * static_cast<std::size_t>(box.cells()[1]) *
             static_cast<std::size_t>(box.cells()[2]));
    std::size_t at = 0;
    box.forEach([&](int i, int j, int k) {
      w[at++] += 0.5 * static_cast<double>(box.face(2, i, j, k) + box.face(2, i, j, k + 1));
    });
    ++samples;
  }
};

/// Width and speed of the plume by its fluxes of volume and momentum, b = Q / sqrt(pi M), w = M / Q (Morton,
/// Taylor and Turner 1956), where it rises by more than a twentieth of its fastest.
struct Level {
  double z, width, speed;
};
std::vector<Level> levels(const MeanFlow& flow, const PlumeRun& run, double cell) {
  std::vector<Level> all;
  const auto area = static_cast<std::size_t>(run.wide) * static_cast<std::size_t>(run.wide);
  // Above the source's own flow and below what the open top does to it.
  for (int k = run.high / 5; k < 3 * run.high / 4; ++k) {
    const double* w = &flow.w[static_cast<std::size_t>(k) * area];
    const double fastest = *std::max_element(w, w + area);
    double volume = 0.0, momentum = 0.0;
    for (std::size_t c = 0; c < area; ++c)
      if (w[c] > 0.05 * fastest) {
        volume += w[c] * cell * cell;
        momentum += w[c] * w[c] * cell * cell / flow.samples;
      }
    volume /= flow.samples;
    momentum /= flow.samples;
    all.push_back({(k + 0.5) * cell, volume / std::sqrt(kPi * momentum), momentum / volume});
  }
  return all;
}

void tell(const std::vector<Level>& all, bool bars, BenchRow& row) {
  std::vector<double> z, width, logZ, logWidth, logSpeed;
  for (const Level& level : all) {
    z.push_back(level.z);
    width.push_back(level.width);
  }
  const StraightLine line = fitLine(z, width);
  const double virtualOrigin = -line.offset / line.slope;
  for (const Level& level : all) {
    logZ.push_back(std::log(level.z - virtualOrigin));
    logWidth.push_back(std::log(level.width));
    logSpeed.push_back(std::log(level.speed));
  }
  const double widens = fitLine(logZ, logWidth).slope, slows = fitLine(logZ, logSpeed).slope;
  if (bars) {
    row.addError("width_exponent_error", std::abs(widens - 1.0), "1", 0.1);
    row.addError("speed_exponent_error", std::abs(slows + 1.0 / 3.0), "1", 0.1);
  }
  row.addFigure("width_exponent", widens, "1");
  row.addFigure("speed_exponent", slows, "1");
  row.addFigure("entrainment", line.slope / 1.2, "1");
  row.addFigure("virtual_origin", virtualOrigin, "m");
  row.addFigure("speed_middle", all[all.size() / 2].speed, "m/s");
}

Result<BenchRow> measure(const BenchOptions& options, const PlumeRun& run) {
  BenchRow row;
  row.caseId = "plume";
  row.settings = {{"cells", fmt::format("{0} x {0} x {1}", run.wide, run.high)}};
  const BenchMeter meter;
  const AirConfig config = plume(run);
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  const double step = 0.8 * config.cell;  // s: air of about 1.5 m/s goes about a cell
  const int spinUp = static_cast<int>(run.spinUp / step), steps = spinUp + static_cast<int>(run.mean / step);
  MeanFlow flow;
  for (int s = 0; s < steps; ++s) {
    if (Status put = (*solver)->add(sources(config, run.wide, step, static_cast<std::uint64_t>(s))); !put)
      return put.error();
    if (const Result<AirStep> done = (*solver)->step(step); !done) return done.error();
    if (s >= spinUp && s % 4 == 0) flow.add(AirBox((*solver)->state()));
  }
  tell(levels(flow, run, config.cell), !options.quick, row);
  row.addFigure("time", steps * step, "s");
  meter.finish(row);
  row.addTime("seconds_per_simulated_second", row.seconds / (steps * step), "1");
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<PlumeRun> runs = {{32, 48, 12.0, 48.0}, {64, 96, 12.0, 36.0}};
  // Too coarse and too short to hold a bar; that it runs and rises.
  if (options.quick) runs = {{16, 32, 4.0, 8.0}};
  std::vector<BenchRow> rows;
  for (const PlumeRun& r : runs) {
    Result<BenchRow> row = measure(options, r);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase plumeCase() {
  return {"plume", "how a warm plume widens and slows with height",
          "Morton, Taylor and Turner 1956: b ~ z, w ~ z^(-1/3)", run};
}

}  // namespace spin
