// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/model_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>

namespace spin {
namespace {

/// Union of sets, each named by its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), 0u); }
  std::uint32_t find(std::uint32_t a) {
    while (m_parent[a] != a) a = m_parent[a] = m_parent[m_parent[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    m_parent[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> m_parent;
};

using Corners = std::array<std::uint32_t, 3>;

/// Numbers of the corners, the same for corners that coincide.
std::vector<Corners> weldedCorners(const std::vector<PlacedTriangle>& triangles) {
  Box3d box;
  for (const PlacedTriangle& t : triangles)
    for (const Vec3f& p : t.corners) box.extend(p.to<double>());
  const double step = std::max(length(box.size()) * 1e-6, 1e-9);
  using Key = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::map<Key, std::uint32_t> known;
  std::vector<Corners> corners(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3d p = (triangles[t].corners[c].to<double>() - box.min) / step;
      const Key key{std::llround(p.x), std::llround(p.y), std::llround(p.z)};
      corners[t][c] = known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second;
    }
  return corners;
}

using EdgeMap = std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>;

EdgeMap edgesOf(const std::vector<Corners>& corners) {
  EdgeMap edges;
  for (std::size_t t = 0; t < corners.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint64_t a = corners[t][c], b = corners[t][(c + 1) % 3];
      if (a != b) edges[std::min(a, b) << 32 | std::max(a, b)].push_back(static_cast<std::uint32_t>(t));
    }
  return edges;
}

/// Per triangle: +1 or -1 where it bounds a closed surface (the winding's side that is outside), 0 where
/// open.
std::vector<int> outwardSides(const std::vector<PlacedTriangle>& triangles, const EdgeMap& edges) {
  DisjointSets sets(triangles.size());
  for (const auto& [edge, around] : edges)
    for (const std::uint32_t t : around) sets.join(around.front(), t);
  std::vector<double> volume(triangles.size(), 0.0);
  std::vector<char> open(triangles.size(), 0);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const PlacedTriangle& triangle = triangles[t];
    volume[sets.find(t)] += dot(triangle.corners[0].to<double>(), triangle.normal());
  }
  for (const auto& [edge, around] : edges)
    if (around.size() % 2 != 0) open[sets.find(around.front())] = 1;
  std::vector<int> side(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t set = sets.find(t);
    side[t] = open[set] ? 0 : (volume[set] < 0.0 ? -1 : 1);
  }
  return side;
}

bool facesUp(const PlacedTriangle& triangle, int side, double minUpward) {
  const Vec3d n = triangle.normal();
  const double size = length(n);
  if (!(size > 0.0)) return false;
  const double up = n.z / size;
  return (side == 0 ? std::abs(up) : side * up) > minUpward;
}

}  // namespace

std::vector<ModelPart> upFacingParts(const std::vector<PlacedTriangle>& triangles, double minUpward) {
  const EdgeMap edges = edgesOf(weldedCorners(triangles));
  const std::vector<int> side = outwardSides(triangles, edges);
  std::vector<char> up(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    up[t] = facesUp(triangles[t], side[t], minUpward) ? 1 : 0;

  DisjointSets sets(triangles.size());
  for (const auto& [edge, around] : edges) {
    const auto first =
        std::find_if(around.begin(), around.end(), [&](std::uint32_t t) { return up[t] != 0; });
    for (auto it = first; it != around.end(); ++it)
      if (up[*it]) sets.join(*first, *it);
  }
  std::map<std::uint32_t, ModelPart> bySet;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!up[t]) continue;
    ModelPart& part = bySet[sets.find(t)];
    part.triangles.push_back(t);
    part.planArea += 0.5 * std::abs(triangles[t].normal().z);
  }
  std::vector<ModelPart> parts;
  for (auto& [set, part] : bySet) parts.push_back(std::move(part));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const ModelPart& a, const ModelPart& b) { return a.planArea > b.planArea; });
  return parts;
}

}  // namespace spin
