// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/physics/equation_of_state.h"
#include "core/sph/pair_law.h"
#include "core/sph/row_ranges.h"

/// The stages that go over single particles, and the pair stages in their thread-per-particle form (CUDA, and
/// the reference that the vector forms are tested against).
namespace spin {

inline constexpr float kCellFraction = 1.0f / static_cast<float>(kCellUnits);

/// Sort key: row, then quarter cell along x.
struct KeyKernel {
  SliceView v;
  SPIN_HD void operator()(std::size_t i) const {
    v.key[i] =
        static_cast<std::uint32_t>(v.grid.rowOf(v.y[i], v.z[i]) * v.grid.binsX() + v.grid.binOf(v.x[i]));
  }
};

/// Copies particles into sorted order; velocities go by way of the acceleration arrays, which are free now.
struct GatherKernel {
  SliceView v;
  const std::uint32_t* order;
  std::int32_t *x, *y, *z;
  std::uint32_t *id, *key;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t from = order[i];
    x[i] = v.x[from];
    y[i] = v.y[from];
    z[i] = v.z[from];
    id[i] = v.id[from];
    key[i] = v.key[from];
    v.ax[i] = v.record[from].vx;
    v.ay[i] = v.record[from].vy;
    v.az[i] = v.record[from].vz;
  }
};

struct TakeVelocityKernel {
  SliceView v;
  SPIN_HD void operator()(std::size_t i) const {
    v.record[i].vx = v.ax[i];
    v.record[i].vy = v.ay[i];
    v.record[i].vz = v.az[i];
  }
};

/// Particle i starts every bin after its predecessor's up to its own; i = count closes the rest.
struct BinStartKernel {
  SliceView v;
  std::uint32_t binCount;
  SPIN_HD void operator()(std::size_t i) const {
    const std::uint32_t first = i == 0 ? 0 : v.key[i - 1] + 1;
    const std::uint32_t last = i == v.count ? binCount : v.key[i];
    for (std::uint32_t bin = first; bin <= last; ++bin) v.binStart[bin] = static_cast<std::uint32_t>(i);
  }
};

/// Density from the pair sum and the floor's share, then pressure.
/// Floor: the half-space integral lambda at rest density.
struct PressureKernel {
  SliceView v;
  SPIN_HD void operator()(std::size_t i) const {
    const SliceConstants& c = v.constants;
    const float wall =
        c.floor ? CubicSpline::halfSpaceIntegral(static_cast<float>(v.z[i]) * kCellFraction) : 0.0f;
    const float excess = c.densityFactor * v.excess[i] + (wall - 1.0f);
    const float density = c.restDensity * (1.0f + excess);
    float pressure = linearPressure(excess, c.restDensity, c.soundSpeed);
    if (c.clampTension) pressure = clampTension(pressure);
    v.excess[i] = excess;
    v.record[i].inverseDensity = 1.0f / density;
    v.record[i].pressureTerm = c.pressureFactor * pressure / (density * density);
  }
};

/// Semi-implicit Euler: velocity from the accelerations, then position from the new velocity. The floor acts
/// with the particle's own pressure term and the wall's, p_w = max(0, p + rho g d): leaving the second out
/// errs by 24 % and more in a column at rest.
struct IntegrateKernel {
  SliceView v;

  SPIN_HD float floorAcceleration(std::size_t i) const {
    const SliceConstants& c = v.constants;
    const float s = static_cast<float>(v.z[i]) * kCellFraction;
    if (s >= 1.0f) return 0.0f;
    const float inverseDensity = v.record[i].inverseDensity;
    const float own = v.record[i].pressureTerm / c.pressureFactor;  // p / rho^2
    const float pressure = own / (inverseDensity * inverseDensity);
    const float head = c.gravity * s * c.support / inverseDensity;
    const float wall = maximum(pressure + head, 0.0f) / (c.restDensity * c.restDensity);
    return c.restDensity * (own + wall) * CubicSpline::planeIntegral(s) / c.support;
  }

