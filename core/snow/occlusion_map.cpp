// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/occlusion_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr int kBandRows = 16;
constexpr std::size_t kBlocksAtOnce = 32;

/// A triangle in texels, z its depth in m.
struct DrawnTriangle {
  Vec3f a, b, c;
};

/// What a task has found for one band of rows, by band.
using Bins = std::vector<std::vector<DrawnTriangle>>;

/// Projects to texels whose centres are at whole numbers.
class Projector {
 public:
  explicit Projector(const MapView& view)
      : m_s(view.frame.s.to<float>()),
        m_t(view.frame.t.to<float>()),
        m_n(view.frame.n.to<float>()),
        m_scale(static_cast<float>(1.0 / view.texel)),
        m_u(static_cast<float>(view.low[0] / view.texel + 0.5)),
        m_v(static_cast<float>(view.low[1] / view.texel + 0.5)) {}

  Vec3f operator()(const Vec3f& p) const {
    return {dot(p, m_s) * m_scale - m_u, dot(p, m_t) * m_scale - m_v, dot(p, m_n)};
  }
  /// Whether a block's shadow can touch the map.
  bool sees(const Occluders::Block& block, const MapView& view) const {
    const Vec3f centre = (block.low + block.high) * 0.5f, half = (block.high - block.low) * 0.5f;
    const auto reach = [&](const Vec3f& axis) {
      return (std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z) * m_scale +
             1.0f;
    };
    const Vec3f at = (*this)(centre);
    const float ru = reach(m_s), rv = reach(m_t);
    return at.x + ru >= 0.0f && at.x - ru <= static_cast<float>(view.columns) && at.y + rv >= 0.0f &&
           at.y - rv <= static_cast<float>(view.rows);
  }

 private:
  Vec3f m_s, m_t, m_n;
  float m_scale, m_u, m_v;
};

/// Texels within [low, high], clamped to [0, count).
struct TexelRange {
  int first, last;
};
TexelRange texelsIn(float low, float high, int count) {
  const float most = static_cast<float>(count);
  return {static_cast<int>(std::ceil(std::clamp(low, 0.0f, most))),
          static_cast<int>(std::floor(std::clamp(high, -1.0f, most - 1.0f)))};
}

void bin(const DrawnTriangle& t, const MapView& view, Bins& bins) {
  const auto [u0, u1] = std::minmax({t.a.x, t.b.x, t.c.x});
  const TexelRange columns = texelsIn(u0, u1, view.columns);
  if (columns.first > columns.last) return;
  const auto [v0, v1] = std::minmax({t.a.y, t.b.y, t.c.y});
  const TexelRange rows = texelsIn(v0, v1, view.rows);
  if (rows.first > rows.last) return;
  for (int band = rows.first / kBandRows; band <= rows.last / kBandRows; ++band)
    bins[static_cast<std::size_t>(band)].push_back(t);
}

/// Draws the part of a triangle in rows [from, to) by its edge functions.
void draw(const DrawnTriangle& t, const MapView& view, int from, int to, float* depth) {
  const float doubled = (t.b.x - t.a.x) * (t.c.y - t.a.y) - (t.c.x - t.a.x) * (t.b.y - t.a.y);
  if (doubled == 0.0f) return;
  const float inverse = 1.0f / doubled;
  // Weights of b and c grow linearly over the map.
  const float bu = (t.c.y - t.a.y) * inverse, bv = (t.a.x - t.c.x) * inverse;
  const float cu = (t.a.y - t.b.y) * inverse, cv = (t.b.x - t.a.x) * inverse;
  const auto [v0, v1] = std::minmax({t.a.y, t.b.y, t.c.y});
  const auto [u0, u1] = std::minmax({t.a.x, t.b.x, t.c.x});
  const TexelRange columns = texelsIn(u0, u1, view.columns), rows = texelsIn(v0, v1, view.rows);
  const float db = t.b.z - t.a.z, dc = t.c.z - t.a.z;
  // On the border within rounding counts as inside: neighbours leave no gap.
  constexpr float kEdge = -1e-5f;
  for (int row = std::max(rows.first, from); row <= std::min(rows.last, to - 1); ++row) {
    float* line = depth + static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns);
    const float y = static_cast<float>(row) - t.a.y;
    for (int column = columns.first; column <= columns.last; ++column) {
      const float x = static_cast<float>(column) - t.a.x;
      const float b = bu * x + bv * y, c = cu * x + cv * y;
      const bool inside = b >= kEdge && c >= kEdge && b + c <= 1.0f - kEdge;
      const float z = t.a.z + b * db + c * dc;
      line[column] = inside && z < line[column] ? z : line[column];
    }
  }
}

}  // namespace

