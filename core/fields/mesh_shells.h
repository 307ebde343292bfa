// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/fields/triangle_mesh.h"

namespace spin {

/// A connected piece of a mesh. Closed: every edge has two triangles; it is then wound so that its normals
/// point out of it, whatever winding it came with.
struct MeshShell {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< corners, indices into MeshShells::positions
  bool closed = false;
};

/// A mesh with equal corners joined and triangles without area left out, cut into its shells in the order of
/// their first triangles.
struct MeshShells {
  Vec3d origin{};                 ///< of positions; the middle of the mesh's box
  std::vector<Vec3f> positions;   ///< m from the origin
  std::vector<MeshShell> shells;  ///< at least one

  bool closed() const;
};

/// Fails where the mesh has no triangle with an area, an index beyond its corners or a corner that is not
/// finite.
Result<MeshShells> makeMeshShells(const TriangleMesh& mesh);

}  // namespace spin
