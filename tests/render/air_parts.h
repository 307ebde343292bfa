// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "core/sim/air_part.h"

namespace spin::test {

/// A field of the bricks that are there, of the values at cell centres.
inline void addField(AirPart& part, const std::string& name, const std::string& unit, float scale,
                     const std::function<double(Vec3d)>& valueAt) {
  AirField field{name, unit, 1, scale, {}};
  field.halves.reserve(part.cells());
  for (const auto& brick : part.bricks)
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      const Vec3d at{kBrickX * brick[0] + static_cast<double>(cell % kBrickX) + 0.5,
                     kBrickY * brick[1] + static_cast<double>(cell / kBrickX % kBrickY) + 0.5,
                     kBrickZ * brick[2] + static_cast<double>(cell / kBrickX / kBrickY) + 0.5};
      const double value = valueAt(part.origin + at * part.cell);
      field.halves.push_back(halfFromFloat(static_cast<float>(value / static_cast<double>(scale))));
    }
  part.fields.push_back(std::move(field));
}

/// Bricks of a lattice with its origin in `low` that cover a box; those in which `there` is false at the
/// centre are left out.
inline std::shared_ptr<AirPart> airBricks(
    Vec3d low, Vec3d high, double cell,
    const std::function<bool(Vec3d)>& there = [](Vec3d) { return true; }) {
  auto part = std::make_shared<AirPart>();
  part->origin = low;
  part->cell = cell;
  const auto count = [&](double length, int side) {
    return static_cast<int>(std::ceil(length / (side * cell) - 1e-9));
  };
  for (int z = 0; z < count(high.z - low.z, kBrickZ); ++z)
    for (int y = 0; y < count(high.y - low.y, kBrickY); ++y)
      for (int x = 0; x < count(high.x - low.x, kBrickX); ++x) {
        const Vec3d centre{kBrickX * (x + 0.5), kBrickY * (y + 0.5), kBrickZ * (z + 0.5)};
        if (there(low + centre * cell)) part->bricks.push_back({x, y, z});
      }
  return part;
}

inline std::shared_ptr<Frame> airFrame(std::shared_ptr<const AirPart> part) {
  auto frame = std::make_shared<Frame>();
  frame->parts["air"] = std::move(part);
  return frame;
}

}  // namespace spin::test
