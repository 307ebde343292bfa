// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/nodes/flow_nodes.h"
#include "core/sim/snapshot.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// The particles that enter at a time: a lattice across the inflow, one spacing wide.
struct InflowLattice {
  std::vector<Vec3d> positions;  ///< local m
  Vec3d velocity{};              ///< m/s
  double thickness = 0.0;        ///< m, of the sheet or the jet
  double interval = 0.0;  ///< s from one lattice to the next, at least a spacing behind it; 0 = no flow
  std::string problem;    ///< why there is none
};
InflowLattice inflowLattice(const SceneSnapshot& scene, const WaterSourceNode& source, double spacing);

/// When a source's next lattice enters. The state is a number that goes with checkpoints.
class InflowClock {
 public:
  /// Share of the interval since the last lattice; begins full, so that the first one enters at once.
  double share = 1.0;

  /// Seconds from now to the next lattice, for the interval that holds now (> 0).
  double wait(double interval) const { return share >= 1.0 ? 0.0 : (1.0 - share) * interval; }
  void advance(double seconds, double interval) { share += seconds / interval; }
  void entered() { share = 0.0; }
};

}  // namespace spin
