// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_slides.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace spin {
namespace {

constexpr std::uint8_t kQueued = 1;   ///< waits in this pass
constexpr std::uint8_t kVisited = 2;  ///< was looked at in this pass
constexpr std::uint8_t kWoken = 4;    ///< waits for the next pass
constexpr std::uint8_t kTouched = 8;  ///< its amounts changed in this call

/// Ways down that one visit may use; more are used by the next.
constexpr int kMostWays = 8;
/// Over-relaxation: found to halve the work and to cost 0.1 % of a cone's height.
constexpr double kPassedOn = 0.9;
constexpr double kGreatExcess = 0.3;  ///< share of the tangent from which there is none

}  // namespace

SnowSlides::SnowSlides(std::shared_ptr<const CoverGraph> graph)
    : m_graph(std::move(graph)), m_marks(m_graph->size(), 0) {}

const CoverGraph::Grid& SnowSlides::gridOf(std::uint32_t cell) {
  const std::vector<CoverGraph::Grid>& grids = m_graph->grids();
  const CoverGraph::Grid& last = grids[m_lastGrid];
  if (cell < last.first || cell - last.first >= static_cast<std::uint32_t>(last.width * last.height))
    m_lastGrid = m_graph->gridOf(cell);
  return grids[m_lastGrid];
}

double SnowSlides::steepness(const double* depth, std::uint32_t cell) const {
  return steepestWay(depth, cell, m_graph->grids()[m_graph->gridOf(cell)]).slope;
}

SnowSlides::Way SnowSlides::steepestWay(const double* depth, std::uint32_t cell,
                                        const CoverGraph::Grid& grid) const {
  const std::uint8_t mask = m_graph->neighbours(cell);
  const double here = surface(depth, cell);
  std::array<std::uint32_t, 8> number;
  std::array<double, 8> drop;
  for (std::size_t k = 0; k < 8; ++k) {
    number[k] = cell + static_cast<std::uint32_t>(kCellSteps[k][0] + kCellSteps[k][1] * grid.width);
    drop[k] = mask >> k & 1 ? here - surface(depth, number[k]) : 0.0;
  }
  Way best;
  double square = 0.0;  // of the drop over one cell
  for (std::size_t k = 0; k < 8; k += 2) {
    if (!(mask >> k & 1)) continue;
    if (drop[k] > 0.0 && drop[k] * drop[k] > square) {
      square = drop[k] * drop[k];
      best.target = {number[k], number[k]};
      best.share = 0.0;
    }
    for (const std::size_t corner : {k + 1, (k + 7) % 8}) {
      const double across = drop[corner] - drop[k];
      if (!(mask >> corner & 1) || !(across > 0.0) || !(drop[corner] > 0.0)) continue;
      const bool along = across < drop[k];  // the facet's fall lies between side and corner
      const double s = along ? drop[k] * drop[k] + across * across : 0.5 * drop[corner] * drop[corner];
      if (s <= square) continue;
      square = s;
      best.target = {number[k], number[corner]};
      best.share = along ? across / drop[k] : 1.0;
    }
  }
  best.slope = std::sqrt(square) / grid.cellSize;
  best.reach = grid.cellSize * std::sqrt(1.0 + best.share * best.share);
  return steepestLink(depth, cell, best);
}

SnowSlides::Way SnowSlides::steepestLink(const double* depth, std::uint32_t cell, Way best) const {
  const double here = surface(depth, cell);
  for (const CoverLink& link : m_graph->links(cell)) {
    double drop = static_cast<double>(link.sill);
    if (link.leads())
      drop = here - std::max(drop, surface(depth, link.target));
    else if (link.target == CoverLink::kFalls)
      drop = here - drop;
    const double slope = drop / static_cast<double>(link.distance);
    if (!(slope > best.slope)) continue;
    best.slope = slope;
    best.reach = static_cast<double>(link.distance);
    best.link = &link;
  }
  return best;
}

