// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/math/vec.h"

namespace spin {

/// One named array of a particle set; `components` floats per particle, particle-major.
struct ParticleAttribute {
  std::string name;    ///< snake_case: "velocity"
  std::string unit;    ///< "m/s"; "" = dimensionless
  int components = 1;  ///< 1 or 3
  std::vector<float> values;
};

/// Particles as a structure of arrays for drawing and export (solvers keep their own layouts). Positions are
/// local metres. If wrapBox > 0, positions lie in [0, wrapBox)^3 and stand for the whole periodic lattice:
/// whoever draws or exports shows the copy nearest to the camera, see wrapAround().
struct ParticleSet {
  std::string name;                ///< "flakes"
  double wrapBox = 0.0;            ///< period in m, 0 = none
  double weight = 1.0;             ///< real particles that each one stands for
  std::vector<std::uint64_t> ids;  ///< stable over frames
  std::vector<Vec3f> positions;
  std::vector<ParticleAttribute> attributes;

  std::size_t size() const { return positions.size(); }
  const ParticleAttribute* find(const std::string& attribute) const {
    for (const ParticleAttribute& a : attributes)
      if (a.name == attribute) return &a;
    return nullptr;
  }
};

/// The copy of a periodic position that lies within half a period of the centre.
inline Vec3d wrapAround(Vec3d position, Vec3d centre, double period) {
  const auto wrap = [period](double p, double c) { return p - period * std::round((p - c) / period); };
  return {wrap(position.x, centre.x), wrap(position.y, centre.y), wrap(position.z, centre.z)};
}

}  // namespace spin
