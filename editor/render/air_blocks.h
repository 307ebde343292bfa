// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"
#include "core/sim/air_part.h"

namespace spin {

/// What a packed cloud may take.
struct AirLimits {
  std::size_t slots = 8192;        ///< blocks that hold something; each takes 11.7 kB a channel
  std::size_t blocks = 2'000'000;  ///< in the box round them
};

/// Fields of the air for a 3D texture: cubic blocks of cells where something hangs, each with a rim of its
/// neighbours' cells so that a texture unit can interpolate over its sides, and an index of the blocks in the
/// box round them. Where no block is beside, the rim repeats the outermost cells.
struct AirBlocks {
  static constexpr int kSide = 16, kPadded = kSide + 2;

  Vec3d origin{};                     ///< local m, lower corner of block (0, 0, 0)
  double cell = 1.0;                  ///< m; a multiple of the part's where that has too many
  std::array<int, 3> size{};          ///< blocks along x, y, z
  std::array<int, 3> slots{};         ///< of the texture along x, y, z
  int channels = 1;                   ///< 1 or 2
  std::vector<std::uint16_t> index;   ///< by block, x fastest: 0 nothing, else slot + 1
  std::vector<std::uint16_t> texels;  ///< binary16, channels side by side, x fastest, over all slots

  bool empty() const { return texels.empty(); }
};

/// Packs values by cell, one array in the order of the part's fields per channel (1 or 2). Blocks in which
/// the last channel is nowhere above `least` are left out. A cloud beyond the limits gets cells of twice the
/// side, and so on, with the mean of those they hold; one that still does not fit at 16 times is left out.
AirBlocks packAir(const AirPart& air, const std::vector<const std::vector<float>*>& values, float least,
                  const AirLimits& limits, CpuBackend& backend);

}  // namespace spin