std::vector<std::uint32_t> SnowSlides::unstableCells(const double* depth, const float* tangents,
                                                     const SlideSettings& settings,
                                                     CpuBackend& backend) const {
  std::vector<std::uint32_t> found;
  for (const CoverGraph::Grid& grid : m_graph->grids()) {
    const auto cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    std::vector<std::vector<std::uint32_t>> parts((cells + CpuBackend::kChunk - 1) / CpuBackend::kChunk);
    backend.forChunks(
        "slides", cells, CpuBackend::kChunk, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
          for (std::size_t c = begin; c < end; ++c) {
            const auto cell = grid.first + static_cast<std::uint32_t>(c);
            if (!(depth[cell] > settings.leastDepth) || !(m_graph->area(cell) > 0.0f)) continue;
            const double limit = static_cast<double>(tangents[cell]) * (1.0 + settings.tolerance);
            if (steepestWay(depth, cell, grid).slope > limit) parts[chunk].push_back(cell);
          }
        });
    for (const auto& part : parts) found.insert(found.end(), part.begin(), part.end());
  }
  return found;
}

SnowSlides::Key SnowSlides::keyOf(const double* depth, std::uint32_t cell) const {
  auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(surface(depth, cell)));
  bits = bits & 0x80000000u ? ~bits : bits | 0x80000000u;  // ordered as the numbers are
  return Key{bits} << 32 | static_cast<Key>(~cell);
}

SlideTotals SnowSlides::settle(const CarriedSnow& snow, const float* tangents, const SlideSettings& settings,
                               CpuBackend& backend) {
  SlideTotals totals;
  totals.slid.assign(snow.size(), 0.0);
  totals.shed = totals.left = totals.slid;
  // A pass looks only at what moved; a facet may also turn steeper beside that, so all cells are asked again.
  for (;;) {
    m_next = unstableCells(snow[0], tangents, settings, backend);
    totals.unsettled = m_next.size();
    if (m_next.empty() || totals.visits >= settings.mostVisits) break;
    for (const std::uint32_t cell : m_next) m_marks[cell] |= kWoken;
    ScopedStage stage(backend.timings(), "slides");
    while (!m_next.empty() && totals.visits < settings.mostVisits) pass(snow, tangents, settings, totals);
    for (const std::uint32_t cell : m_next) m_marks[cell] &= static_cast<std::uint8_t>(~kWoken);
  }
  for (std::size_t t = 0; t < m_touched.size(); ++t) {
    const std::uint32_t cell = m_touched[t];
    m_marks[cell] = 0;
    for (std::size_t q = 0; q < snow.size(); ++q)
      totals.slid[q] += std::max(0.0, m_before[t * snow.size() + q] - snow[q][cell]) *
                        static_cast<double>(m_graph->area(cell));
  }
  m_next.clear(), m_touched.clear(), m_before.clear();
  return totals;
}

/// Visits the woken cells and all that snow reaches from them once, from the highest down.
void SnowSlides::pass(const CarriedSnow& snow, const float* tangents, const SlideSettings& settings,
                      SlideTotals& totals) {
  m_queue.clear();
  for (const std::uint32_t cell : m_next) {
    m_marks[cell] = static_cast<std::uint8_t>((m_marks[cell] & ~kWoken) | kQueued);
    m_queue.push_back(keyOf(snow[0], cell));
  }
  m_next.clear();
  std::sort(m_queue.begin(), m_queue.end(), std::greater<>());
  std::vector<std::uint32_t> visited;
  m_inserted.clear();
  for (std::size_t at = 0; at < m_queue.size() || !m_inserted.empty();) {
    Key key;
    if (m_inserted.empty() || (at < m_queue.size() && m_queue[at] > m_inserted.front())) {
      key = m_queue[at++];
    } else {
      std::pop_heap(m_inserted.begin(), m_inserted.end());
      key = m_inserted.back();
      m_inserted.pop_back();
    }
    const auto cell = ~static_cast<std::uint32_t>(key);
    m_marks[cell] = static_cast<std::uint8_t>((m_marks[cell] & ~kQueued) | kVisited);
    visited.push_back(cell);
    if (visit(cell, snow, tangents, settings, totals)) wakeAround(snow[0], cell);
  }
  for (const std::uint32_t cell : visited) m_marks[cell] &= static_cast<std::uint8_t>(~kVisited);
  totals.visits += visited.size();
  ++totals.passes;
}

