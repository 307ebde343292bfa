// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "editor/render/cover_geometry.h"

namespace spin {
namespace {

/// Neighbouring cells further apart in height than this many cell sizes belong to different surfaces.
constexpr float kLargestStep = 2.5f;

/// Builds the mesh on the grid enlarged by one cell on each side, where the rim lies.
class PatchBuilder {
 public:
  explicit PatchBuilder(const CoverGrid& grid)
      : m_base(grid.base), m_area(grid.area), m_width(grid.base.width + 2), m_height(grid.base.height + 2) {
    // Cells that the surface hardly enters belong to the rim; a part narrower than its cells keeps its
    // fullest.
    double fullest = 0.0;
    for (int j = 0; j < m_base.height; ++j)
      for (int i = 0; i < m_base.width; ++i) fullest = std::max(fullest, share(i, j));
    m_leastShare = std::max(0.5 * fullest, 1e-3);
  }

  PatchCover build() {
    m_patch.cellSize = static_cast<float>(m_base.cellSize);
    m_patch.vertexOfCell.assign(m_base.size(), -1);
    m_vertex.assign(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height), -1);
    for (int j = -1; j <= m_base.height; ++j)
      for (int i = -1; i <= m_base.width; ++i) addVertex(i, j);
    for (int j = -1; j < m_base.height; ++j)
      for (int i = -1; i < m_base.width; ++i) addQuad(i, j);
    findRims();
    return std::move(m_patch);
  }

