// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "core/base/random.h"
#include "core/sph/flow_solver.h"

namespace spin::testing {

/// nx x ny x nz particles on a lattice, the first half a spacing from the corner, moved by up to `jitter`
/// spacings at random along each axis.
inline std::vector<FlowParticle> lattice(const FlowConfig& c, int nx, int ny, int nz, double jitter = 0.0,
                                         Vec3d corner = {}) {
  const CounterRandom random{5, 1};
  std::vector<FlowParticle> particles;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const std::uint64_t id = particles.size();
        const auto shift = [&](std::uint32_t draw) {
          return jitter * (2.0 * random.uniformDouble(id, draw) - 1.0);
        };
        FlowParticle p;
        p.position = corner + Vec3d{(i + 0.5 + shift(0)) * c.spacing, (j + 0.5 + shift(1)) * c.spacing,
                                    (k + 0.5 + shift(2)) * c.spacing};
        particles.push_back(p);
      }
  return particles;
}

/// Random velocities of up to `speed` along each axis.
inline void stir(std::vector<FlowParticle>& particles, double speed) {
  const CounterRandom random{6, 2};
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto draw = [&](std::uint32_t d) { return speed * (2.0 * random.uniformDouble(i, d) - 1.0); };
    particles[i].velocity = {draw(0), draw(1), draw(2)};
  }
}

/// Brings particles into the box along its periodic axes.
inline void wrap(const FlowConfig& c, std::vector<FlowParticle>& particles) {
  const auto inside = [&](int axis, double v) {
    if (!c.periodic[axis]) return v;
    const double low = c.domainMin[axis], length = c.domainMax[axis] - low;
    return v - length * std::floor((v - low) / length);
  };
  for (FlowParticle& p : particles)
    p.position = {inside(0, p.position.x), inside(1, p.position.y), inside(2, p.position.z)};
}

/// Particles that are not periodic neighbours of themselves: moved by whole supports.
inline void move(std::vector<FlowParticle>& particles, Vec3d by) {
  for (FlowParticle& p : particles) p.position += by;
}

/// Water in a box of n spacings along each axis, periodic across, on a floor at z = 0; the box goes on below
/// it.
inline FlowConfig boxConfig(int nx, int ny, int nz) {
  FlowConfig c;
  c.spacing = 0.05;
  c.materials[0].soundSpeed = 20.0;
  c.materials[0].rheology.viscosity = 0.0f;
  c.periodic[0] = c.periodic[1] = true;
  c.domainMin = {0, 0, -4 * c.spacing};
  c.domainMax = {nx * c.spacing, ny * c.spacing, nz * c.spacing};
  c.walls.planes = {{}};
  return c;
}

/// The same without gravity and floor.
inline FlowConfig freeConfig(int nx, int ny, int nz) {
  FlowConfig c = boxConfig(nx, ny, nz);
  c.gravity = {};
  c.walls.planes.clear();
  return c;
}

/// Ground z = slope x over the box, rastered with the given cell.
inline Raster<float> rampGround(double length, double width, double cell, double slope) {
  Raster<float> ground(static_cast<int>(length / cell) + 3, static_cast<int>(width / cell) + 3, -cell, -cell,
                       cell);
  for (int j = 0; j < ground.height; ++j)
    for (int i = 0; i < ground.width; ++i) ground.at(i, j) = static_cast<float>(slope * ground.x(i));
  return ground;
}

}  // namespace spin::testing
