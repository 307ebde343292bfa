// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/air_part.h"

namespace spin::test {

/// Values that 16 bits hold exactly, different in every cell of the two bricks that hold something.
inline float mistAt(std::size_t brick, std::size_t cell) {
  return brick == 1 ? 0.0f : 0.25f * static_cast<float>(cell + 1 + 128 * brick) / 256.0f;
}
inline float velocityAt(std::size_t brick, int component, std::size_t cell) {
  return brick == 1 ? 0.0f : static_cast<float>(cell % 16) - 4.0f * static_cast<float>(component);
}

/// Three bricks of cells of 0.5 m, the middle one empty; mist, snow (in one cell), temperature, velocity.
inline std::shared_ptr<AirPart> airPart() {
  auto part = std::make_shared<AirPart>();
  part->origin = {10, -20, 30};
  part->cell = 0.5;
  part->temperature = 268.15;
  part->bricks = {{-2, 1, 0}, {0, 0, 1}, {3, -5, 2}};
  AirField mist{"mist", "kg/m3", 1, 0.25f, {}}, snow{"snow", "kg/m3", 1, 1.0f, {}},
      temperature{"temperature", "K", 1, 1.0f, {}}, velocity{"velocity", "m/s", 3, 1.0f, {}};
  for (std::size_t brick = 0; brick < 3; ++brick) {
    for (std::size_t cell = 0; cell < kBrickCells; ++cell) {
      mist.halves.push_back(halfFromFloat(mistAt(brick, cell) / 0.25f));
      snow.halves.push_back(halfFromFloat(brick == 2 && cell == 7 ? 2.0f : 0.0f));
      temperature.halves.push_back(halfFromFloat(brick == 0 ? -3.5f : 0.0f));
    }
    for (int d = 0; d < 3; ++d)
      for (std::size_t cell = 0; cell < kBrickCells; ++cell)
        velocity.halves.push_back(halfFromFloat(velocityAt(brick, d, cell)));
  }
  part->fields = {mist, snow, temperature, velocity};
  return part;
}

inline Frame airFrame(int number, std::shared_ptr<AirPart> part = airPart()) {
  Frame frame;
  frame.info.time = {number, number / 24.0, number * 120.0};
  frame.parts["air"] = std::move(part);
  return frame;
}

}  // namespace spin::test
