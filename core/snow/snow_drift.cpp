// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_drift.h"

#include <algorithm>
#include <cmath>

#include "core/physics/blowing_snow.h"

namespace spin {
namespace {

/// Sides that the wind meets at a flatter angle than this let nothing through, as a share of the side.
constexpr double kLeastLee = 1e-3;

double leeWidth(double width, std::size_t side, Vec2f direction) {
  const double along = kCellSteps[side][0] * static_cast<double>(direction.x) +
                       kCellSteps[side][1] * static_cast<double>(direction.y);
  return along > kLeastLee ? width * along : 0.0;
}

/// Calls visit(grid, cell) for all cells, in the order of their numbers.
template <class Visit>
void forCells(const CoverGraph& graph, const Visit& visit) {
  for (const CoverGraph::Grid& grid : graph.grids()) {
    const auto cells = static_cast<std::uint32_t>(grid.width) * static_cast<std::uint32_t>(grid.height);
    for (std::uint32_t cell = grid.first; cell < grid.first + cells; ++cell)
      if (graph.area(cell) > 0.0f) visit(grid, cell);
  }
}

}  // namespace

SnowDrift::SnowDrift(std::shared_ptr<const CoverGraph> graph) : m_graph(std::move(graph)) {}

/// Calls visit(target, width) for the lee sides of a cell; the target is kOut where it leaves the domain.
template <class Visit>
void SnowDrift::forExits(const CoverGraph::Grid& grid, std::uint32_t cell, const Visit& visit) const {
  const Vec2f direction = m_direction[cell];
  const std::uint8_t mask = m_graph->neighbours(cell);
  for (std::size_t k = 0; k < 8; k += 2) {
    if (!(mask >> k & 1)) continue;
    const double width = leeWidth(grid.cellSize, k, direction);
    if (width > 0.0)
      visit(cell + static_cast<std::uint32_t>(kCellSteps[k][0] + kCellSteps[k][1] * grid.width), width);
  }
  for (const CoverLink& link : m_graph->links(cell)) {
    const double width = leeWidth(static_cast<double>(link.width), link.side, direction);
    if (width > 0.0) visit(link.leads() ? link.target : kOut, width);
  }
}

/// Width across the wind of the domain's border on a cell's windward sides, m.
double SnowDrift::windwardBorder(std::uint32_t cell) const {
  double width = 0.0;
  for (const CoverLink& link : m_graph->links(cell))
    if (link.target == CoverLink::kBeyond)
      width += leeWidth(static_cast<double>(link.width), link.side, m_direction[cell] * -1.0f);
  return width;
}

void SnowDrift::setDirections(const std::vector<Vec2f>& directions) {
  m_direction = directions;
  m_order.clear();
  // Cells whose upwind cells are all in the order follow (Kahn 1962).
  std::vector<std::uint32_t> waitsFor(m_graph->size(), 0);
  forCells(*m_graph, [&](const CoverGraph::Grid& grid, std::uint32_t cell) {
    forExits(grid, cell, [&](std::uint32_t target, double) {
      if (target != kOut) ++waitsFor[target];
    });
  });
  std::vector<char> placed(m_graph->size(), 0);
  std::size_t grid = 0;
  const auto place = [&](std::uint32_t cell) {
    placed[cell] = 1;
    m_order.push_back(cell);
  };
  std::size_t next = 0;
  const auto follow = [&] {
    for (; next < m_order.size(); ++next) {
      const std::uint32_t cell = m_order[next];
      const std::vector<CoverGraph::Grid>& grids = m_graph->grids();
      if (cell < grids[grid].first || (grid + 1 < grids.size() && cell >= grids[grid + 1].first))
        grid = m_graph->gridOf(cell);
      forExits(grids[grid], cell, [&](std::uint32_t target, double) {
        if (target != kOut && --waitsFor[target] == 0 && !placed[target]) place(target);
      });
    }
  };
  forCells(*m_graph, [&](const CoverGraph::Grid&, std::uint32_t cell) {
    if (waitsFor[cell] == 0 && !placed[cell]) place(cell);
  });
  follow();
  // What is left lies on rings or downwind of them: each is opened at its first cell.
  forCells(*m_graph, [&](const CoverGraph::Grid&, std::uint32_t cell) {
    if (placed[cell]) return;
    place(cell);
    follow();
  });
}

/// One call of blow().
class SnowDrift::Run {
 public:
  Run(const SnowDrift& drift, const CarriedSnow& snow, std::size_t mass, const DriftSettings& settings,
      double seconds)
      : m_drift(&drift),
        m_graph(drift.m_graph.get()),
        m_snow(&snow),
        m_mass(mass),
        m_settings(&settings),
        m_seconds(seconds),
        m_air(snow.size(), std::vector<double>(m_graph->size(), 0.0)),
        m_done(m_graph->size(), 0),
        m_load(snow.size()) {
    m_totals.eroded.assign(snow.size(), 0.0);
    m_totals.deposited = m_totals.blownIn = m_totals.blownOut = m_totals.eroded;
  }

