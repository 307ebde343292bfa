// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/model_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
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

/// Triangles that stand where another one stands already, wound either way: the second side of two-sided
/// sheets, and doubled faces. Snow lies there once.
std::vector<char> doubles(const std::vector<Corners>& corners) {
  std::set<Corners> known;
  std::vector<char> found(corners.size());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    Corners sorted = corners[t];
    std::sort(sorted.begin(), sorted.end());
    found[t] = known.insert(sorted).second ? 0 : 1;
  }
  return found;
}

/// A triangle at an edge, and whether its winding goes along it from the lower to the higher corner.
struct EdgeUse {
  std::uint32_t triangle;
  bool upward;
};
using EdgeMap = std::unordered_map<std::uint64_t, std::vector<EdgeUse>>;

EdgeMap edgesOf(const std::vector<Corners>& corners, const std::vector<char>& leftOut) {
  EdgeMap edges;
  for (std::size_t t = 0; t < corners.size(); ++t)
    for (std::size_t c = 0; c < 3 && !leftOut[t]; ++c) {
      const std::uint64_t a = corners[t][c], b = corners[t][(c + 1) % 3];
      if (a != b)
        edges[std::min(a, b) << 32 | std::max(a, b)].push_back({static_cast<std::uint32_t>(t), a < b});
    }
  return edges;
}

/// Surfaces whose triangles meet two by two, each made of one winding. Where more than two meet at an edge
/// the surfaces end there for this purpose.
class Shells {
 public:
  Shells(const std::vector<PlacedTriangle>& triangles, const EdgeMap& edges)
      : m_triangles(&triangles),
        m_neighbours(triangles.size()),
        m_shell(triangles.size(), kNone),
        m_turn(triangles.size(), 1) {
    for (const auto& [edge, uses] : edges) {
      if (uses.size() != 2) continue;
      // Two triangles of one winding pass their edge in opposite directions.
      const int same = uses[0].upward != uses[1].upward ? 1 : -1;
      m_neighbours[uses[0].triangle].push_back({uses[1].triangle, same});
      m_neighbours[uses[1].triangle].push_back({uses[0].triangle, same});
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
      if (m_shell[t] == kNone) collect(t);
    for (const auto& [edge, uses] : edges) countEnds(uses);
  }

  /// +1 or -1 where the triangle bounds a closed surface (the winding's side that is outside), 0 where that
  /// is open or has no sides.
  int outwardSide(std::uint32_t triangle) const {
    const Shell& shell = m_shells[m_shell[triangle]];
    // A sheet folded onto itself encloses nothing.
    const bool flat = std::abs(shell.volume) <= 1e-6 * std::pow(shell.area, 1.5);
    if (shell.open || shell.oneSided || flat) return 0;
    return m_turn[triangle] * (shell.volume < 0.0 ? -1 : 1);
  }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  struct Shell {
    double volume = 0.0, area = 0.0;
    bool open = false, oneSided = false;
  };
  struct Neighbour {
    std::uint32_t triangle;
    int same;
  };

  /// All triangles that hang together with the first, turned to its winding.
  void collect(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(m_shells.size());
    Shell shell;
    const Vec3d origin = (*m_triangles)[first].corners[0].to<double>();
    std::vector<std::uint32_t> waiting{first};
    m_shell[first] = number;
    while (!waiting.empty()) {
      const std::uint32_t t = waiting.back();
      waiting.pop_back();
      const PlacedTriangle& triangle = (*m_triangles)[t];
      const Vec3d normal = triangle.normal();
      shell.volume += m_turn[t] * dot(triangle.corners[0].to<double>() - origin, normal) / 6.0;
      shell.area += 0.5 * length(normal);
      for (const Neighbour& next : m_neighbours[t]) {
        const int turn = m_turn[t] * next.same;
        if (m_shell[next.triangle] == number) {
          shell.oneSided = shell.oneSided || m_turn[next.triangle] != turn;
          continue;
        }
        m_shell[next.triangle] = number;
        m_turn[next.triangle] = turn;
        waiting.push_back(next.triangle);
      }
    }
    m_shells.push_back(shell);
  }

  /// A surface is closed where it passes every edge an even number of times.
  void countEnds(const std::vector<EdgeUse>& uses) {
    std::map<std::uint32_t, int> count;
    for (const EdgeUse& use : uses) ++count[m_shell[use.triangle]];
    for (const auto& [shell, times] : count)
      if (times % 2 != 0) m_shells[shell].open = true;
  }

  const std::vector<PlacedTriangle>* m_triangles;
  std::vector<std::vector<Neighbour>> m_neighbours;
  std::vector<std::uint32_t> m_shell;
  std::vector<int> m_turn;  ///< -1 where the winding goes against that of the shell's first triangle
  std::vector<Shell> m_shells;
};

bool facesUp(const PlacedTriangle& triangle, int side, double minUpward) {
  const Vec3d n = triangle.normal();
  const double size = length(n);
  if (!(size > 0.0)) return false;
  const double up = n.z / size;
  return (side == 0 ? std::abs(up) : side * up) > minUpward;
}

}  // namespace

std::vector<ModelPart> upFacingParts(const std::vector<PlacedTriangle>& triangles, double minUpward) {
  return modelSurface(triangles, minUpward).parts;
}

ModelSurface modelSurface(const std::vector<PlacedTriangle>& triangles, double minUpward) {
  const std::vector<Corners> corners = weldedCorners(triangles);
  ModelSurface surface;
  surface.doubled = doubles(corners);
  const EdgeMap edges = edgesOf(corners, surface.doubled);
  const Shells shells(triangles, edges);
  surface.outward.resize(triangles.size());
  std::vector<char> up(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (surface.doubled[t]) continue;
    surface.outward[t] = static_cast<signed char>(shells.outwardSide(t));
    up[t] = facesUp(triangles[t], surface.outward[t], minUpward) ? 1 : 0;
  }
  DisjointSets sets(triangles.size());
  for (const auto& [edge, uses] : edges) {
    const auto first =
        std::find_if(uses.begin(), uses.end(), [&](const EdgeUse& use) { return up[use.triangle] != 0; });
    for (auto it = first; it != uses.end(); ++it)
      if (up[it->triangle]) sets.join(first->triangle, it->triangle);
  }
  std::map<std::uint32_t, ModelPart> bySet;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!up[t]) continue;
    ModelPart& part = bySet[sets.find(t)];
    part.triangles.push_back(t);
    part.planArea += 0.5 * std::abs(triangles[t].normal().z);
  }
  for (auto& [set, part] : bySet) surface.parts.push_back(std::move(part));
  std::stable_sort(surface.parts.begin(), surface.parts.end(),
                   [](const ModelPart& a, const ModelPart& b) { return a.planArea > b.planArea; });
  return surface;
}

}  // namespace spin
