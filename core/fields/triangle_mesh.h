// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/math/vec.h"

namespace spin {

/// Bare triangles for geometry: no material, no texture.
struct TriangleMesh {
  std::vector<Vec3d> positions;        ///< m
  std::vector<std::uint32_t> indices;  ///< 3 per triangle

  std::size_t triangles() const { return indices.size() / 3; }
  Vec3d corner(std::size_t triangle, int k) const {
    return positions[indices[3 * triangle + static_cast<std::size_t>(k)]];
  }
};

}  // namespace spin
