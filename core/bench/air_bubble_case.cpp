// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_bench_scene.h"
#include "core/bench/bench_meter.h"
#include "core/bench/bubble_reference.h"

namespace spin {
namespace {

constexpr double kWarmth = 0.1;  // K

struct Shape {
  const char* id;
  std::array<int, 3> cells;
  int round;     ///< axes that its distance counts: 3 = sphere, 2 = cylinder along y, 1 = layer
  double share;  ///< of g', see bubble_reference.h
};
constexpr Shape kShapes[] = {{"sphere", {64, 64, 64}, 3, kSphereShare},
                             {"cylinder", {128, kBrickY, 128}, 2, kCylinderShare},
                             {"layer", {32, kBrickY, 32}, 1, 0.0}};

Result<BenchRow> measure(const BenchOptions& options, const Shape& shape) {
  BenchRow row;
  row.caseId = "bubble";
  row.settings = {{"shape", shape.id}};
  const BenchMeter meter;
  const double cell = 1.0 / shape.cells[2];
  AirConfig config = stillBox(shape.cells, cell);
  config.gravity = {0, 0, -kStandardGravity};
  config.stages = {true, false, false, false, true};
  config.humidity = 0.0;
  config.tolerance = 1e-5;
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  AirBox box(shape.cells);
  const auto within = [&](int i, int j, int k) {
    const double z = (k + 0.5) * cell - 0.5, x = shape.round > 1 ? (i + 0.5) * cell - 0.5 : 0.0,
                 y = shape.round > 2 ? (j + 0.5) * cell - 0.5 : 0.0;
    return x * x + y * y + z * z < kBubbleRadius * kBubbleRadius;
  };
  box.forEach([&](int i, int j, int k) {
    if (within(i, j, k)) box.at(AirValue::Warmth, i, j, k) = static_cast<float>(kWarmth);
  });
  if (Status set = (*solver)->restore(box.state()); !set) return set.error();
  constexpr double kStep = 0.01;
  const Result<AirStep> step = (*solver)->step(kStep);
  if (!step) return step.error();
  const AirBox after((*solver)->state());
  const double own = kStandardGravity * kWarmth / config.temperature;
  double sum = 0.0;
  int faces = 0;
  after.forEach([&](int i, int j, int k) {
    if (k == 0 || (!within(i, j, k) && !within(i, j, k - 1))) return;
    sum += static_cast<double>(after.at(AirValue::W, i, j, k)) / kStep / own;
    ++faces;
  });
  const double mean = sum / faces;
  // 2 %, of g' itself where nothing should move.
  row.addError("acceleration_error", std::abs(mean - shape.share) / (shape.share > 0.0 ? shape.share : 1.0),
               "1", 0.02);
  row.addFigure("acceleration", mean, "g'");
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const Shape& shape : kShapes) {
    Result<BenchRow> row = measure(options, shape);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase bubbleCase() {
  return {"bubble", "first acceleration of warm air in air at rest", "added mass: 2/3, 1/2 and 0 of g'", run};
}

}  // namespace spin