 private:
  static constexpr std::array<std::array<int, 2>, 8> kAround{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

  /// Share of a cell that the surface covers in plan, 0..1.
  double share(int i, int j) const {
    if (!m_area.contains(i, j) || !m_base.contains(i, j) || std::isnan(m_base.at(i, j))) return 0.0;
    return std::min(1.0, static_cast<double>(m_area.at(i, j)) / (m_base.cellSize * m_base.cellSize));
  }
  bool valid(int i, int j) const { return share(i, j) >= m_leastShare; }
  int& vertexAt(int i, int j) { return m_vertex[static_cast<std::size_t>((j + 1) * m_width + i + 1)]; }
  bool connected(int i, int j, int a, int b) const {
    return valid(i, j) && valid(a, b) &&
           std::abs(m_base.at(i, j) - m_base.at(a, b)) <= kLargestStep * static_cast<float>(m_base.cellSize);
  }

  void addVertex(int i, int j) {
    if (valid(i, j)) {
      const Vec3d p{m_base.x(i), m_base.y(j), static_cast<double>(m_base.at(i, j))};
      m_patch.vertexOfCell[m_base.index(i, j)] =
          push(i, j, p, static_cast<int>(m_base.index(i, j)), insetOf(i, j));
      return;
    }
    Vec3d sum{};
    int count = 0, beside = -1;
    bool corner = true;
    for (const auto& d : kAround) {
      const int a = i + d[0], b = j + d[1];
      if (!valid(a, b)) continue;
      const double z = m_base.at(a, b);
      const bool further = connected(a, b, a + d[0], b + d[1]);
      const double rise = further ? z - static_cast<double>(m_base.at(a + d[0], b + d[1])) : 0.0;
      // The edge lies as many cells beyond the last centre as the two cells are covered, less the half cell.
      const double out = std::clamp(share(a, b) + share(i, j) - 0.5, 0.05, 0.95);
      sum += Vec3d{m_base.x(a) + out * (m_base.x(i) - m_base.x(a)),
                   m_base.y(b) + out * (m_base.y(j) - m_base.y(b)), z + out * rise};
      corner = corner && d[0] != 0 && d[1] != 0;
      if (++count == 1) beside = static_cast<int>(m_base.index(a, b));
    }
    if (count == 0) return;
    push(i, j, sum / static_cast<double>(count), corner ? -2 : -1, 0.0f);
    m_patch.shownCell.back() = beside;
  }

  int push(int i, int j, Vec3d p, int cell, float inset) {
    const int index = static_cast<int>(m_patch.positions.size());
    vertexAt(i, j) = index;
    m_patch.positions.push_back(p.to<float>());
    m_patch.cell.push_back(cell);
    m_patch.shownCell.push_back(cell);
    m_patch.inset.push_back(inset);
    return index;
  }

  /// Distance to the nearest cell that is missing or lies much higher or lower, less half a cell.
  float insetOf(int i, int j) const {
    const float cell = static_cast<float>(m_base.cellSize);
    float nearest = std::numeric_limits<float>::max();
    constexpr int kReach = PatchCover::kBorderCells;
    for (int b = -kReach; b <= kReach; ++b)
      for (int a = -kReach; a <= kReach; ++a) {
        const int reach = std::max({std::abs(a), std::abs(b), 1});
        const bool same = valid(i + a, j + b) && std::abs(m_base.at(i, j) - m_base.at(i + a, j + b)) <=
                                                     kLargestStep * cell * static_cast<float>(reach);
        if (!same)
          nearest =
              std::min(nearest, (std::hypot(static_cast<float>(a), static_cast<float>(b)) - 0.5f) * cell);
      }
    return nearest;
  }

  /// The nearest rim vertex of each cell in the border.
  void findRims() {
    m_patch.rim.assign(m_patch.positions.size(), -1);
    for (int j = 0; j < m_base.height; ++j)
      for (int i = 0; i < m_base.width; ++i) {
        const int cell = m_patch.vertexOfCell[m_base.index(i, j)];
        if (cell >= 0) m_patch.rim[static_cast<std::size_t>(cell)] = nearestRim(i, j);
      }
  }

  int nearestRim(int i, int j) {
    constexpr int kReach = PatchCover::kBorderCells;
    int found = -1, nearest = kReach * kReach + 1;
    for (int b = std::max(j - kReach, -1); b <= std::min(j + kReach, m_base.height); ++b)
      for (int a = std::max(i - kReach, -1); a <= std::min(i + kReach, m_base.width); ++a) {
        const int vertex = vertexAt(a, b), square = (a - i) * (a - i) + (b - j) * (b - j);
        if (vertex < 0 || square >= nearest || m_patch.cell[static_cast<std::size_t>(vertex)] >= 0) continue;
        found = vertex;
        nearest = square;
      }
    return found;
  }

  void addQuad(int i, int j) {
    const int v[4] = {vertexAt(i, j), vertexAt(i + 1, j), vertexAt(i, j + 1), vertexAt(i + 1, j + 1)};
    if (std::any_of(std::begin(v), std::end(v), [](int k) { return k < 0; })) return;
    float low = std::numeric_limits<float>::max(), high = -low;
    bool anyCell = false;
    for (const int k : v) {
      const auto at = static_cast<std::size_t>(k);
      anyCell = anyCell || m_patch.cell[at] >= 0;
      low = std::min(low, m_patch.positions[at].z);
      high = std::max(high, m_patch.positions[at].z);
    }
    if (!anyCell || high - low > 2.0f * kLargestStep * static_cast<float>(m_base.cellSize)) return;
    for (const int k : {0, 1, 3, 0, 3, 2}) m_patch.indices.push_back(static_cast<std::uint32_t>(v[k]));
  }

  const Raster<float>& m_base;
  const Raster<float>& m_area;
  int m_width, m_height;
  double m_leastShare = 0.0;
  std::vector<int> m_vertex;
  PatchCover m_patch;
};

/// Quarter circle: 0 at the rim, full `depth` from `radius` inwards.
float rounded(float depth, float inset, float radius) {
  const float x = std::clamp(inset / radius, 0.0f, 1.0f);
  return depth * std::sqrt(1.0f - (1.0f - x) * (1.0f - x));
}

/// Takes the cell of `grid` nearest to a point if it lies within a cell of it, along all axes, and nearer
/// than what was found so far.
void findContact(const CoverGrid& grid, std::size_t index, Vec3d p, RimContact& found, double& nearest) {
  const Raster<float>& base = grid.base;
  const int i0 = base.column(p.x), j0 = base.row(p.y);
  for (int j = j0 - 1; j <= j0 + 1; ++j)
    for (int i = i0 - 1; i <= i0 + 1; ++i) {
      if (!base.contains(i, j) || std::isnan(base.at(i, j)) || !(grid.area.at(i, j) > 0.0f)) continue;
      const double x = base.x(i) - p.x, y = base.y(j) - p.y, z = static_cast<double>(base.at(i, j)) - p.z;
      const double away = std::max({std::abs(x), std::abs(y), std::abs(z)});
      if (away > base.cellSize || away >= nearest) continue;
      nearest = away;
      found.grid = index;
      found.cell = base.index(i, j);
    }
}

/// Thickness at a rim beside which snow stands so high. A model that lies deep in the ground or in snow far
/// deeper than its own would get a wall that nobody sees.
float bankedUp(float beside, float depth) {
  constexpr float kMostAbove = 0.5f;  // m
  return beside > 0.0f ? std::min(beside, depth + kMostAbove) : 0.0f;
}

/// From the bank's height at the rim to the patch's own `border` further in, by F2's share of its largest.
float banked(float depth, float bank, float inset, float border) {
  const float share = std::clamp(1.0f - inset / border, 0.0f, 1.0f);
  return depth + (bank - depth) * share * share * (3.0f - 2.0f * share);
}

/// Plan distance to the nearest free rim vertex among those, and that vertex.
std::pair<float, std::int32_t> nearestFree(const PatchCover& patch, const std::vector<std::int32_t>& rims,
                                           const Vec3f& p) {
  std::pair<float, std::int32_t> found{std::numeric_limits<float>::max(), -1};
  for (const std::int32_t r : rims) {
    const Vec3f& q = patch.positions[static_cast<std::size_t>(r)];
    const float away = std::hypot(q.x - p.x, q.y - p.y);
    if (away < found.first) found = {away, r};
  }
  return found;
}

/// One round of averaging over the mesh's edges where the snow is rounded off: the outline of a patch runs in
/// steps of whole cells, its snow must not.
void soften(const PatchCover& patch, std::vector<Vec4f>& snow) {
  std::vector<Vec2f> around(snow.size());
  for (std::size_t t = 0; t + 2 < patch.indices.size(); t += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = patch.indices[t + k], b = patch.indices[t + (k + 1) % 3];
      around[a] = {around[a].x + snow[b].x, around[a].y + 1.0f};
      around[b] = {around[b].x + snow[a].x, around[b].y + 1.0f};
    }
  for (std::size_t v = 0; v < snow.size(); ++v)
    if (patch.cell[v] >= 0 && patch.inset[v] < 3.0f * patch.cellSize && around[v].y > 0.0f)
      snow[v].x = 0.5f * (snow[v].x + around[v].x / around[v].y);
}

}  // namespace

PatchCover makePatchCover(const CoverGrid& grid) {
  return PatchBuilder(grid).build();
}

std::vector<RimContact> rimContacts(const PatchCover& patch, std::size_t own,
                                    const std::vector<CoverGrid>& grids) {
  Box3d box;
  for (const Vec3f& p : patch.positions) box.extend(p.to<double>());
  std::vector<std::size_t> others;
  for (std::size_t g = 0; g < grids.size(); ++g) {
    const Raster<float>& base = grids[g].base;
    const double reach = 1.5 * base.cellSize;
    const bool apart = base.x(0) - reach > box.max.x || base.x(base.width - 1) + reach < box.min.x ||
                       base.y(0) - reach > box.max.y || base.y(base.height - 1) + reach < box.min.y;
    if (g != own && grids[g].node == grids[own].node && !apart) others.push_back(g);
  }
  std::vector<RimContact> contacts;
  for (std::size_t v = 0; v < patch.positions.size() && !others.empty(); ++v) {
    if (patch.cell[v] != -1) continue;
    double nearest = std::numeric_limits<double>::max();
    RimContact found{static_cast<std::uint32_t>(v), 0, 0};
    for (const std::size_t g : others)
      findContact(grids[g], g, patch.positions[v].to<double>(), found, nearest);
    if (nearest < std::numeric_limits<double>::max()) contacts.push_back(found);
  }
  return contacts;
}

void joinRims(PatchCover& patch, const std::vector<RimContact>& contacts) {
  if (contacts.empty()) return;
  std::vector<char> joined(patch.positions.size(), 0);
  for (const RimContact& c : contacts) joined[c.vertex] = 1;
  std::vector<std::int32_t> freeRims;
  for (std::size_t v = 0; v < joined.size(); ++v)
    if (patch.cell[v] < 0 && !joined[v]) freeRims.push_back(static_cast<std::int32_t>(v));
  const float border = static_cast<float>(PatchCover::kBorderCells) * patch.cellSize;
  for (std::size_t v = 0; v < joined.size(); ++v) {
    const std::int32_t rim = patch.rim[v];
    if (!joined[v] && (rim < 0 || !joined[static_cast<std::size_t>(rim)])) continue;
    const auto [away, nearest] = nearestFree(patch, freeRims, patch.positions[v]);
    patch.inset[v] = std::max(away, 1e-3f * patch.cellSize);
    patch.rim[v] = !joined[v] && away < border ? nearest : -1;
  }
}

std::vector<Vec4f> patchCoverSnow(const PatchCover& patch, const std::vector<float>& depth,
                                  const std::vector<float>& beside) {
  const std::size_t n = patch.positions.size();
  std::vector<Vec4f> snow(n);
  const auto depthOf = [&](std::size_t v) { return depth[static_cast<std::size_t>(patch.shownCell[v])]; };
  for (std::size_t v = 0; v < n; ++v) {
    if (patch.cell[v] >= 0 || beside.empty()) continue;
    snow[v].x = patch.inset[v] > 0.0f
                    ? rounded(beside[v], patch.inset[v], std::max(patch.cellSize, 0.8f * beside[v]))
                    : bankedUp(beside[v], depthOf(v));
  }
  const float border = static_cast<float>(PatchCover::kBorderCells) * patch.cellSize;
  for (std::size_t v = 0; v < n; ++v) {
    if (patch.cell[v] < 0) continue;
    const float d = depthOf(v);
    const float bank = patch.rim[v] >= 0 ? snow[static_cast<std::size_t>(patch.rim[v])].x : 0.0f;
    if (bank > 0.0f)
      snow[v].x = banked(d, bank, patch.inset[v], border);
    else
      snow[v].x = rounded(d, patch.inset[v], std::max(patch.cellSize, 0.8f * d));
  }
  soften(patch, snow);
  std::vector<Vec3f> normal(n);
  const auto raised = [&](std::uint32_t v) { return patch.positions[v] + Vec3f{0.0f, 0.0f, snow[v].x}; };
  for (std::size_t t = 0; t + 2 < patch.indices.size(); t += 3) {
    const std::uint32_t a = patch.indices[t], b = patch.indices[t + 1], c = patch.indices[t + 2];
    const Vec3f face = cross(raised(b) - raised(a), raised(c) - raised(a));
    for (const std::uint32_t v : {a, b, c}) normal[v] += face;
  }
  for (std::size_t v = 0; v < n; ++v) {
    const Vec3f unit = length(normal[v]) > 0.0f ? normalized(normal[v]) : Vec3f{0.0f, 0.0f, 1.0f};
    snow[v] = {snow[v].x, unit.x, unit.y, unit.z};
  }
  return snow;
}

void appendCovered(const PatchCover& patch, const std::vector<Vec4f>& snow, std::uint32_t first,
                   std::vector<std::uint32_t>& out, bool bare) {
  constexpr float kVisible = 0.001f;  // m
  for (std::size_t t = 0; t + 2 < patch.indices.size(); t += 3) {
    const std::uint32_t a = patch.indices[t], b = patch.indices[t + 1], c = patch.indices[t + 2];
    if (!bare && std::max({snow[a].x, snow[b].x, snow[c].x}) < kVisible) continue;
    for (const std::uint32_t v : {a, b, c}) out.push_back(first + v);
  }
}

}  // namespace spin
