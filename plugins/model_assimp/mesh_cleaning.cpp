// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/model_assimp/mesh_cleaning.h"

#include <algorithm>
#include <cmath>

namespace spin {
namespace {

Vec3d position(const Mesh& mesh, std::uint32_t index) {
  return mesh.positions[index].to<double>();
}

/// Twice the area times the normal; zero for a triangle without area (thinner than 1e-10 of its longest
/// edge).
Vec3d doubleArea(const Mesh& mesh, const std::uint32_t* corner) {
  const Vec3d a = position(mesh, corner[0]);
  const Vec3d ab = position(mesh, corner[1]) - a, ac = position(mesh, corner[2]) - a;
  const Vec3d n = cross(ab, ac);
  const double longest = std::max({dot(ab, ab), dot(ac, ac), dot(ac - ab, ac - ab)});
  return length(n) > 1e-10 * longest ? n : Vec3d{};
}

void dropDegenerate(Mesh& mesh, MeshRepairs& repairs) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    if (doubleArea(mesh, &mesh.indices[t]) == Vec3d{}) {
      ++repairs.degenerate;
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) mesh.indices[kept + k] = mesh.indices[t + k];
    kept += 3;
  }
  mesh.indices.resize(kept);
}

void turnAgainstNormals(Mesh& mesh, MeshRepairs& repairs) {
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    std::uint32_t* corner = &mesh.indices[t];
    const Vec3f sum = mesh.normals[corner[0]] + mesh.normals[corner[1]] + mesh.normals[corner[2]];
    const Vec3d face = normalized(doubleArea(mesh, corner));
    // Clearly against, not merely across as smooth normals at a sharp edge are.
    if (dot(face, sum.to<double>()) < -0.3) {
      std::swap(corner[1], corner[2]);
      ++repairs.turned;
    }
  }
}

std::vector<Vec3f> areaWeightedNormals(const Mesh& mesh) {
  std::vector<Vec3d> sums(mesh.positions.size());
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Vec3d n = doubleArea(mesh, &mesh.indices[t]);
    for (std::size_t k = 0; k < 3; ++k) sums[mesh.indices[t + k]] += n;
  }
  std::vector<Vec3f> normals(sums.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Vec3d n = normalized(sums[i]);
    normals[i] = n == Vec3d{} ? Vec3f{0, 0, 1} : n.to<float>();
  }
  return normals;
}

bool isDirection(Vec3f n) {
  return isFinite(n) && dot(n, n) > 1e-12f && dot(n, n) < 1e12f;
}

}  // namespace

void cleanMesh(Mesh& mesh, MeshRepairs& repairs) {
  dropDegenerate(mesh, repairs);
  if (mesh.normals.empty()) {
    mesh.normals = areaWeightedNormals(mesh);
    ++repairs.normalsMade;
    return;
  }
  const auto unusable = static_cast<std::size_t>(
      std::count_if(mesh.normals.begin(), mesh.normals.end(), [](Vec3f n) { return !isDirection(n); }));
  if (unusable > 0) {
    const std::vector<Vec3f> made = areaWeightedNormals(mesh);
    for (std::size_t i = 0; i < made.size(); ++i)
      if (!isDirection(mesh.normals[i])) mesh.normals[i] = made[i];
    repairs.normalsMended += unusable;
  }
  for (Vec3f& n : mesh.normals) n = normalized(n);
  turnAgainstNormals(mesh, repairs);
}

}  // namespace spin
