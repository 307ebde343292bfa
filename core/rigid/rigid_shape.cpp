// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/rigid/rigid_shape.h"

#include <algorithm>

#include "core/fields/surface_samples.h"

namespace spin {
namespace {

/// Cells of the field along the longest edge of the mesh's box.
constexpr double kCellsAlong = 32.0;
/// Contact points along it.
constexpr double kPointsAlong = 20.0;

}  // namespace

Result<std::shared_ptr<const RigidShape>> makeRigidShape(const TriangleMesh& mesh,
                                                         const CancelToken& cancel) {
  Result<MeshShells> shells = makeMeshShells(mesh);
  if (!shells) return shells.error();
  auto shape = std::make_shared<RigidShape>();
  shape->mass = massProperties(*shells);
  shape->inverseInertia = shape->mass.inertia.inverse();
  Box3d box;
  for (const MeshShell& shell : shells->shells)
    for (const auto& t : shell.triangles)
      for (const std::uint32_t k : t) {
        const Vec3d p = shells->positions[k].to<double>() + shells->origin - shape->mass.centre;
        shape->mesh.indices.push_back(static_cast<std::uint32_t>(shape->mesh.positions.size()));
        shape->mesh.positions.push_back(p);
        shape->radius = std::max(shape->radius, length(p));
        box.extend(p);
      }
  const Vec3d size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  SignedDistanceOptions options;
  options.cell = longest / kCellsAlong;
  options.reach = longest / 4.0;
  options.leastThickness = 2.0 * options.cell;
  options.cancel = cancel;
  auto field = SignedDistance::make(shape->mesh, options);
  if (!field) return field.error();
  shape->field = std::move(*field);
  shape->points = surfaceSamples(shape->mesh, longest / kPointsAlong, [](Vec3d p, Vec3d) { return p; });
  return std::shared_ptr<const RigidShape>(shape);
}

}  // namespace spin
