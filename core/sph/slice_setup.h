// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/sph/slice_view.h"
#include "core/sph/sph_slice.h"

namespace spin {

/// Particles as the solver's arrays hold them.
struct SliceHostState {
  std::vector<std::int32_t> x, y, z;
  std::vector<PairRecord> records;
  std::vector<std::uint32_t> ids;
};

/// Every value in range, the box not empty, periodic lengths whole, and not more cells than memory is for.
Status checkSliceConfig(const SphSliceConfig& config);
SliceGrid sliceGrid(const SphSliceConfig& config);
SliceConstants sliceConstants(const SphSliceConfig& config);
std::size_t sliceBinCount(const SliceGrid& grid);
/// Arrays padded by kPairPadding elements.
Result<SliceHostState> sliceHostState(const SphSliceConfig& config, const std::vector<Vec3d>& positions,
                                      const std::vector<Vec3d>& velocities);
SphParticle sliceParticle(const SphSliceConfig& config, const SliceHostState& state, std::size_t i,
                          float excess);

}  // namespace spin
