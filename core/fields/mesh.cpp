// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/mesh.h"

namespace spin {

Box3d ModelData::bounds() const {
  Box3d box;
  for (const MeshInstance& instance : instances)
    for (const Vec3f& p : meshes[static_cast<std::size_t>(instance.mesh)].positions)
      box.extend(instance.transform.point(p.to<double>()));
  return box;
}

std::size_t ModelData::triangleCount() const {
  std::size_t count = 0;
  for (const MeshInstance& instance : instances)
    count += meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
  return count;
}

}  // namespace spin