Occluders::Occluders(const SceneSnapshot& snapshot, const SnowScene& scene, const CancelToken& cancel) {
  for (const StandingModel& model : scene.models) {
    const Vec3d move = model.placement.translation - scene.centre;
    for (const PlacedTriangle& triangle : model.triangles) {
      Triangle t;
      for (std::size_t k = 0; k < 3; ++k) t[k] = (triangle.corners[k].to<double>() + move).to<float>();
      m_triangles.push_back(t);
    }
    // A block holds parts of one model only, lest its bounds span the gap between two.
    while (m_triangles.size() % kBlock != 0) m_triangles.push_back(m_triangles.back());
  }
  if (scene.hasTerrain) addTerrain(snapshot, scene, cancel);
  bound();
}

void Occluders::addTerrain(const SceneSnapshot& snapshot, const SnowScene& scene, const CancelToken& cancel) {
  // Patches of quads, so that blocks are compact.
  constexpr int kSide = 11;
  const TerrainSurface surface(snapshot.terrain->heights);
  const Raster<float>& h = surface.heights();
  const auto point = [&](int i, int j) {
    return (Vec3d{h.x(i), h.y(j), h.at(i, j)} - scene.centre).to<float>();
  };
  for (int j0 = 0; j0 + 1 < h.height && !cancel.cancelled(); j0 += kSide)
    for (int i0 = 0; i0 + 1 < h.width; i0 += kSide)
      for (int j = j0; j < std::min(j0 + kSide, h.height - 1); ++j)
        for (int i = i0; i < std::min(i0 + kSide, h.width - 1); ++i) {
          if (!surface.quadExists(i, j)) continue;
          const Vec3f a = point(i, j), c = point(i + 1, j + 1);
          m_triangles.push_back({a, point(i + 1, j), c});
          m_triangles.push_back({a, c, point(i, j + 1)});
        }
}

void Occluders::bound() {
  for (std::size_t begin = 0; begin < m_triangles.size(); begin += kBlock) {
    Block block{m_triangles[begin][0], m_triangles[begin][0]};
    for (std::size_t k = begin; k < std::min(begin + kBlock, m_triangles.size()); ++k)
      for (const Vec3f& p : m_triangles[k]) {
        block.low = {std::min(block.low.x, p.x), std::min(block.low.y, p.y), std::min(block.low.z, p.z)};
        block.high = {std::max(block.high.x, p.x), std::max(block.high.y, p.y), std::max(block.high.z, p.z)};
      }
    m_blocks.push_back(block);
  }
}

MapView MapView::round(const std::vector<Vec3d>& points, Vec3d fall, double wantedTexel, int most) {
  MapView view;
  view.frame = frameAround(fall);
  if (points.empty()) return view;
  double low[2], high[2];
  for (int k = 0; k < 2; ++k) {
    const Vec3d axis = k == 0 ? view.frame.s : view.frame.t;
    low[k] = high[k] = dot(points.front(), axis);
    for (const Vec3d& p : points) {
      low[k] = std::min(low[k], dot(p, axis));
      high[k] = std::max(high[k], dot(p, axis));
    }
  }
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  view.texel = std::max(wantedTexel, size / std::max(most - 4, 1));
  // Two texels of margin, for the comparison of four round a point.
  for (int k = 0; k < 2; ++k) view.low[k] = low[k] - 2.0 * view.texel;
  view.columns = static_cast<int>(std::ceil((high[0] - low[0]) / view.texel)) + 4;
  view.rows = static_cast<int>(std::ceil((high[1] - low[1]) / view.texel)) + 4;
  return view;
}

