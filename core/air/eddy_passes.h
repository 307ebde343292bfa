// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/air/velocity_passes.h"

/// Eddies smaller than a cell: they mix what the grid resolves, as a viscosity (C h)^2 |S| (Smagorinsky
/// 1963). Without it what falling water gives to the air would pile up at the size of the cells.
namespace spin {

/// What neighbours share at most, so that the explicit step is stable.
inline constexpr double kMostMix = 0.125;

/// mix = viscosity time / h^2 = C^2 |S| time at cells, |S| = sqrt(2 S_ij S_ij).
struct StrainPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float* u[3];
  float* mix;
  float share;  ///< C^2 time / h

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const int steps[3] = {1, strides.y, strides.z};
    Real sum = lit<Real>(0.0);
    for (int a = 0; a < 3; ++a) {
      const Real along = at.load(u[a], steps[a]) - at.load(u[a]);
      sum = mulAdd(lit<Real>(2.0) * along, along, sum);
      const int b = a == 2 ? 0 : a + 1;
      const Real shear = across(at, u[a], steps[a], steps[b]) + across(at, u[b], steps[b], steps[a]);
      sum = mulAdd(shear, shear, sum);
    }
    at.store(minimum(Real(share) * squareRoot(sum), lit<Real>(kMostMix)), mix);
  }

 private:
  /// Difference of a component over one cell across its own axis.
  template <class At>
  SPIN_HD_INLINE static typename At::Real across(const At& at, const float* field, int own, int step) {
    return lit<typename At::Real>(0.25) * (at.load(field, step) + at.load(field, step + own) -
                                           at.load(field, -step) - at.load(field, own - step));
  }
};

/// One explicit step of that viscosity; closed faces take no part (the air slides).
template <int axis>
struct EddyMixPass {
  static constexpr AirResult kResult = AirResult::None;
  AirStrides strides;
  const float *area, *open, *mix, *u;
  float* to;

  template <class At>
  SPIN_HD_INLINE void operator()(const At& at) const {
    using Real = typename At::Real;
    const int steps[3] = {1, strides.y, strides.z};
    const int own = steps[axis];
    const Real here = at.load(u);
    Real sum = lit<Real>(0.0);
    for (int a = 0; a < 3; ++a)
      for (const int side : {-1, 1}) {
        const int step = side * steps[a];
        // Along the axis the cell between both faces, across it the four round the edge between them.
        const Real between = a == axis ? at.load(mix, side < 0 ? -own : 0)
                                       : lit<Real>(0.25) * (at.load(mix) + at.load(mix, -own) +
                                                            at.load(mix, step) + at.load(mix, step - own));
        sum = mulAdd(between * positive(at.load(area, step)), at.load(u, step) - here, sum);
      }
    at.store(mulAdd(faceMoves(at, area, open, own), sum, here), to);
  }
};

}  // namespace spin