  void pass(const CoverGraph::Grid& grid, std::uint32_t cell, double friction, double threshold) {
    const double area = static_cast<double>(m_graph->area(cell));
    double width = 0.0;
    m_drift->forExits(grid, cell, [&](std::uint32_t, double w) { width += w; });
    const double limit = driftRate(friction, threshold, m_settings->roughness);
    blowIn(cell, limit);
    const double arriving = m_air[m_mass][cell];  // kg in the time
    if (width == 0.0) return layDown(cell, area, 1.0);
    const double carried = limit * width * m_seconds;
    const double way = area / width;
    if (arriving < carried) {
      const double wanted = (carried - arriving) * -std::expm1(-way / m_settings->fetch);
      takeUp(cell, area, wanted);
    } else if (arriving > carried) {
      layDown(cell, area, (1.0 - carried / arriving) * -std::expm1(-way / m_settings->settlingWay));
    }
    handOn(grid, cell, width);
  }

  DriftTotals take() { return std::move(m_totals); }

 private:
  /// What comes over the border is snow like the border cell's.
  void blowIn(std::uint32_t cell, double limit) {
    const double lying = (*m_snow)[m_mass][cell];
    const double width = m_settings->inflow > 0.0 && lying > 0.0 ? m_drift->windwardBorder(cell) : 0.0;
    const double amount = m_settings->inflow * limit * width * m_seconds;
    if (!(amount > 0.0)) return;
    for (std::size_t q = 0; q < m_snow->size(); ++q) {
      const double part = amount * ((*m_snow)[q][cell] / lying);
      m_air[q][cell] += part;
      m_totals.blownIn[q] += part;
    }
  }

  void takeUp(std::uint32_t cell, double area, double wanted) {
    const double lying = (*m_snow)[m_mass][cell] * area;
    if (!(lying > 0.0)) return;
    const double share = std::min(1.0, wanted / lying);
    for (std::size_t q = 0; q < m_snow->size(); ++q) {
      const double amount = share * (*m_snow)[q][cell];
      (*m_snow)[q][cell] -= amount;
      m_air[q][cell] += amount * area;
      m_totals.eroded[q] += amount * area;
    }
  }

  void layDown(std::uint32_t cell, double area, double share) {
    for (std::size_t q = 0; q < m_snow->size(); ++q) {
      const double amount = share * m_air[q][cell];
      m_air[q][cell] -= amount;
      (*m_snow)[q][cell] += amount / area;
      m_totals.deposited[q] += amount;
    }
  }

  void handOn(const CoverGraph::Grid& grid, std::uint32_t cell, double width) {
    m_done[cell] = 1;
    for (std::size_t q = 0; q < m_snow->size(); ++q) m_load[q] = m_air[q][cell];
    m_drift->forExits(grid, cell, [&](std::uint32_t target, double w) {
      for (std::size_t q = 0; q < m_snow->size(); ++q) {
        const double amount = m_load[q] * (w / width);
        if (target == kOut) {
          m_totals.blownOut[q] += amount;
        } else if (m_done[target]) {
          (*m_snow)[q][target] += amount / static_cast<double>(m_graph->area(target));
          m_totals.deposited[q] += amount;
        } else {
          m_air[q][target] += amount;
        }
      }
    });
  }

  const SnowDrift* m_drift;
  const CoverGraph* m_graph;
  const CarriedSnow* m_snow;
  std::size_t m_mass;
  const DriftSettings* m_settings;
  double m_seconds;
  std::vector<std::vector<double>> m_air;  ///< on its way through a cell, by quantity, times m2
  std::vector<char> m_done;
  std::vector<double> m_load;
  DriftTotals m_totals;
};

DriftTotals SnowDrift::blow(const CarriedSnow& snow, std::size_t mass, const std::vector<float>& friction,
                            const std::vector<float>& threshold, const DriftSettings& settings,
                            double seconds) {
  Run run(*this, snow, mass, settings, seconds);
  std::size_t grid = 0;
  const std::vector<CoverGraph::Grid>& grids = m_graph->grids();
  for (const std::uint32_t cell : m_order) {
    if (cell < grids[grid].first || (grid + 1 < grids.size() && cell >= grids[grid + 1].first))
      grid = m_graph->gridOf(cell);
    run.pass(grids[grid], cell, static_cast<double>(friction[cell]), static_cast<double>(threshold[cell]));
  }
  return run.take();
}

}  // namespace spin
