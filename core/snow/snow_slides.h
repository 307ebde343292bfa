// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/parallel.h"
#include "core/snow/cover_graph.h"

namespace spin {

/// What moves when snow moves: amounts per m2 by cell of the graph, the first one its depth, m. A cell's
/// share of each goes along.
using CarriedSnow = std::vector<double*>;

struct SlideSettings {
  double tolerance = 0.005;          ///< share by which a slope may be over its tangent: 0.14 degrees at 38
  double leastDepth = 1e-6;          ///< m: a thinner film stays
  std::size_t mostVisits = 4000000;  ///< of cells: bounds the time; what is then too steep moves next time
};

/// What a call moved, by carried quantity, times m2 (depth: m3).
struct SlideTotals {
  std::vector<double> slid;  ///< net amount that left cells for others
  std::vector<double> shed;  ///< fell over rims of models onto cells below; a part of what slid
  std::vector<double> left;  ///< went over the domain's border or off models into nothing
  int passes = 0;
  std::size_t visits = 0;
  std::size_t unsettled = 0;  ///< cells that are still too steep
};

/// Moves snow that lies steeper than its angle of repose down the steepest of the eight triangular facets
/// about its cell (Tarboton 1997: the slope and its direction are then free of the grid's axes), cell after
/// cell from the highest down, until no cell is too steep. One thread walks; the order depends on heights and
/// cell numbers only.
class SnowSlides {
 public:
  explicit SnowSlides(std::shared_ptr<const CoverGraph> graph);

  const CoverGraph& graph() const { return *m_graph; }
  /// tangents: of the angle of repose, by cell.
  SlideTotals settle(const CarriedSnow& snow, const float* tangents, const SlideSettings& settings,
                     CpuBackend& backend);
  /// Tangent of the steepest way down from a cell's snow surface: what settle() holds against the tangents.
  /// 0 where nothing is lower.
  double steepness(const double* depth, std::uint32_t cell) const;

 private:
  /// The steepest way down: over an edge between two neighbours, or a link.
  struct Way {
    double slope = 0.0;
    double reach = 0.0;                     ///< m in plan
    std::array<std::uint32_t, 2> target{};  ///< neighbours
    double share = 0.0;                     ///< of the second target
    const CoverLink* link = nullptr;        ///< instead of the targets
  };
  using Key = std::uint64_t;  ///< height above number: the largest goes first

  Way steepestWay(const double* depth, std::uint32_t cell, const CoverGraph::Grid& grid) const;
  Way steepestLink(const double* depth, std::uint32_t cell, Way best) const;
  const CoverGraph::Grid& gridOf(std::uint32_t cell);
  std::vector<std::uint32_t> unstableCells(const double* depth, const float* tangents,
                                           const SlideSettings& settings, CpuBackend& backend) const;
  void pass(const CarriedSnow& snow, const float* tangents, const SlideSettings& settings,
            SlideTotals& totals);
  bool visit(std::uint32_t cell, const CarriedSnow& snow, const float* tangents,
             const SlideSettings& settings, SlideTotals& totals);
  void give(const CarriedSnow& snow, std::uint32_t cell, const Way& way, double volume, SlideTotals& totals);
  void receive(std::uint32_t cell, const CarriedSnow& snow);
  void touch(std::uint32_t cell, const CarriedSnow& snow);
  void wakeAround(const double* depth, std::uint32_t cell);
  void wake(std::uint32_t cell);
  double surface(const double* depth, std::uint32_t cell) const {
    return static_cast<double>(m_graph->bed(cell)) + depth[cell];
  }
  Key keyOf(const double* depth, std::uint32_t cell) const;

  std::shared_ptr<const CoverGraph> m_graph;
  std::vector<std::uint8_t> m_marks;     ///< by cell
  std::vector<std::uint32_t> m_next;     ///< cells to look at in the next pass
  std::vector<std::uint32_t> m_touched;  ///< cells that snow left or reached
  std::vector<double> m_before;          ///< what they carried
  std::vector<Key> m_queue, m_inserted;  ///< of this pass: sorted, and a heap
  std::size_t m_lastGrid = 0;
};

}  // namespace spin
