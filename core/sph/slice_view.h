// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"

namespace spin {

/// Positions are fixed-point: 2^20 units to a cell, and a cell is one support radius. Differences of
/// positions are then exact, resolution is the same everywhere, and a pattern that is moved by whole cells
/// gives the same bits.
inline constexpr int kCellBits = 20;
inline constexpr std::int32_t kCellUnits = 1 << kCellBits;
/// Along x, particles are sorted into quarter cells, so that a search takes only the part of a row it needs.
inline constexpr int kBinBits = kCellBits - 2;
inline constexpr std::int32_t kMaxCells = 1 << (30 - kCellBits);
/// Elements that vector loads may read past the end of an array.
inline constexpr std::size_t kPairPadding = 16;

/// Linear cell order: x fastest, so the cells of a row are contiguous and 27 cells are 9 ranges. Particles
/// outside the box count to the border cells: clamping brings no two particles closer than they are, so
/// neighbours are still found.
struct SliceGrid {
  std::int32_t cellsX = 1, cellsY = 1, cellsZ = 1;
  bool periodicX = false, periodicY = false;

  SPIN_HD_INLINE std::int32_t binsX() const { return cellsX << (kCellBits - kBinBits); }
  SPIN_HD_INLINE std::int32_t rows() const { return cellsY * cellsZ; }
  SPIN_HD_INLINE static std::int32_t clampTo(std::int32_t value, std::int32_t count) {
    return value < 0 ? 0 : value >= count ? count - 1 : value;
  }
  SPIN_HD_INLINE std::int32_t binOf(std::int32_t x) const { return clampTo(x >> kBinBits, binsX()); }
  SPIN_HD_INLINE std::int32_t rowOf(std::int32_t y, std::int32_t z) const {
    return clampTo(z >> kCellBits, cellsZ) * cellsY + clampTo(y >> kCellBits, cellsY);
  }
};

/// What a pair needs of its second partner, in one stretch of memory.
struct PairRecord {
  float vx, vy, vz;      ///< m/s
  float pressureTerm;    ///< (m norm / h^4) p / rho^2, m/s2
  float inverseDensity;  ///< m3/kg
};

/// Factors that do not change from pair to pair.
struct SliceConstants {
  float densityFactor = 0;    ///< m norm / (rho0 h^3)
  float pressureFactor = 0;   ///< m norm / h^4
  float viscosityFactor = 0;  ///< 2 mu m norm / h^5
  float restDensity = 1000;   ///< kg/m3
  float soundSpeed = 1;       ///< m/s
  float gravity = 0;          ///< m/s2, downward
  float support = 1;          ///< h, m
  float unitsPerMetre = 1;    ///< kCellUnits / h
  float timeStep = 0;         ///< s
  bool floor = true;          ///< solid half-space below z = 0
  bool clampTension = true;   ///< no negative pressure
};

/// All that a kernel touches. Arrays are sorted by row, then by quarter cell along x.
struct SliceView {
  std::uint32_t count = 0;
  std::int32_t *x = nullptr, *y = nullptr, *z = nullptr;
  PairRecord* record = nullptr;
  float* excess = nullptr;  ///< rho / rho0 - 1; between the stages density and pressure the bare pair sum
  float *ax = nullptr, *ay = nullptr, *az = nullptr;  ///< pair acceleration, m/s2
  std::uint32_t* id = nullptr;
  std::uint32_t* key = nullptr;
  std::uint32_t* binStart = nullptr;  ///< first particle of each bin; rows() * binsX() + 1 entries
  SliceGrid grid;
  SliceConstants constants;
};

}  // namespace spin
