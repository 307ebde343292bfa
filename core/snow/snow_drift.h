// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/snow/cover_graph.h"
#include "core/snow/snow_slides.h"

namespace spin {

struct DriftSettings {
  double roughness = 0.01;  ///< m, that goes with the friction velocities
  double fetch =
      500.0 / 3.0;  ///< m in which transport grows to all but 1/e of its limit (Liston and Sturm 1998)
  /// m in which a surplus falls out but for 1/e. Half of what drifts is carried below some 0.15 m and falls
  /// at 0.4 m/s (Pomeroy and Male 1992): 0.35 s times the wind 10 m up.
  double settlingWay = 5.0;
  /// What blows in over the domain's windward borders, as a share of what the border cells' wind can carry:
  /// 1 = the land goes on alike, 0 = none.
  double inflow = 1.0;
};

/// What a call moved, by carried quantity, times m2.
struct DriftTotals {
  std::vector<double> eroded, deposited;  ///< taken up, and laid down again (what blew in too)
  std::vector<double> blownIn, blownOut;  ///< over the domain's borders; out also off models into nothing
};

/// Moves snow with the wind along the cells. Transport is steady within a call: from cell to cell downwind it
/// nears what the wind can carry there, growing over the fetch by taking snow up, falling over the settling
/// way by laying it down. The flow out of a cell goes over its lee sides, by the wind's direction, into the
/// cells there; each flow is booked once, so that mass closes to rounding. Snow comes down from roofs with
/// the wind and never up onto them. Sublimation of blowing snow is not modelled.
class SnowDrift {
 public:
  explicit SnowDrift(std::shared_ptr<const CoverGraph> graph);

  const CoverGraph& graph() const { return *m_graph; }
  /// Where the wind blows to, unit, by cell; orders the cells so that each comes after those that lie upwind.
  /// Where directions close a ring, what comes round falls out at its start.
  void setDirections(const std::vector<Vec2f>& directions);
  /// snow[mass] is the quantity that the rates count, kg/m2; a cell gives at most all of it.
  /// friction: of the wind, threshold: from which the cell's snow drifts; friction velocities in m/s, by
  /// cell.
  DriftTotals blow(const CarriedSnow& snow, std::size_t mass, const std::vector<float>& friction,
                   const std::vector<float>& threshold, const DriftSettings& settings, double seconds);

 private:
  static constexpr std::uint32_t kOut = UINT32_MAX;
  class Run;
  template <class Visit>
  void forExits(const CoverGraph::Grid& grid, std::uint32_t cell, const Visit& visit) const;
  double windwardBorder(std::uint32_t cell) const;

  std::shared_ptr<const CoverGraph> m_graph;
  std::vector<Vec2f> m_direction;
  std::vector<std::uint32_t> m_order;
};

}  // namespace spin
