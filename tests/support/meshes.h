// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <map>
#include <utility>

#include "core/fields/triangle_mesh.h"

namespace spin::testing {

/// Twelve triangles, normals outwards.
inline TriangleMesh boxMesh(Vec3d low, Vec3d high) {
  TriangleMesh m;
  for (int k = 0; k < 8; ++k)
    m.positions.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  m.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
               2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return m;
}

inline TriangleMesh cubeMesh(double edge) {
  const double h = 0.5 * edge;
  return boxMesh({-h, -h, -h}, {h, h, h});
}

/// An octahedron whose faces are cut in four `cuts` times, corners on the sphere.
inline TriangleMesh sphereMesh(double radius, int cuts, Vec3d centre = {}) {
  TriangleMesh m;
  m.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  m.indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  for (int c = 0; c < cuts; ++c) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, fresh] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0u);
      if (fresh) {
        place->second = static_cast<std::uint32_t>(m.positions.size());
        m.positions.push_back(normalized(m.positions[a] + m.positions[b]));
      }
      return place->second;
    };
    std::vector<std::uint32_t> next;
    for (std::size_t t = 0; t < m.triangles(); ++t) {
      const std::uint32_t p = m.indices[3 * t], q = m.indices[3 * t + 1], r = m.indices[3 * t + 2];
      const std::uint32_t pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
      for (const std::uint32_t i : {p, pq, rp, pq, q, qr, rp, qr, r, pq, qr, rp}) next.push_back(i);
    }
    m.indices = std::move(next);
  }
  for (Vec3d& p : m.positions) p = centre + p * radius;
  return m;
}

/// Both in one.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const auto first = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
  return a;
}

}  // namespace spin::testing
