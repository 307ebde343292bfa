// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "core/base/check.h"

namespace spin {
namespace {

double squaredDistance(const BvhNode& node, Vec3d p) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = static_cast<double>(node.low[axis]) - p[axis],
                 high = p[axis] - static_cast<double>(node.high[axis]);
    const double out = std::max({low, high, 0.0});
    sum += out * out;
  }
  return sum;
}

double angleAt(Vec3d corner, Vec3d a, Vec3d b) {
  const Vec3d u = normalized(a - corner), v = normalized(b - corner);
  return std::acos(std::clamp(dot(u, v), -1.0, 1.0));
}

}  // namespace

TrianglePoint closestOnTriangle(Vec3d p, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, 4};
  const Vec3d bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, 5};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + ab * (d1 / (d1 - d3)), 1};
  const Vec3d cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, 6};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + ac * (d2 / (d2 - d6)), 3};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return {b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))), 2};
  const double scale = 1.0 / (va + vb + vc);
  return {a + ab * (vb * scale) + ac * (vc * scale), 0};
}

ShellDistance::ShellDistance(const MeshShells& mesh, std::size_t number)
    : m_closed(mesh.shells[number].closed), m_rays(makeBvhRayScene()) {
  const MeshShell& shell = mesh.shells[number];
  std::vector<BvhTriangle> triangles;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t t = 0; t < shell.triangles.size(); ++t) {
    const auto& c = shell.triangles[t];
    triangles.push_back({{mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]}, 0, t});
    for (const std::uint32_t corner : c) {
      indices.push_back(corner);
      m_box.extend(mesh.positions[corner].to<double>());
    }
  }
  m_bvh.build(std::move(triangles));
  m_rays->addTriangles(mesh.positions, indices);
  m_rays->commit();
  setNormals(mesh, shell);
}

void ShellDistance::setNormals(const MeshShells& mesh, const MeshShell& shell) {
  std::unordered_map<std::uint64_t, Vec3d> edges;
  std::unordered_map<std::uint32_t, Vec3d> corners;
  const auto key = [](std::uint32_t a, std::uint32_t b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
  };
  const auto at = [&](std::uint32_t c) { return mesh.positions[c].to<double>(); };
  std::vector<Vec3d> faces;
  for (const auto& t : shell.triangles) {
    const Vec3d n = normalized(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
    faces.push_back(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      edges[key(a, b)] += n;
      corners[a] += n * angleAt(at(a), at(b), at(c));
    }
  }
  m_normals.reserve(faces.size());
  for (std::size_t t = 0; t < faces.size(); ++t) {
    const auto& c = shell.triangles[t];
    Pseudonormals normals{};
    normals.of[0] = faces[t].to<float>();
    for (std::size_t k = 0; k < 3; ++k) {
      normals.of[1 + k] = normalized(edges[key(c[k], c[(k + 1) % 3])]).to<float>();
      normals.of[4 + k] = normalized(corners[c[k]]).to<float>();
    }
    m_normals.push_back(normals);
  }
}

std::optional<MeshPlace> ShellDistance::nearest(Vec3d p, double reach) const {
  double best = reach * reach;
  TrianglePoint found;
  const BvhTriangle* where = nullptr;
  struct Entry {
    std::uint32_t node;
    double squared;
  };
  Entry stack[512];
  std::size_t height = 0;
  stack[height++] = {0, squaredDistance(m_bvh.nodes()[0], p)};
  while (height > 0) {
    const Entry entry = stack[--height];
    if (entry.squared >= best) continue;
    const BvhNode& node = m_bvh.nodes()[entry.node];
    if (node.count == 0) {
      SPIN_CHECK(height + 2 <= std::size(stack), "the tree is too deep");
      Entry a{node.first, squaredDistance(m_bvh.nodes()[node.first], p)};
      Entry b{node.first + 1, squaredDistance(m_bvh.nodes()[node.first + 1], p)};
      if (a.squared < b.squared) std::swap(a, b);
      stack[height++] = a;
      stack[height++] = b;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const BvhTriangle& t = m_bvh.triangles()[k];
      const TrianglePoint q = closestOnTriangle(p, t.corners[0].to<double>(), t.corners[1].to<double>(),
                                                t.corners[2].to<double>());
      const double squared = dot(p - q.point, p - q.point);
      if (squared < best) best = squared, found = q, where = &t;
    }
  }
  if (where == nullptr) return {};
  const Vec3f normal = m_normals[where->triangle].of[static_cast<std::size_t>(found.feature)];
  return MeshPlace{std::sqrt(best), found.point, normal.to<double>()};
}

std::optional<double> ShellDistance::signedDistance(Vec3d p, double reach) const {
  const std::optional<MeshPlace> s = nearest(p, reach);
  if (!s) return {};
  return m_closed && dot(p - s->point, s->normal) < 0.0 ? -s->distance : s->distance;
}

double ShellDistance::thickness(Vec3d point, Vec3d inward, double most) const {
  if (!m_closed) return 0.0;
  const auto hit = m_rays->closest(
      {point.to<float>(), inward.to<float>(), static_cast<float>(1e-3 * most), static_cast<float>(most)});
  return hit ? static_cast<double>(hit->t) : most;
}

}  // namespace spin
