// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/air/air_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/base/units.h"

namespace spin {
namespace {

using Solver = std::unique_ptr<AirSolver>;

/// A closed box of whole bricks with all cells computed.
AirConfig closedBox(int x, int y, int z, double cell) {
  AirConfig c;
  c.cell = cell;
  c.highBrick = {x, y, z};
  c.closed.fill(true);
  c.everywhere = true;
  c.evaporates = false;
  c.mostCourant = 100.0;
  return c;
}

Solver make(const AirConfig& config, int threads = 1, Isa isa = bestIsa()) {
  auto made = makeAirSolverCpu(config, CpuBackend(threads), isa);
  if (!made) ADD_FAILURE() << made.error().text();
  return made ? std::move(*made) : nullptr;
}

/// Sets a field's cells from their centres or lower faces, in m from the lattice's corner.
template <class What>
void setField(const AirConfig& c, AirState& s, std::size_t field, const What& what) {
  for (std::size_t b = 0; b < s.bricks.size(); ++b)
    for (int k = 0; k < static_cast<int>(kBrickCells); ++k) {
      Vec3d p{s.bricks[b][0] * kBrickX + k % kBrickX + 0.5,
              s.bricks[b][1] * kBrickY + k / kBrickX % kBrickY + 0.5,
              s.bricks[b][2] * kBrickZ + k / (kBrickX * kBrickY) + 0.5};
      if (field == 0) p.x -= 0.5;
      if (field == 1) p.y -= 0.5;
      if (field == 2) p.z -= 0.5;
      s.values[(field * s.bricks.size() + b) * kBrickCells + static_cast<std::size_t>(k)] =
          static_cast<float>(what(c.cell * p));
    }
}

double largestDivergence(const AirSolver& solver) {
  AirPart part;
  solver.publish(true, part);
  const AirField* field = part.find("divergence");
  double most = 0.0;
  for (std::size_t k = 0; field && k < part.cells(); ++k)
    most = std::max(most, std::abs(static_cast<double>(field->at(k / kBrickCells, 0, k % kBrickCells))));
  return most;
}

TEST(AirSolver, SmallEddiesMixAsSmagorinskySays) {
  // u = A sin(k z) between sliding walls: du/dt = d/dz (C^2 h^2 |du/dz| du/dz).
  constexpr double kCell = 0.5, kAmplitude = 4.0, kConstant = 0.2, kSeconds = 0.05;
  AirConfig c = closedBox(1, 1, 16, kCell);
  c.stages = {false, false, false, true, false};
  c.smagorinsky = kConstant;
  const Solver solver = make(c);
  AirState s = solver->state();
  const double k = 2.0 * kPi / (16 * kBrickZ * kCell);
  setField(c, s, 0, [&](Vec3d p) { return p.x == 0.0 ? 0.0 : kAmplitude * std::sin(k * p.z); });
  ASSERT_TRUE(solver->restore(s).ok());
  const auto before = solver->velocities({{3.0, 1.0, 8.25}, {3.0, 1.0, 4.25}, {3.0, 1.0, 2.25}});
  ASSERT_TRUE(solver->step(kSeconds).ok());
  const auto after = solver->velocities({{3.0, 1.0, 8.25}, {3.0, 1.0, 4.25}, {3.0, 1.0, 2.25}});
  for (std::size_t n = 0; n < after.size(); ++n) {
    const double z = n == 0 ? 8.25 : n == 1 ? 4.25 : 2.25;
    const double slope = kAmplitude * k * std::cos(k * z), bend = -kAmplitude * k * k * std::sin(k * z);
    const double expected = 2.0 * kConstant * kConstant * kCell * kCell * std::abs(slope) * bend * kSeconds;
    EXPECT_NEAR(after[n].x - before[n].x, expected, 0.03 * std::abs(expected) + 2e-5) << z;
  }
}

TEST(AirSolver, ProjectionTakesTheDivergenceOut) {
  AirConfig c = closedBox(4, 16, 16, 1.0 / 64);
  c.stages = {false, false, false, false, true};
  c.tolerance = 2e-5;
  c.solids.push_back({[](Vec3d p) { return length(p - Vec3d{0.5, 0.5, 0.3}) - 0.2; }, {}});
  const Solver solver = make(c);
  AirState s = solver->state();
  const CounterRandom random(7);
  std::uint64_t n = 0;
  for (std::size_t f = 0; f < 3; ++f)
    setField(c, s, f, [&](Vec3d p) {
      const bool wall = (f == 0 && p.x == 0.0) || (f == 1 && p.y == 0.0) || (f == 2 && p.z == 0.0);
      return wall ? 0.0 : random.uniformDouble(n++) - 0.5;
    });
  ASSERT_TRUE(solver->restore(s).ok());
  const auto done = solver->step(1.0);
  ASSERT_TRUE(done.ok());
  EXPECT_LE(done->residual, 2e-5);
  EXPECT_LE(largestDivergence(*solver) / 64, 2e-4);
}

TEST(AirSolver, TaylorGreenKeepsItsEnergy) {
  constexpr int n = 64;
  AirConfig c = closedBox(n / kBrickX, n / kBrickY, 1, 2.0 * kPi / n);
  c.viscosity = 1e-3;
  c.tolerance = 1e-4;
  const Solver solver = make(c);
  AirState s = solver->state();
  setField(c, s, 0, [](Vec3d p) { return std::sin(p.x) * std::cos(p.y); });
  setField(c, s, 1, [](Vec3d p) { return -std::cos(p.x) * std::sin(p.y); });
  ASSERT_TRUE(solver->restore(s).ok());
  double seconds = 0.0;
  for (; seconds < 1.0 - 1e-9; seconds += 0.1) {
    const auto done = solver->step(0.1);
    ASSERT_TRUE(done.ok()) << done.error().text();
  }
  const AirState end = solver->state();
  double before = 0.0, after = 0.0;
  const std::size_t velocities = 2 * s.bricks.size() * kBrickCells;
  for (std::size_t k = 0; k < velocities; ++k) {
    before += static_cast<double>(s.values[k] * s.values[k]);
    after += static_cast<double>(end.values[k] * end.values[k]);
  }
  const double kept = after / (before * std::exp(-4.0 * c.viscosity));
  EXPECT_GT(kept, 0.995);
  EXPECT_LT(kept, 1.005);
}

}  // namespace
}  // namespace spin
