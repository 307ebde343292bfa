// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/bench/air_flows.h"
#include "core/bench/bench_meter.h"

namespace spin {
namespace {

AirConfig scalarsOnly(std::array<int, 3> cells, double cell) {
  AirConfig c = stillBox(cells, cell);
  c.stages = {false, false, true, false, false};
  c.mostCourant = 100.0;
  return c;
}

struct TransportErrors {
  double l1 = 0.0, l2 = 0.0, mass = 0.0, least = 0.0, most = 0.0;
};

/// Of the mist against what it was, each as a share of that.
TransportErrors errorsOf(const AirBox& now, const AirBox& then) {
  TransportErrors e;
  double first = 0.0, sum = 0.0, squares = 0.0;
  now.forEach([&](int i, int j, int k) {
    const double a = static_cast<double>(now.at(AirValue::Mist, i, j, k)),
                 b = static_cast<double>(then.at(AirValue::Mist, i, j, k));
    e.l1 += std::abs(a - b);
    e.l2 += (a - b) * (a - b);
    first += b;
    squares += b * b;
    sum += a;
    e.least = std::min(e.least, a);
    e.most = std::max(e.most, a);
  });
  e.l1 /= first;
  e.l2 = std::sqrt(e.l2 / squares);
  e.mass = std::abs(sum / first - 1.0);
  return e;
}

void tell(const TransportErrors& e, BenchRow& row) {
  // Fluxes: mass changes by the rounding of single precision only.
  row.addError("mass_change", e.mass, "1", 1e-5);
  row.addFigure("least", e.least, "kg/m3");
  row.addFigure("most", e.most, "kg/m3");
}

/// Zalesak (1979): a disk with a slot, turned once about the middle of a square of 1 m.
AirBox slottedDisk(int n) {
  const int wide = (n + kBrickX - 1) / kBrickX * kBrickX;
  AirBox box({wide, kBrickY, n});
  const auto node = [n](int i) { return static_cast<double>(i) / n - 0.5; };
  setTurning(box, n);
  box.forEach([&](int i, int j, int k) {
    const double x = node(i) + 0.5 / n, z = node(k) + 0.5 / n - 0.25;
    const bool slot = std::abs(x) < 0.025 && z < 0.1;
    box.at(AirValue::Mist, i, j, k) = x * x + z * z < 0.15 * 0.15 && !slot ? 1.0f : 0.0f;
  });
  return box;
}

Result<BenchRow> turn(const BenchOptions& options, int n, int steps) {
  BenchRow row;
  row.caseId = "zalesak";
  row.settings = {{"cells", fmt::format("{}^2", n)}, {"steps", std::to_string(steps)}};
  const BenchMeter meter;
  const AirBox start = slottedDisk(n);
  auto solver = startAir(scalarsOnly(start.cells(), 1.0 / n), options);
  if (!solver) return solver.error();
  if (Status set = (*solver)->restore(start.state()); !set) return set.error();
  for (int s = 0; s < steps; ++s)
    if (const Result<AirStep> step = (*solver)->step(1.0 / steps); !step) return step.error();
  const TransportErrors e = errorsOf(AirBox((*solver)->state()), start);
  row.addError("l1", e.l1, "1", 0.53);
  row.addFigure("l2", e.l2, "1");
  tell(e, row);
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

constexpr double kPeriod = 3.0;

AirBox deformed(int n, double speed) {
  AirBox box({n, n, n});
  setDeformation(box, speed);
  return box;
}

void putSphere(AirBox& box) {
  const int n = box.cells()[0];
  box.forEach([&](int i, int j, int k) {
    // How much of the cell the sphere fills, by points in it.
    constexpr int kParts = 4;
    int inside = 0;
    const auto at = [n](int cell, int part) { return (cell + (part + 0.5) / kParts) / n - 0.35; };
    for (int c = 0; c < kParts; ++c)
      for (int b = 0; b < kParts; ++b)
        for (int a = 0; a < kParts; ++a) {
          const Vec3d p{at(i, a), at(j, b), at(k, c)};
          inside += dot(p, p) < 0.15 * 0.15;
        }
    box.at(AirValue::Mist, i, j, k) = static_cast<float>(inside) / (kParts * kParts * kParts);
  });
}

/// Goes on from one share of the period to another. The flow swells and fades by cos(pi t / T): with the
/// flow held still each step is as long as it would have carried.
Status carry(AirSolver& solver, int from, int to, int steps) {
  const auto way = [steps](int s) { return kPeriod / kPi * std::sin(kPi * s / steps); };
  for (int s = from; s < to; ++s)
    if (const Result<AirStep> step = solver.step(std::abs(way(s + 1) - way(s))); !step) return step.error();
  return {};
}

Result<BenchRow> deform(const BenchOptions& options, int n, int steps) {
  BenchRow row;
  row.caseId = "deformation-3d";
  row.settings = {{"cells", fmt::format("{}^3", n)}, {"steps", std::to_string(steps)}};
  const BenchMeter meter;
  AirBox start = deformed(n, 1.0);
  putSphere(start);
  auto solver = startAir(scalarsOnly(start.cells(), 1.0 / n), options);
  if (!solver) return solver.error();
  if (Status set = (*solver)->restore(start.state()); !set) return set.error();
  if (Status done = carry(**solver, 0, steps / 2, steps); !done) return done.error();
  // Back again.
  const AirBox half((*solver)->state());
  AirBox turned = deformed(n, -1.0);
  turned.forEach(
      [&](int i, int j, int k) { turned.at(AirValue::Mist, i, j, k) = half.at(AirValue::Mist, i, j, k); });
  if (Status set = (*solver)->restore(turned.state()); !set) return set.error();
  if (Status done = carry(**solver, steps / 2, steps, steps); !done) return done.error();
  const TransportErrors e = errorsOf(AirBox((*solver)->state()), start);
  row.addError("l2", e.l2, "1", 0.65);
  row.addFigure("l1", e.l1, "1");
  tell(e, row);
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> runTurn(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int steps : options.quick ? std::vector<int>{314} : std::vector<int>{628, 1256}) {
    Result<BenchRow> row = turn(options, 100, steps);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

Result<std::vector<BenchRow>> runDeform(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int steps : options.quick ? std::vector<int>{150} : std::vector<int>{150, 300, 600}) {
    Result<BenchRow> row = deform(options, 48, steps);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase zalesakCase() {
  return {"zalesak", "a slotted disk of mist turned once, 100^2 cells", "Zalesak 1979: itself", runTurn};
}

BenchCase deformation3dCase() {
  return {"deformation-3d", "a sphere of mist drawn out and back, 48^3 cells", "LeVeque 1996: itself",
          runDeform};
}

}  // namespace spin
