// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/frame.h"

namespace spin::test {

/// Particles on a lattice that fills a box, at rest, with the attributes that a flow publishes.
inline ParticleSet particleBlock(Vec3d low, Vec3d high, double spacing, double density) {
  ParticleSet set;
  set.name = "flow";
  ParticleAttribute velocity{"velocity", "m/s", 3, {}}, densities{"density", "kg/m3", 1, {}},
      neighbours{"neighbours", "", 1, {}};
  for (double z = low.z + 0.5 * spacing; z < high.z; z += spacing)
    for (double y = low.y + 0.5 * spacing; y < high.y; y += spacing)
      for (double x = low.x + 0.5 * spacing; x < high.x; x += spacing) {
        set.positions.push_back(Vec3d{x, y, z}.to<float>());
        set.ids.push_back(set.ids.size());
        velocity.values.insert(velocity.values.end(), {0.0f, 0.0f, 0.0f});
        densities.values.push_back(static_cast<float>(density));
        neighbours.values.push_back(30.0f);
      }
  set.attributes = {velocity, densities, neighbours};
  return set;
}

inline std::shared_ptr<const Frame> flowFrame(const ParticleSet& set) {
  auto part = std::make_shared<ParticlePart>();
  part->particles = set;
  auto frame = std::make_shared<Frame>();
  frame->parts["flow"] = std::move(part);
  return frame;
}

}  // namespace spin::test
