// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/base/random.h"
#include "core/sph/sph_slice.h"

namespace spin::testing {

/// A regular lattice of nx x ny x nz particles, the first half a spacing from the corner, moved by up to
/// `jitter` spacings at random.
inline std::vector<Vec3d> lattice(const SphSliceConfig& c, int nx, int ny, int nz, double jitter = 0.0) {
  const CounterRandom random{5, 1};
  std::vector<Vec3d> points;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::uint64_t id = points.size();
        const auto shift = [&](std::uint32_t draw) {
          return jitter * (2.0 * random.uniformDouble(id, draw) - 1.0);
        };
        points.push_back(c.domainMin + Vec3d{(i + 0.5 + shift(0)) * c.spacing,
                                             (j + 0.5 + shift(1)) * c.spacing,
                                             (k + 0.5 + shift(2)) * c.spacing});
      }
  return points;
}

/// Random velocities of up to `speed` along each axis.
inline std::vector<Vec3d> randomVelocities(std::size_t n, double speed) {
  const CounterRandom random{6, 2};
  std::vector<Vec3d> v(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto draw = [&](std::uint32_t d) { return speed * (2.0 * random.uniformDouble(i, d) - 1.0); };
    v[i] = {draw(0), draw(1), draw(2)};
  }
  return v;
}

/// Water in a box of n spacings along each axis, periodic across, on a floor.
inline SphSliceConfig boxConfig(int nx, int ny, int nz) {
  SphSliceConfig c;
  c.spacing = 0.05;
  c.soundSpeed = 20.0;
  c.periodicX = c.periodicY = true;
  c.domainMax = {nx * c.spacing, ny * c.spacing, nz * c.spacing};
  return c;
}

}  // namespace spin::testing