/// Lets a cell give until it is not too steep; true if it gave.
bool SnowSlides::visit(std::uint32_t cell, const CarriedSnow& snow, const float* tangents,
                       const SlideSettings& settings, SlideTotals& totals) {
  const double* depth = snow[0];
  const CoverGraph::Grid& grid = gridOf(cell);
  const double tangent = static_cast<double>(tangents[cell]), area = static_cast<double>(m_graph->area(cell));
  bool gave = false;
  for (int ways = 0; ways < kMostWays && depth[cell] > settings.leastDepth; ++ways) {
    const Way way = steepestWay(depth, cell, grid);
    if (!(way.slope > tangent * (1.0 + settings.tolerance))) return gave;
    // What evens the slope out: the cell sinks, and where the way ends the surface rises.
    double perVolume = 1.0 / area;
    if (!way.link) {
      const double first = 1.0 - way.share;
      perVolume += first * first / static_cast<double>(m_graph->area(way.target[0])) +
                   way.share * way.share / static_cast<double>(m_graph->area(way.target[1]));
    } else if (way.link->leads() && surface(depth, way.link->target) > static_cast<double>(way.link->sill)) {
      perVolume += 1.0 / static_cast<double>(m_graph->area(way.link->target));
    }
    // Snow that comes down a slope just at its angle goes on down, all of it; what lies much too steep is
    // evened out only, lest it heaps up below.
    const double excess = way.slope / tangent - 1.0;
    const double passedOn = 1.0 + kPassedOn * std::clamp(1.0 - excess / kGreatExcess, 0.0, 1.0);
    give(snow, cell, way, passedOn * (way.slope - tangent) * way.reach / perVolume, totals);
    gave = true;
  }
  if (gave && depth[cell] > settings.leastDepth) wake(cell);
  return gave;
}

void SnowSlides::give(const CarriedSnow& snow, std::uint32_t cell, const Way& way, double volume,
                      SlideTotals& totals) {
  const double area = static_cast<double>(m_graph->area(cell));
  const double share = std::min(1.0, volume / (snow[0][cell] * area));
  touch(cell, snow);
  const auto pass = [&](std::uint32_t to, double part) {
    if (part > 0.0) touch(to, snow);
    for (std::size_t q = 0; q < snow.size() && part > 0.0; ++q)
      snow[q][to] += share * snow[q][cell] * part * area / static_cast<double>(m_graph->area(to));
    if (part > 0.0) receive(to, snow);
  };
  if (!way.link) {
    pass(way.target[0], 1.0 - way.share);
    pass(way.target[1], way.share);
  } else if (way.link->leads()) {
    pass(way.link->target, 1.0);
  }
  for (std::size_t q = 0; q < snow.size(); ++q) {
    const double amount = share * snow[q][cell];
    if (way.link && !way.link->leads()) totals.left[q] += amount * area;
    if (way.link && way.link->leads() && way.link->falls) totals.shed[q] += amount * area;
    snow[q][cell] -= amount;
  }
}

/// Puts a cell that snow reached into this pass, or into the next if its turn is over.
void SnowSlides::receive(std::uint32_t cell, const CarriedSnow& snow) {
  if (m_marks[cell] & kQueued) return;
  if (m_marks[cell] & kVisited) return wake(cell);
  m_marks[cell] |= kQueued;
  m_inserted.push_back(keyOf(snow[0], cell));
  std::push_heap(m_inserted.begin(), m_inserted.end());
}

void SnowSlides::touch(std::uint32_t cell, const CarriedSnow& snow) {
  if (m_marks[cell] & kTouched) return;
  m_marks[cell] |= kTouched;
  m_touched.push_back(cell);
  for (const double* quantity : snow) m_before.push_back(quantity[cell]);
}

void SnowSlides::wake(std::uint32_t cell) {
  if (m_marks[cell] & kWoken) return;
  m_marks[cell] |= kWoken;
  m_next.push_back(cell);
}

/// Cells that may have lost their support.
void SnowSlides::wakeAround(const double* depth, std::uint32_t cell) {
  const std::uint8_t mask = m_graph->neighbours(cell);
  const int width = gridOf(cell).width;
  const double here = surface(depth, cell);
  for (std::size_t k = 0; k < 8; ++k) {
    if (!(mask >> k & 1)) continue;
    const auto beside = cell + static_cast<std::uint32_t>(kCellSteps[k][0] + kCellSteps[k][1] * width);
    if (surface(depth, beside) > here) wake(beside);
  }
  for (const CoverLink& link : m_graph->links(cell))
    if (link.leads() && !link.falls) wake(link.target);
}

}  // namespace spin
