// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cloud/cloud_solids.h"
#include "core/cloud/cloud_state.h"
#include "core/cloud/flow_cells.h"

namespace spin {

enum class SprayEnd : std::uint8_t { Flies, Landed, Rejoins, Left };

/// What spray flies through.
struct SprayWorld {
  const CloudSolids& solids;
  const FlowCells* flow;  ///< null where the flow cannot take anything
  Box3d box;              ///< beyond it spray is gone
  double spacing;         ///< m, of the flow
  int dense;              ///< neighbours from which a place is in the flow
};

/// Parcels do not go back into the flow that they have just left, s.
inline constexpr double kSprayGrace = 0.1;

/// Moves a parcel along its velocity; it stops before what is solid, and in the flow. `end` is where it would
/// have been next: in the solid where it landed.
SprayEnd flyOn(SprayParcel& parcel, double seconds, double film, const SprayWorld& world, Vec3d& end);

}  // namespace spin
