// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/math/scalar_ops.h"

namespace spin {

/// A brick in the arrays of a lattice.
struct AirBrick {
  std::int32_t first = 0;            ///< index of its first cell
  std::int32_t x = 0, y = 0, z = 0;  ///< of that cell in the lattice
};

/// Steps in the arrays from a cell to the next one along y and z; along x it is 1.
struct AirStrides {
  std::int32_t y = 0, z = 0;
};

/// What a pass over cells is given: one cell, or a pack of neighbours along x (air_loop_impl.h). This is the
/// one cell, of the general form and of CUDA.
struct CellAt {
  using Real = float;
  using Int = int;
  static constexpr int kWidth = 1;
  int index = 0, x = 0, y = 0, z = 0;

  SPIN_HD_INLINE float load(const float* p, int offset = 0) const { return p[index + offset]; }
  SPIN_HD_INLINE void store(float value, float* p) const { p[index] = value; }
  SPIN_HD_INLINE float lanesX() const { return static_cast<float>(x); }
  SPIN_HD_INLINE static float even(const float* p) { return *p; }
  SPIN_HD_INLINE static float pairSum(const float* p) { return p[0] + p[1]; }
  /// row[x / 2], for a row of half as many cells.
  SPIN_HD_INLINE float doubled(const float* row) const { return row[x >> 1]; }
};

}  // namespace spin
