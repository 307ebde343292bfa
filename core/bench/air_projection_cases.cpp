// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/bench/air_bench_scene.h"
#include "core/bench/bench_meter.h"
#include "core/bench/worst.h"

namespace spin {
namespace {

constexpr double kSide = 1.0;   // m
constexpr double kStep = 1e-3;  // s: no face's air goes a cell, so that there is one projection

AirConfig projectionOnly(int n, bool solids, double tolerance) {
  AirConfig c = stillBox({n, n, n}, kSide / n);
  c.stages = {false, false, false, false, true};
  c.tolerance = tolerance;
  if (solids) c.solids = {hills(kSide), ball({0.55, 0.45, 0.6}, 0.17)};
  return c;
}

/// Every face's velocity at random within 1 m/s, 0 at the closed sides.
AirBox randomBox(int n, std::uint32_t stream) {
  const CounterRandom random{17, stream};
  AirBox box({n, n, n});
  std::uint64_t id = 0;
  box.forEach([&](int i, int j, int k) {
    const int at[3] = {i, j, k};
    for (int axis = 0; axis < 3; ++axis, ++id)
      if (at[axis] > 0)
        box.at(static_cast<AirValue>(axis), i, j, k) =
            static_cast<float>(2.0 * random.uniformDouble(id) - 1.0);
  });
  return box;
}

/// A random potential that is 0 on the box's sides, so that no air goes through them.
AirBox randomCurl(int n) {
  const CounterRandom random{23, 5};
  AirBox box({n, n, n});
  box.setCurl([&](int axis, int i, int j, int k) {
    const int at[3] = {i, j, k};
    for (int d = 0; d < 3; ++d)
      if (d != axis && (at[d] == 0 || at[d] == n)) return 0.0;
    const auto id = static_cast<std::uint64_t>(((k * (n + 1) + j) * (n + 1) + i) * 3 + axis);
    return 0.5 * random.uniformDouble(id) - 0.25;
  });
  return box;
}

/// Largest change of a velocity at faces between two cells of open air.
double mostChange(const AirBox& a, const AirBox& b) {
  double most = 0.0;
  a.forEach([&](int i, int j, int k) {
    const auto open = [&](int di, int dj, int dk) {
      return i >= di && j >= dj && k >= dk && b.at(AirValue::Share, i - di, j - dj, k - dk) > 0.0f;
    };
    if (!open(0, 0, 0)) return;
    const bool lower[3] = {open(1, 0, 0), open(0, 1, 0), open(0, 0, 1)};
    for (int axis = 0; axis < 3; ++axis)
      if (lower[axis]) {
        const auto field = static_cast<AirValue>(axis);
        most = worse(most, std::abs(static_cast<double>(a.at(field, i, j, k)) -
                                    static_cast<double>(b.at(field, i, j, k))));
      }
  });
  return most;
}

/// From the solver's own field of divergence, which counts the open shares of faces.
double publishedOutflow(const AirSolver& solver, double cell) {
  AirPart part;
  solver.publish(true, part);
  double most = 0.0;
  if (const AirField* field = part.find("divergence"))
    for (std::size_t brick = 0; brick < part.bricks.size(); ++brick)
      for (std::size_t k = 0; k < kBrickCells; ++k)
        most = worse(most, std::abs(static_cast<double>(field->at(brick, 0, k))) * cell);
  return most;
}

struct Projected {
  AirStep step;
  AirBox box{{kBrickX, kBrickY, kBrickZ}};
};

Result<Projected> project(AirSolver& solver, const AirBox& box) {
  if (Status set = solver.restore(box.state()); !set) return set.error();
  Result<AirStep> step = solver.step(kStep);
  if (!step) return step.error();
  return Projected{*step, AirBox(solver.state())};
}

Result<BenchRow> measure(const BenchOptions& options, int n, bool solids) {
  BenchRow row;
  row.caseId = "projection";
  row.settings = {{"cells", fmt::format("{}^3", n)}, {"solids", solids ? "hills and ball" : "none"}};
  const BenchMeter meter;
  const AirConfig config = projectionOnly(n, solids, 5e-6);
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  Result<Projected> once = project(**solver, randomBox(n, 1));
  if (!once) return once.error();
  const double outflow = solids ? publishedOutflow(**solver, config.cell) : once->box.mostOutflow();
  row.addError("h_divergence", outflow, "m/s", 1e-4);
  row.addError("residual", once->step.residual, "1", 2e-5);
  row.addFigure("iterations", once->step.iterations, "1");
  once->box.clear(AirValue::Pressure);
  once->box.clear(AirValue::SecondPressure);
  const Result<Projected> twice = project(**solver, once->box);
  if (!twice) return twice.error();
  row.addError("change_by_second", mostChange(once->box, twice->box), "m/s", 1e-4);
  if (!solids) {
    const AirBox curl = randomCurl(n);
    const Result<Projected> kept = project(**solver, curl);
    if (!kept) return kept.error();
    row.addError("change_of_curl", mostChange(curl, kept->box), "m/s", 1e-5);
  }
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> run(const BenchOptions& options) {
  std::vector<BenchRow> rows;
  for (const int n : options.quick ? std::vector<int>{32} : std::vector<int>{32, 64, 128})
    for (const bool solids : {false, true}) {
      Result<BenchRow> row = measure(options, n, solids);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  return rows;
}

struct Way {
  const char* id;
  AirPressure solver;
  bool solids;
};

/// The same field with a hundredth of another one added is what a step later looks like to the solver.
AirBox laterBox(const AirBox& first, int n) {
  AirBox later = first;
  const AirBox other = randomBox(n, 2);
  later.forEach([&](int i, int j, int k) {
    for (const AirValue field : {AirValue::U, AirValue::V, AirValue::W})
      later.at(field, i, j, k) += 0.01f * other.at(field, i, j, k);
  });
  return later;
}

Result<BenchRow> measureSolver(const BenchOptions& options, const Way& way, int n) {
  BenchRow row;
  row.caseId = "pressure-solvers";
  row.settings = {{"cells", fmt::format("{}^3", n)},
                  {"solver", way.id},
                  {"solids", way.solids ? "hills and ball" : "none"}};
  const BenchMeter meter;
  AirConfig config = projectionOnly(n, way.solids, 1e-5);
  config.solver = way.solver;
  auto solver = startAir(config, options);
  if (!solver) return solver.error();
  const AirBox random = randomBox(n, 1);
  const Result<Projected> cold = project(**solver, random);
  if (!cold) return cold.error();
  AirBox later = laterBox(random, n);
  later.forEach([&](int i, int j, int k) {
    later.at(AirValue::Pressure, i, j, k) = cold->box.at(AirValue::Pressure, i, j, k);
  });
  if (Status set = (*solver)->restore(later.state()); !set) return set.error();
  const BenchMeter clock;
  const Result<AirStep> warm = (*solver)->step(kStep);
  const double warmSeconds = clock.seconds();
  if (!warm) return warm.error();
  // Sweeps are as published: how far they come is a figure, not a bar.
  if (way.solver == AirPressure::Multigrid)
    row.addError("residual", worse(cold->step.residual, warm->residual), "1", 1e-5);
  else
    row.addFigure("residual_of_sweeps", cold->step.residual, "1");
  row.addFigure("iterations_cold", cold->step.iterations, "1");
  row.addFigure("iterations_warm", warm->iterations, "1");
  if (Status set = (*solver)->restore(random.state()); !set) return set.error();
  const BenchMeter again;
  const Result<AirStep> timed = (*solver)->step(kStep);
  if (!timed) return timed.error();
  row.addTime("seconds_cold", again.seconds(), "s");
  row.addTime("seconds_warm", warmSeconds, "s");
  meter.finish(row);
  nameDevice(**solver, options, row);
  return row;
}

Result<std::vector<BenchRow>> runSolvers(const BenchOptions& given) {
  BenchOptions options = given;
  options.threads = 1;  // as the figures it is held against
  std::vector<BenchRow> rows;
  for (const Way& way :
       {Way{"multigrid", AirPressure::Multigrid, false}, Way{"multigrid", AirPressure::Multigrid, true},
        Way{"jacobi", AirPressure::Jacobi, false}, Way{"gauss-seidel", AirPressure::GaussSeidel, false}}) {
    Result<BenchRow> row = measureSolver(options, way, options.quick ? 32 : 128);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return rows;
}

}  // namespace

BenchCase projectionCase() {
  return {"projection", "what a projection leaves of a random field's divergence, and what it leaves alone",
          "a projection's own properties", run};
}

BenchCase pressureSolversCase() {
  return {"pressure-solvers", "residual and time of the solvers of the pressure, one thread",
          "40 Jacobi sweeps leave 9 %, direct transform 60 ms", runSolvers};
}

}  // namespace spin
