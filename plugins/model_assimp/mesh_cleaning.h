// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "core/fields/mesh.h"

namespace spin {

/// What was mended in the meshes of a model.
struct MeshRepairs {
  std::size_t degenerate = 0;     ///< triangles without area, left out
  std::size_t turned = 0;         ///< triangles wound against their normals, turned round
  std::size_t normalsMade = 0;    ///< meshes that came without normals
  std::size_t normalsMended = 0;  ///< vertices whose normal was no direction
};

/// Drops triangles without area, turns those wound against their vertex normals, makes missing normals
/// (area-weighted) and normalises the given ones. Positions must be finite and indices in range.
void cleanMesh(Mesh& mesh, MeshRepairs& repairs);

}  // namespace spin
