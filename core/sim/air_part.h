// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/math/half.h"
#include "core/sim/frame.h"

namespace spin {

/// Cells of a brick along x, y and z: the air is computed and kept in such blocks, only where something hangs
/// in it.
inline constexpr int kBrickX = 16, kBrickY = 4, kBrickZ = 4;
inline constexpr std::size_t kBrickCells = std::size_t{kBrickX} * kBrickY * kBrickZ;

/// One field of the air over the bricks of a frame: per brick and component kBrickCells numbers, x fastest,
/// then y, then z; the components of a brick follow each other.
struct AirField {
  std::string name;                   ///< "mist"
  std::string unit;                   ///< "kg/m3"
  int components = 1;                 ///< 1 or 3
  float scale = 1.0f;                 ///< what one of the stored numbers is worth, in the unit
  std::vector<std::uint16_t> halves;  ///< binary16, see core/math/half.h

  float at(std::size_t brick, int component, std::size_t cell) const {
    const auto block = brick * static_cast<std::size_t>(components) + static_cast<std::size_t>(component);
    return scale * floatFromHalf(halves[block * kBrickCells + cell]);
  }
};

/// What hangs in the air of a frame, at cell centres. Fields, where they are there:
///   mist         kg/m3, liquid droplets      snow        kg/m3, suspended snow
///   temperature  K over that of the air round it         vapour      kg/m3 over that of the air round it
///   velocity     m/s (3)                                 divergence  1/s, what the projection left
/// A lattice of cells fixed in the scene; cell (i, j, k) of brick (a, b, c) has its lower corner at
/// origin + cell (kBrickX a + i, kBrickY b + j, kBrickZ c + k).
struct AirPart final : FramePart {
  static constexpr const char* kKind = "air";
  Vec3d origin{};                                      ///< local m
  double cell = 1.0;                                   ///< m; > 0
  double dropDiameter = 30e-6, snowDiameter = 200e-6;  ///< m, of what scatters light
  double temperature = 273.15;                         ///< K of the air round it
  std::vector<std::array<std::int32_t, 3>> bricks;     ///< ascending by z, then y, then x; no two alike
  std::vector<AirField> fields;

  const AirField* find(const std::string& name) const {
    for (const AirField& field : fields)
      if (field.name == name) return &field;
    return nullptr;
  }
  std::size_t cells() const { return bricks.size() * kBrickCells; }

  const char* kind() const override { return kKind; }
  std::size_t memoryBytes() const override;
  void save(ByteWriter& out) const override;
  std::string firstNonFinite() const override;
  /// Null where arrays do not fit the bricks, bricks are not in order or a number cannot be.
  static std::shared_ptr<FramePart> load(ByteReader& in);
};

}  // namespace spin