  /// Adds a displacement in m, rounded to units; periodic axes wrap.
  SPIN_HD std::int32_t moved(std::int32_t position, float displacement, std::int32_t cells,
                             bool periodic) const {
    // Half a cell a step at most: a particle faster than that is beyond any stable step already.
    const float limit = 0.5f * static_cast<float>(kCellUnits);
    const float units = minimum(maximum(displacement * v.constants.unitsPerMetre, -limit), limit);
    position += static_cast<std::int32_t>(lrintf(units));
    if (periodic) {
      const std::int32_t period = cells << kCellBits;
      if (position < 0) position += period;
      if (position >= period) position -= period;
    }
    // Within this the difference of two positions cannot overflow.
    const std::int32_t far = 0x3fffffff;
    return position > far ? far : position < -far ? -far : position;
  }

  SPIN_HD void operator()(std::size_t i) const {
    const SliceConstants& c = v.constants;
    PairRecord& r = v.record[i];
    const float floor = c.floor ? floorAcceleration(i) : 0.0f;
    r.vx += c.timeStep * v.ax[i];
    r.vy += c.timeStep * v.ay[i];
    r.vz += c.timeStep * (v.az[i] - c.gravity + floor);
    v.x[i] = moved(v.x[i], c.timeStep * r.vx, v.grid.cellsX, v.grid.periodicX);
    v.y[i] = moved(v.y[i], c.timeStep * r.vy, v.grid.cellsY, v.grid.periodicY);
    v.z[i] = moved(v.z[i], c.timeStep * r.vz, v.grid.cellsZ, false);
  }
};

/// x_j - x_i in units of the support radius.
SPIN_HD_INLINE PairVector<float> pairOffset(const SliceView& v, std::size_t i, std::size_t j,
                                            const RowRange& range) {
  return {static_cast<float>(v.x[j] + range.shiftX - v.x[i]) * kCellFraction,
          static_cast<float>(v.y[j] + range.shiftY - v.y[i]) * kCellFraction,
          static_cast<float>(v.z[j] - v.z[i]) * kCellFraction};
}

/// Thread per particle: bare density sum.
struct DensityPairKernel {
  SliceView v;
  SPIN_HD void operator()(std::size_t i) const {
    float sum = 0.0f;
    forRowRanges(v, SliceGrid::clampTo(v.y[i] >> kCellBits, v.grid.cellsY),
                 SliceGrid::clampTo(v.z[i] >> kCellBits, v.grid.cellsZ), v.x[i], v.x[i],
                 [&](const RowRange& range) {
                   for (std::uint32_t j = range.begin; j < range.end; ++j)
                     sum += densityTerm(pairOffset(v, i, j, range));
                 });
    v.excess[i] = sum;
  }
};

/// Thread per particle: pressure and viscosity.
struct ForcePairKernel {
  SliceView v;
  SPIN_HD void operator()(std::size_t i) const {
    const PairRecord own = v.record[i];
    const float dragFactor = v.constants.viscosityFactor * own.inverseDensity;
    PairVector<float> sum{0.0f, 0.0f, 0.0f};
    forRowRanges(v, SliceGrid::clampTo(v.y[i] >> kCellBits, v.grid.cellsY),
                 SliceGrid::clampTo(v.z[i] >> kCellBits, v.grid.cellsZ), v.x[i], v.x[i],
                 [&](const RowRange& range) {
                   for (std::uint32_t j = range.begin; j < range.end; ++j) {
                     const PairRecord other = v.record[j];
                     addPairForce(pairOffset(v, i, j, range), own.pressureTerm + other.pressureTerm,
                                  dragFactor * other.inverseDensity,
                                  {own.vx - other.vx, own.vy - other.vy, own.vz - other.vz}, sum);
                   }
                 });
    v.ax[i] = sum.x;
    v.ay[i] = sum.y;
    v.az[i] = sum.z;
  }
};

}  // namespace spin
