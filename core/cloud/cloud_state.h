// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/serialize.h"
#include "core/snow/snow_fallout.h"
#include "core/sph/flow_solver.h"

namespace spin {

/// Many drops (or one clump of snow) that fly together. Its mass is a whole number of kGivenUnit of a flow
/// particle's, so nothing is lost to rounding between the two.
struct SprayParcel {
  Vec3d position{};            ///< m
  Vec3d velocity{};            ///< m/s
  double diameter = 0.0;       ///< m, of its drops
  double born = 0.0;           ///< s of film
  std::uint32_t id = 0;        ///< in the order of birth
  std::uint32_t material = 0;  ///< of the flow
  std::int64_t units = 0;      ///< mass
};

/// Since frame 0. Every term is counted where it happens.
struct CloudAccount {
  double fromFlow = 0.0;   ///< kg that particles gave, or were
  double toFlow = 0.0;     ///< kg that came back
  double toAir = 0.0;      ///< kg of mist, snow and vapour handed to the grid
  double ranOff = 0.0;     ///< kg that landed as water where it is not flow
  double settled = 0.0;    ///< kg handed to the snow cover
  double onThings = 0.0;   ///< kg that stays on walls and models, and on ground without a cover
  double sprayLeft = 0.0;  ///< kg of spray beyond the air's box
  /// N s that the flow lost to spray and air, that the grid got and that spray got from both: the first is
  /// the sum of the others. A particle's is that of the mass that it has left.
  Vec3d impulseFromFlow{}, impulseToAir{}, impulseToSpray{};
  std::uint64_t refused = 0;  ///< parcels that were not made since there were too many
};

/// Everything that goes on from part to part, but the grid's.
struct CloudState {
  std::vector<SprayParcel> parcels;
  CloudAccount account;
  std::uint32_t nextParcel = 0;
  std::uint32_t part = 0;  ///< number of parts done

  void save(ByteWriter& out) const {
    out.putArray(parcels);
    out.put(account);
    out.put(nextParcel);
    out.put(part);
  }
  void load(ByteReader& in) {
    parcels = in.getArray<SprayParcel>();
    account = in.get<CloudAccount>();
    nextParcel = in.get<std::uint32_t>();
    part = in.get<std::uint32_t>();
  }
};

}  // namespace spin
