// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_bench_scene.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kSize = 128.0;  // m
constexpr const char* kNames[kAirScalars] = {"mist", "snow", "warmth", "vapour"};

/// Hills and a ball, wind through open sides, bricks that come and go, mist and snow that settle and
/// evaporate.
AirConfig windyHills() {
  AirConfig c;
  c.cell = 2.0;
  c.highBrick = {4, 12, 10};
  c.closed = {false, false, false, false, true, false};
  c.wind = [](Vec3d) { return Vec3d{4.0, 1.0, 0.0}; };
  c.settling = {0.1, 0.8};
  c.solids = {hills(kSize), ball({60, 48, 45}, 12)};
  return c;
}

/// What is given to the air, counted here.
struct Given {
  AirAmounts amounts{};
  Vec3d impulse{};
  double impulses = 0.0;  ///< sum of the sizes

  void add(const AirSource& source) {
    for (std::size_t s = 0; s < kAirScalars; ++s) amounts[s] += source.amounts[s];
    count(source.impulse);
  }
  void count(Vec3d more) {
    impulse += more;
    impulses += length(more);
  }
};

std::vector<AirSource> sources() {
  return {{{30, 30, 35}, {2.0, 5.0, -40.0, 0.2}, {40, 0, -100}},
          {{45.3, 60.1, 30.7}, {4.0, 1.0, 30.0, 0.1}, {0, 25, 60}},
          {{60, 48, 60}, {1.0, 8.0, 0.0, 0.0}, {0, 0, -30}}};
}

/// A shower of drops that the air slows.
std::vector<AirDrag> drops() {
  std::vector<AirDrag> all;
  for (int k = 0; k < 60; ++k) {
    AirDrag drop;
    drop.position = {25.0 + 0.7 * k, 40.0 + 3.0 * (k % 5), 36.0 + 0.3 * k};
    drop.velocity = {2.0, 0.1 * k, -15.0};
    drop.mass = 0.5;
    drop.rate = 0.1 + 0.2 * (k % 7);
    all.push_back(drop);
  }
  return all;
}

/// Mist, snow, warmth and vapour by the cells themselves.
AirAmounts held(const AirState& state, double cell) {
  const std::size_t cells = state.bricks.size() * kBrickCells;
  const auto value = [&](AirValue field, std::size_t k) {
    return static_cast<double>(state.values[static_cast<std::size_t>(field) * cells + k]);
  };
  AirAmounts all{};
  for (std::size_t k = 0; k < cells; ++k) {
    const double volume = value(AirValue::Share, k) * cell * cell * cell;
    for (std::size_t s = 0; s < kAirScalars; ++s)
      all[s] += volume * value(static_cast<AirValue>(static_cast<std::size_t>(AirValue::Mist) + s), k);
  }
  return all;
}

/// All as shares of the sum of the terms' sizes.
void tellBalance(const AirSolver& solver, const Given& given, double cell, BenchRow& row) {
  const AirBudget b = solver.budget();
  const AirAmounts inCells = held(solver.state(), cell);
  double counted = 0.0;
  for (std::size_t s = 0; s < kAirScalars; ++s) {
    const double expected = given.amounts[s] + b.condensed[s] + b.enteredSides[s] - b.leftSides[s] -
                            b.deposited[s] - b.givenUp[s];
    double scale = std::abs(given.amounts[s]);
    for (const AirAmounts* terms : {&b.condensed, &b.enteredSides, &b.leftSides, &b.deposited})
      scale += std::abs((*terms)[s]);
    row.addError(std::string(kNames[s]) + "_balance", std::abs(inCells[s] - expected) / scale, "1", 1e-5);
    counted = worse(counted, std::abs(b.present[s] - inCells[s]) / scale);
    counted = worse(counted, std::abs(b.added[s] - given.amounts[s]) / scale);
  }
  row.addError("own_count", counted, "1", 1e-5);
  const Vec3d taken = b.addedImpulse + b.solidImpulse;
  row.addError("impulse_balance", length(taken - given.impulse) / given.impulses, "1", 1e-5);
  constexpr auto kSnow = static_cast<std::size_t>(AirScalar::Snow);
  row.addFigure("snow_in_air", b.present[kSnow], "kg");
  row.addFigure("snow_deposited", b.deposited[kSnow], "kg");
  row.addFigure("snow_left", b.leftSides[kSnow], "kg");
  row.addFigure("snow_given_up", b.givenUp[kSnow], "kg");
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  BenchRow row;
  row.caseId = "mist-mass";
  const int steps = options.quick ? 24 : 240;
  row.settings = {{"steps", std::to_string(steps)}};
  const BenchMeter meter;
  const AirConfig config = windyHills();
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  constexpr double kStep = 0.25;
  Given given;
  std::vector<AirDrag> particles = drops();
  double mist = 0.0, snow = 0.0;
  std::size_t mostCells = 0;
  for (int s = 0; s < steps; ++s) {
    if (3 * s < 2 * steps) {
      const std::vector<AirSource> now = sources();
      for (const AirSource& source : now) given.add(source);
      if (Status put = (*solver)->add(now); !put) return put.error();
    }
    const std::vector<AirDrag> before = particles;
    if (Status dragged = (*solver)->drag(particles, kStep); !dragged) return dragged.error();
    for (std::size_t k = 0; k < particles.size(); ++k)
      given.count((before[k].velocity - particles[k].velocity) * particles[k].mass);
    const Result<AirStep> done = (*solver)->step(kStep);
    if (!done) return done.error();
    mostCells = std::max(mostCells, done->cells);
    for (const AirDeposit& deposit : (*solver)->takeDeposits()) {
      mist += deposit.mist;
      snow += deposit.snow;
    }
  }
  tellBalance(**solver, given, config.cell, row);
  const AirBudget b = (*solver)->budget();
  row.addError(
      "deposits_told",
      std::abs(mist + snow - b.deposited[0] - b.deposited[1]) / (given.amounts[0] + given.amounts[1]), "1",
      1e-5);
  row.addFigure("most_cells", static_cast<double>(mostCells), "1");
  meter.finish(row);
  nameDevice(**solver, options, row);
  return std::vector<BenchRow>{row};
}

}  // namespace

BenchCase mistMassCase() {
  return {"mist-mass", "mist, snow, heat and vapour over hills in wind: in - out - deposited = change",
          "the sums themselves", run};
}

}  // namespace spin
