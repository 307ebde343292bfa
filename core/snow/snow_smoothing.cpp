// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_smoothing.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

/// Share of the stability bound (1/4 of a cell's area, with four neighbours) that a step takes.
constexpr double kStepShare = 0.2;
constexpr double kMostGiven = 0.5;  ///< of a cell's snow in one step

/// One explicit step over all cells.
class SmoothingStep {
 public:
  SmoothingStep(const CoverGraph& graph, const SmoothingSettings& settings, double spread,
                const double* depth)
      : m_graph(&graph), m_fullDepth(settings.fullDepth), m_spread(spread), m_depth(depth) {}

  /// Calls visit(other cell, volume) for what flows from a cell to its neighbours, m3, negative where it
  /// comes.
  template <class Visit>
  void flows(const CoverGraph::Grid& grid, std::uint32_t cell, const Visit& visit) const {
    const std::uint8_t mask = m_graph->neighbours(cell);
    // A unit of area limits what small cells along a model's edge may pass.
    const double whole = grid.cellSize * grid.cellSize;
    for (std::size_t k = 0; k < 8; k += 2) {
      if (!(mask >> k & 1)) continue;
      const auto other = cell + static_cast<std::uint32_t>(kCellSteps[k][0] + kCellSteps[k][1] * grid.width);
      const double least = static_cast<double>(std::min(m_graph->area(cell), m_graph->area(other)));
      visit(other, flow(cell, other, std::min(1.0, least / whole)));
    }
    for (const CoverLink& link : m_graph->links(cell))
      if (link.leads() && !link.falls)
        visit(link.target,
              flow(cell, link.target, static_cast<double>(link.width) / static_cast<double>(link.distance)));
  }

  /// Factor on all that a cell gives.
  double brake(const CoverGraph::Grid& grid, std::uint32_t cell) const {
    double out = 0.0;
    flows(grid, cell, [&](std::uint32_t, double volume) { out += std::max(volume, 0.0); });
    const double most = kMostGiven * m_depth[cell] * static_cast<double>(m_graph->area(cell));
    return out > most ? most / out : 1.0;
  }

 private:
  double flow(std::uint32_t a, std::uint32_t b, double widthOverDistance) const {
    const double thin = std::min({m_depth[a], m_depth[b], m_fullDepth});
    if (!(thin > 0.0)) return 0.0;
    // Beds first: their difference is exact, and flow(a, b) = -flow(b, a) to the last bit.
    const double drop = (static_cast<double>(m_graph->bed(a)) - static_cast<double>(m_graph->bed(b))) +
                        (m_depth[a] - m_depth[b]);
    return m_spread * widthOverDistance * drop * (thin / m_fullDepth);
  }

  const CoverGraph* m_graph;
  double m_fullDepth, m_spread;
  const double* m_depth;
};

void step(const CoverGraph& graph, const CarriedSnow& snow, const SmoothingSettings& settings, double spread,
          CpuBackend& backend, std::vector<double>& brakes, std::vector<std::vector<double>>& next) {
  const SmoothingStep scheme(graph, settings, spread, snow[0]);
  for (const CoverGraph::Grid& grid : graph.grids()) {
    const auto cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    backend.forEach("smoothing", cells, [&](std::size_t c) {
      const auto cell = grid.first + static_cast<std::uint32_t>(c);
      brakes[cell] = snow[0][cell] > 0.0 ? scheme.brake(grid, cell) : 1.0;
    });
  }
  for (const CoverGraph::Grid& grid : graph.grids()) {
    const auto cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    backend.forEach("smoothing", cells, [&](std::size_t c) {
      const auto cell = grid.first + static_cast<std::uint32_t>(c);
      for (std::size_t q = 0; q < snow.size(); ++q) next[q][cell] = snow[q][cell];
      if (!(snow[0][cell] > 0.0)) return;
      const double area = static_cast<double>(graph.area(cell));
      scheme.flows(grid, cell, [&](std::uint32_t other, double volume) {
        const std::uint32_t donor = volume > 0.0 ? cell : other;
        if (!(snow[0][donor] > 0.0)) return;
        // Amount of each quantity = volume times its share of the donor's depth.
        const double perArea = volume * brakes[donor] / area;
        for (std::size_t q = 0; q < snow.size(); ++q)
          next[q][cell] -= perArea * (snow[q][donor] / snow[0][donor]);
      });
    });
  }
  for (std::size_t q = 0; q < snow.size(); ++q) std::copy(next[q].begin(), next[q].end(), snow[q]);
}

}  // namespace

double smoothSnow(const CoverGraph& graph, const CarriedSnow& snow, const SmoothingSettings& settings,
                  CpuBackend& backend) {
  double smallest = 0.0;
  for (const CoverGraph::Grid& grid : graph.grids())
    if (smallest == 0.0 || grid.cellSize < smallest) smallest = grid.cellSize;
  if (!(settings.spread > 0.0) || smallest == 0.0) return 0.0;
  const double most = kStepShare * smallest * smallest;
  const double wanted = std::ceil(settings.spread / most);
  const int steps = static_cast<int>(std::min(wanted, static_cast<double>(settings.mostSteps)));
  const double spread = std::min(settings.spread / steps, most);
  std::vector<double> brakes(graph.size());
  std::vector<std::vector<double>> next(snow.size(), std::vector<double>(graph.size()));
  for (int s = 0; s < steps; ++s) step(graph, snow, settings, spread, backend, brakes, next);
  return spread * steps;
}

}  // namespace spin
