// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/air_bench_scene.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/base/units.h"
#ifdef SPIN_HAVE_CUDA
#include "gpu/air_solver_cuda.h"
#include "gpu/cuda_device.h"
#endif

namespace spin {
namespace {

constexpr std::array<int, 3> kBrick{kBrickX, kBrickY, kBrickZ};

}  // namespace

AirBox::AirBox(std::array<int, 3> cells) : m_cells(cells) {
  for (std::size_t d = 0; d < 3; ++d) {
    SPIN_CHECK(cells[d] > 0 && cells[d] % kBrick[d] == 0, "a box of whole bricks");
    m_bricks[d] = cells[d] / kBrick[d];
  }
  for (int c = 0; c < m_bricks[2]; ++c)
    for (int b = 0; b < m_bricks[1]; ++b)
      for (int a = 0; a < m_bricks[0]; ++a) m_state.bricks.push_back({a, b, c});
  m_state.values.assign(kAirFields * m_state.bricks.size() * kBrickCells, 0.0f);
}

AirBox::AirBox(AirState state) : m_state(std::move(state)) {
  SPIN_CHECK(!m_state.bricks.empty(), "a box of bricks");
  const std::array<std::int32_t, 3>& last = m_state.bricks.back();
  for (std::size_t d = 0; d < 3; ++d) {
    m_bricks[d] = last[d] + 1;
    m_cells[d] = m_bricks[d] * kBrick[d];
  }
  const int all = m_bricks[0] * m_bricks[1] * m_bricks[2];
  SPIN_CHECK(m_state.bricks.size() == static_cast<std::size_t>(all), "every brick of the box");
}

std::size_t AirBox::index(AirValue field, int i, int j, int k) const {
  const int brick = i / kBrickX + m_bricks[0] * (j / kBrickY + m_bricks[1] * (k / kBrickZ));
  const int cell = i % kBrickX + kBrickX * (j % kBrickY + kBrickY * (k % kBrickZ));
  const std::size_t block =
      static_cast<std::size_t>(field) * m_state.bricks.size() + static_cast<std::size_t>(brick);
  return block * kBrickCells + static_cast<std::size_t>(cell);
}

float AirBox::face(int axis, int i, int j, int k) const {
  if (i >= m_cells[0] || j >= m_cells[1] || k >= m_cells[2]) return 0.0f;
  return at(static_cast<AirValue>(axis), i, j, k);
}

void AirBox::clear(AirValue field) {
  const std::size_t values = m_state.bricks.size() * kBrickCells;
  const auto first =
      m_state.values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(field) * values);
  std::fill(first, first + static_cast<std::ptrdiff_t>(values), 0.0f);
}

void AirBox::setCurl(const std::function<double(int axis, int i, int j, int k)>& potential) {
  forEach([&](int i, int j, int k) {
    const double x = potential(0, i, j, k), y = potential(1, i, j, k), z = potential(2, i, j, k);
    at(AirValue::U, i, j, k) =
        static_cast<float>((potential(2, i, j + 1, k) - z) - (potential(1, i, j, k + 1) - y));
    at(AirValue::V, i, j, k) =
        static_cast<float>((potential(0, i, j, k + 1) - x) - (potential(2, i + 1, j, k) - z));
    at(AirValue::W, i, j, k) =
        static_cast<float>((potential(1, i + 1, j, k) - y) - (potential(0, i, j + 1, k) - x));
  });
}

double AirBox::mostOutflow() const {
  double most = 0.0;
  forEach([&](int i, int j, int k) {
    const auto along = [&](int axis, int di, int dj, int dk) {
      return static_cast<double>(face(axis, i + di, j + dj, k + dk)) -
             static_cast<double>(face(axis, i, j, k));
    };
    most = std::max(most, std::abs(along(0, 1, 0, 0) + along(1, 0, 1, 0) + along(2, 0, 0, 1)));
  });
  return most;
}

double AirBox::sum(AirValue field) const {
  double total = 0.0;
  forEach([&](int i, int j, int k) { total += static_cast<double>(at(field, i, j, k)); });
  return total;
}

AirConfig stillBox(std::array<int, 3> cells, double cell) {
  AirConfig c;
  c.cell = cell;
  for (std::size_t d = 0; d < 3; ++d) c.highBrick[d] = cells[d] / kBrick[d];
  c.closed.fill(true);
  c.everywhere = true;
  c.gravity = {};
  c.evaporates = false;
  return c;
}

Result<std::unique_ptr<AirSolver>> startAir(const AirConfig& config, const BenchOptions& options) {
#ifdef SPIN_HAVE_CUDA
  if (options.device != "cpu" && cudaAvailable()) return makeAirSolverCuda(config);
#endif
  const Result<Isa> isa = chooseIsa(options.isa);
  if (!isa) return isa.error();
  return makeAirSolverCpu(config, CpuBackend(options.threads), *isa);
}

void nameDevice(const AirSolver& solver, const BenchOptions& options, BenchRow& row) {
  row.device = solver.device();
  if (row.device != "cpu") return;
  if (const Result<Isa> isa = chooseIsa(options.isa)) row.isa = isaName(*isa);
  row.threads = CpuBackend(options.threads).threads();
}

AirSolid hills(double size) {
  const double k = 2.0 * kPi / size;
  AirSolid solid;
  // A height over a plane is no distance; its steepest slope makes it a bound of one near the surface.
  solid.distance = [=](Vec3d p) {
    const double height = size * (0.175 + 0.075 * std::sin(k * p.x + 0.4) * std::cos(k * p.y - 0.7));
    const double dx = 0.075 * size * k * std::cos(k * p.x + 0.4) * std::cos(k * p.y - 0.7);
    const double dy = -0.075 * size * k * std::sin(k * p.x + 0.4) * std::sin(k * p.y - 0.7);
    return (p.z - height) / std::sqrt(1.0 + dx * dx + dy * dy);
  };
  solid.high.z = 0.26 * size;
  return solid;
}

AirSolid ball(Vec3d centre, double radius) {
  AirSolid solid;
  solid.distance = [=](Vec3d p) { return length(p - centre) - radius; };
  const Vec3d reach{radius, radius, radius};
  solid.low = centre - reach;
  solid.high = centre + reach;
  return solid;
}

}  // namespace spin
