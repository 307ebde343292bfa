// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/flow_reach.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace spin {
namespace {

/// Cells that are looked at, about: finer ones do not change the box.
constexpr double kMostCells = 250'000.0;

/// The raster in steps of several cells.
struct Coarse {
  const Raster<float>& heights;
  int step;
  int width, height;

  explicit Coarse(const Raster<float>& r)
      : heights(r),
        step(std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(r.size()) / kMostCells))))),
        width((r.width + step - 1) / step),
        height((r.height + step - 1) / step) {}
  bool contains(int i, int j) const { return i >= 0 && j >= 0 && i < width && j < height; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  }
  double z(int i, int j) const { return static_cast<double>(heights.at(i * step, j * step)); }
  double cell() const { return step * heights.cellSize; }
};

struct Visit {
  double energy;
  int i, j;
  /// The highest first; ties by place, so that the order is the same everywhere.
  bool operator<(const Visit& o) const { return std::tie(energy, j, i) < std::tie(o.energy, o.j, o.i); }
};

}  // namespace

FlowReach findReach(const Raster<float>& heights, const std::vector<FlowStart>& starts, double loss) {
  FlowReach reach;
  if (heights.empty()) return reach;
  const Coarse grid(heights);
  std::vector<double> best(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                           -1e300);
  std::priority_queue<Visit> queue;
  const auto enter = [&](int i, int j, double energy) {
    // A NaN height is not below the energy: there is no ground.
    if (!grid.contains(i, j) || !(grid.z(i, j) < energy) || energy <= best[grid.index(i, j)]) return;
    best[grid.index(i, j)] = energy;
    queue.push({energy, i, j});
  };
  for (const FlowStart& s : starts)
    enter(heights.column(s.x) / grid.step, heights.row(s.y) / grid.step, s.energy);
  while (!queue.empty()) {
    const Visit at = queue.top();
    queue.pop();
    if (at.energy < best[grid.index(at.i, at.j)]) continue;
    const double z = grid.z(at.i, at.j);
    reach.box.extend(Vec3d{heights.x(at.i * grid.step), heights.y(at.j * grid.step), z});
    reach.speedHead = std::max(reach.speedHead, at.energy - z);
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di)
        if (di != 0 || dj != 0)
          enter(at.i + di, at.j + dj, at.energy - loss * grid.cell() * std::hypot(di, dj));
  }
  return reach;
}

}  // namespace spin
