// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/fields/mesh_shells.h"
#include "core/fields/ray_scene.h"
#include "core/fields/triangle_bvh.h"

namespace spin {

/// Point of a triangle that is nearest to another point (Ericson 2005, 5.1.5) and the feature it lies on.
struct TrianglePoint {
  Vec3d point{};
  int feature = 0;  ///< 0 face; 1..3 edge k-1 from corner k-1 on; 4..6 corner k-4
};
TrianglePoint closestOnTriangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c);

/// Nearest place of a surface. `normal` is the angle-weighted pseudo-normal of the feature there (Baerentzen
/// and Aanaes 2005): p is outside a closed shell exactly where (p - point) . normal >= 0.
struct MeshPlace {
  double distance = 0.0;  ///< m, >= 0
  Vec3d point{};          ///< from the mesh's origin
  Vec3d normal{};         ///< not normalised
};

/// Exact distances from one shell of a mesh. Asking is thread-safe.
class ShellDistance {
 public:
  ShellDistance(const MeshShells& mesh, std::size_t shell);
  bool closed() const { return m_closed; }
  const Box3d& box() const { return m_box; }
  /// The nearest place, if it is nearer than `reach`.
  std::optional<MeshPlace> nearest(Vec3d p, double reach) const;
  /// Distance, below 0 inside a closed shell; an open one has none. Nothing beyond `reach`.
  std::optional<double> signedDistance(Vec3d p, double reach) const;
  /// How far it is from a place of the surface, along `inward` (unit), to the surface again: the thickness
  /// of the solid there; `most` where it is thicker.
  double thickness(Vec3d point, Vec3d inward, double most) const;

 private:
  struct Pseudonormals {
    std::array<Vec3f, 7> of;  ///< by TrianglePoint::feature
  };
  void setNormals(const MeshShells& mesh, const MeshShell& shell);

  bool m_closed = false;
  Box3d m_box;
  TriangleBvh m_bvh;
  std::unique_ptr<RayScene> m_rays;
  std::vector<Pseudonormals> m_normals;  ///< by the shell's triangle
};

}  // namespace spin
