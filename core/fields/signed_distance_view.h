// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"

namespace spin {

/// What a place is, or the number of its block.
inline constexpr std::uint32_t kFieldOutside = UINT32_MAX;
inline constexpr std::uint32_t kFieldInside = UINT32_MAX - 1;
/// Cells along a block; a block stores the values at its corners too, so a cell never needs two blocks.
inline constexpr int kFieldBlock = 8;
inline constexpr int kFieldNodes = kFieldBlock + 1;

/// A signed-distance field as kernels read it: trivially copyable, on whatever device its arrays lie.
struct SignedDistanceView {
  const std::uint32_t* blocks = nullptr;  ///< kFieldOutside, kFieldInside or a block's number; x fastest
  const float* values = nullptr;          ///< kFieldNodes^3 per block, m; x fastest
  std::int32_t blocksX = 0, blocksY = 0, blocksZ = 0;
  float originX = 0, originY = 0, originZ = 0;  ///< of the first node, m
  float cellsPerMetre = 1;
  float reach = 0;  ///< distances are stored up to here at least, m

  struct Value {
    float distance = 0;         ///< m, below 0 inside
    float x = 0, y = 0, z = 1;  ///< gradient, not normalised; 0 deep inside
  };

  /// Whether anything is known there; then its value. Deep inside the distance is -reach and the gradient 0.
  SPIN_HD_INLINE bool sample(float px, float py, float pz, Value& value) const {
    const float gx = (px - originX) * cellsPerMetre, gy = (py - originY) * cellsPerMetre,
                gz = (pz - originZ) * cellsPerMetre;
    // Written so that a NaN is outside.
    const bool in =
        gx >= 0.0f && gy >= 0.0f && gz >= 0.0f && gx < static_cast<float>(blocksX * kFieldBlock) &&
        gy < static_cast<float>(blocksY * kFieldBlock) && gz < static_cast<float>(blocksZ * kFieldBlock);
    if (!in) return false;
    const std::int32_t ix = static_cast<std::int32_t>(gx), iy = static_cast<std::int32_t>(gy),
                       iz = static_cast<std::int32_t>(gz);
    const std::int32_t bx = ix / kFieldBlock, by = iy / kFieldBlock, bz = iz / kFieldBlock;
    const std::uint32_t block = blocks[(static_cast<std::size_t>(bz) * static_cast<std::size_t>(blocksY) +
                                        static_cast<std::size_t>(by)) *
                                           static_cast<std::size_t>(blocksX) +
                                       static_cast<std::size_t>(bx)];
    if (block == kFieldOutside) return false;
    if (block == kFieldInside) {
      value = {-reach, 0.0f, 0.0f, 0.0f};
      return true;
    }
    const float* v = values + static_cast<std::size_t>(block) * (kFieldNodes * kFieldNodes * kFieldNodes) +
                     ((iz - bz * kFieldBlock) * kFieldNodes + (iy - by * kFieldBlock)) * kFieldNodes +
                     (ix - bx * kFieldBlock);
    value =
        interpolate(v, gx - static_cast<float>(ix), gy - static_cast<float>(iy), gz - static_cast<float>(iz));
    return true;
  }

 private:
  /// Trilinear, with its gradient.
  SPIN_HD_INLINE Value interpolate(const float* v, float u, float w, float t) const {
    constexpr int kY = kFieldNodes, kZ = kFieldNodes * kFieldNodes;
    const float a00 = v[0] + u * (v[1] - v[0]), a10 = v[kY] + u * (v[kY + 1] - v[kY]);
    const float a01 = v[kZ] + u * (v[kZ + 1] - v[kZ]), a11 = v[kZ + kY] + u * (v[kZ + kY + 1] - v[kZ + kY]);
    const float b0 = a00 + w * (a10 - a00), b1 = a01 + w * (a11 - a01);
    const float x0 = (v[1] - v[0]) + w * ((v[kY + 1] - v[kY]) - (v[1] - v[0]));
    const float x1 = (v[kZ + 1] - v[kZ]) + w * ((v[kZ + kY + 1] - v[kZ + kY]) - (v[kZ + 1] - v[kZ]));
    const float y0 = a10 - a00, y1 = a11 - a01;
    return {b0 + t * (b1 - b0), cellsPerMetre * (x0 + t * (x1 - x0)), cellsPerMetre * (y0 + t * (y1 - y0)),
            cellsPerMetre * (b1 - b0)};
  }
};

}  // namespace spin
