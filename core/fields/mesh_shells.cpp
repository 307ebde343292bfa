// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/mesh_shells.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace spin {
namespace {

constexpr const char* kWhat = "The mesh cannot be used as a solid";
constexpr std::uint32_t kNone = UINT32_MAX;

using Corners = std::array<std::uint32_t, 3>;

struct PlaceHash {
  std::size_t operator()(const std::array<std::uint32_t, 3>& bits) const {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (const std::uint32_t b : bits) h = (h ^ b) * 0xBF58476D1CE4E5B9ull, h ^= h >> 29;
    return static_cast<std::size_t>(h);
  }
};

/// Number of the place among those seen, by its bits; -0 counts as 0.
std::vector<std::uint32_t> weld(const std::vector<Vec3f>& from, std::vector<Vec3f>& to) {
  std::unordered_map<std::array<std::uint32_t, 3>, std::uint32_t, PlaceHash> seen;
  std::vector<std::uint32_t> number;
  number.reserve(from.size());
  for (const Vec3f& p : from) {
    const float exact[3] = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
    std::array<std::uint32_t, 3> bits{};
    std::memcpy(bits.data(), exact, sizeof exact);
    const auto [place, fresh] = seen.try_emplace(bits, static_cast<std::uint32_t>(to.size()));
    if (fresh) to.push_back(p);
    number.push_back(place->second);
  }
  return number;
}

std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

/// The triangles of an edge: two, or more than that.
struct EdgeTriangles {
  std::uint32_t first = kNone, second = kNone;
  bool crowded = false;
};
using Edges = std::unordered_map<std::uint64_t, EdgeTriangles>;

Edges edgesOf(const std::vector<Corners>& triangles) {
  Edges edges;
  edges.reserve(triangles.size() * 2);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      EdgeTriangles& e = edges[edgeKey(triangles[t][k], triangles[t][(k + 1) % 3])];
      if (e.first == kNone)
        e.first = t;
      else if (e.second == kNone)
        e.second = t;
      else
        e.crowded = true;
    }
  return edges;
}

/// Whether the triangle runs along the edge from a to b.
bool runs(const Corners& t, std::uint32_t a, std::uint32_t b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (t[k] == a && t[(k + 1) % 3] == b) return true;
  return false;
}

double signedVolume(const std::vector<Vec3f>& positions, const std::vector<Corners>& triangles) {
  double sum = 0.0;
  for (const Corners& t : triangles) {
    const Vec3d a = positions[t[0]].to<double>(), b = positions[t[1]].to<double>(),
                c = positions[t[2]].to<double>();
    sum += dot(a, cross(b, c)) / 6.0;
  }
  return sum;
}

/// Collects what hangs together with triangle `seed`, giving all one winding.
MeshShell collect(std::vector<Corners>& triangles, const Edges& edges, std::uint32_t seed,
                  std::vector<bool>& taken) {
  MeshShell shell{{}, true};
  std::vector<std::uint32_t> queue{seed};
  taken[seed] = true;
  for (std::size_t at = 0; at < queue.size(); ++at) {
    const Corners own = triangles[queue[at]];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = own[k], b = own[(k + 1) % 3];
      const EdgeTriangles& e = edges.at(edgeKey(a, b));
      if (e.crowded || e.second == kNone) {
        shell.closed = false;
        continue;
      }
      const std::uint32_t other = e.first == queue[at] ? e.second : e.first;
      if (taken[other]) {
        // A surface with one side cannot be wound.
        if (runs(triangles[other], a, b)) shell.closed = false;
        continue;
      }
      if (runs(triangles[other], a, b)) std::swap(triangles[other][1], triangles[other][2]);
      taken[other] = true;
      queue.push_back(other);
    }
  }
  std::sort(queue.begin(), queue.end());
  for (const std::uint32_t t : queue) shell.triangles.push_back(triangles[t]);
  return shell;
}

bool hasArea(const std::vector<Vec3f>& p, const Corners& t) {
  const Vec3d a = p[t[0]].to<double>(), b = p[t[1]].to<double>(), c = p[t[2]].to<double>();
  return length(cross(b - a, c - a)) > 0.0;
}

Status checkMesh(const TriangleMesh& mesh, Box3d& box) {
  if (mesh.indices.empty() || mesh.indices.size() % 3 != 0) return badInput(kWhat, {}, "it has no triangles");
  if (mesh.positions.size() > UINT32_MAX / 2 || mesh.triangles() > UINT32_MAX / 2)
    return badInput(kWhat, {}, "it has more than 2^31 corners or triangles");
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (mesh.indices[i] >= mesh.positions.size())
      return badInput(kWhat, "triangle " + std::to_string(i / 3), "it names a corner that is not there");
    const Vec3d p = mesh.positions[mesh.indices[i]];
    if (!isFinite(p)) return badInput(kWhat, "triangle " + std::to_string(i / 3), "a corner is not finite");
    box.extend(p);
  }
  return {};
}

}  // namespace

bool MeshShells::closed() const {
  return std::all_of(shells.begin(), shells.end(), [](const MeshShell& s) { return s.closed; });
}

Result<MeshShells> makeMeshShells(const TriangleMesh& mesh) {
  Box3d box;
  if (Status ok = checkMesh(mesh, box); !ok) return ok.error();
  MeshShells result;
  result.origin = box.centre();
  std::vector<Vec3f> local;
  local.reserve(mesh.positions.size());
  for (const Vec3d& p : mesh.positions) local.push_back((p - result.origin).to<float>());
  const std::vector<std::uint32_t> number = weld(local, result.positions);
  std::vector<Corners> triangles;
  for (std::size_t t = 0; t < mesh.triangles(); ++t) {
    const Corners c{number[mesh.indices[3 * t]], number[mesh.indices[3 * t + 1]],
                    number[mesh.indices[3 * t + 2]]};
    if (hasArea(result.positions, c)) triangles.push_back(c);
  }
  if (triangles.empty()) return badInput(kWhat, {}, "no triangle has an area");
  const Edges edges = edgesOf(triangles);
  std::vector<bool> taken(triangles.size(), false);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (taken[t]) continue;
    MeshShell shell = collect(triangles, edges, t, taken);
    if (shell.closed && signedVolume(result.positions, shell.triangles) < 0.0)
      for (Corners& c : shell.triangles) std::swap(c[1], c[2]);
    result.shells.push_back(std::move(shell));
  }
  return result;
}

}  // namespace spin