OcclusionMap::OcclusionMap(const Occluders& occluders, const MapView& view, CpuBackend& backend,
                           const CancelToken& cancel)
    : m_view(view),
      m_depth(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows), kNothing) {
  const Projector project(view);
  const auto bands = static_cast<std::size_t>((view.rows + kBandRows - 1) / kBandRows);
  const std::vector<Occluders::Block>& blocks = occluders.blocks();
  std::vector<Bins> found((blocks.size() + kBlocksAtOnce - 1) / kBlocksAtOnce);
  backend.forChunks("occlusion map", blocks.size(), kBlocksAtOnce,
                    [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                      if (cancel.cancelled()) return;
                      Bins& bins = found[chunk];
                      for (std::size_t block = begin; block < end; ++block) {
                        if (!project.sees(blocks[block], view)) continue;
                        bins.resize(bands);
                        const std::size_t first = block * Occluders::kBlock;
                        const std::size_t last = std::min(first + Occluders::kBlock, occluders.size());
                        for (std::size_t k = first; k < last; ++k) {
                          const Occluders::Triangle& t = occluders.triangles()[k];
                          bin({project(t[0]), project(t[1]), project(t[2])}, view, bins);
                        }
                      }
                    });
  // The nearest of many does not depend on their order.
  backend.forChunks("occlusion map", bands, 1, [&](std::size_t band, std::size_t, std::size_t) {
    if (cancel.cancelled()) return;
    const int from = static_cast<int>(band) * kBandRows, to = std::min(from + kBandRows, view.rows);
    for (const Bins& bins : found)
      if (!bins.empty())
        for (const DrawnTriangle& t : bins[band]) draw(t, view, from, to, m_depth.data());
  });
}

double OcclusionMap::openness(Vec3d point, Vec3d normal) const {
  const double u = (dot(point, m_view.frame.s) - m_view.low[0]) / m_view.texel - 0.5;
  const double v = (dot(point, m_view.frame.t) - m_view.low[1]) / m_view.texel - 0.5;
  const double own = dot(point, m_view.frame.n);
  const double floorU = std::floor(u), floorV = std::floor(v);
  const int i = static_cast<int>(floorU), j = static_cast<int>(floorV);
  if (!(u >= 0.0 && v >= 0.0) || i + 1 >= m_view.columns || j + 1 >= m_view.rows) return 1.0;
  // How the receiver's plane falls away across a texel, m; surfaces nearly along the fall are held at what
  // keeps the comparison's reach below kSteepest texels.
  constexpr double kSteepest = 8.0;
  const double towards = std::max(-dot(normal, m_view.frame.n), 1e-9);
  const auto slope = [&](const Vec3d& axis) {
    return std::clamp(dot(normal, axis) / towards, -kSteepest, kSteepest) * m_view.texel;
  };
  const double du = slope(m_view.frame.s), dv = slope(m_view.frame.t);
  // Facets beside the point's own may rise a little above its plane.
  const double bias = 0.1 * m_view.texel + 1e-6 * std::abs(own);
  const double fu = u - floorU, fv = v - floorV;
  double open = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int a = corner & 1, b = corner >> 1;
    const double plane = own + (a - fu) * du + (b - fv) * dv;
    const double weight = (a ? fu : 1.0 - fu) * (b ? fv : 1.0 - fv);
    if (static_cast<double>(depth(i + a, j + b)) - plane + bias >= 0.0) open += weight;
  }
  return open;
}

}  // namespace spin
