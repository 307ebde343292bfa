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

/// The corners of a triangle in texels, z their depth in m.
struct ProjectedTriangle {
  Vec3f a, b, c;
};

/// What a task has found for one band of rows, by band.
using Bins = std::vector<std::vector<ProjectedTriangle>>;

/// Whether a block's shadow can touch what is drawn.
bool sees(const MapProjection& project, const DrawnTexels& drawn, const Occluders::Block& block) {
  const Vec3f centre = (block.low + block.high) * 0.5f, half = (block.high - block.low) * 0.5f;
  const auto reach = [&](const Vec3f& axis) {
    return (std::abs(axis.x) * half.x + std::abs(axis.y) * half.y + std::abs(axis.z) * half.z) *
               project.scale +
           1.0f;
  };
  const Vec3f at = project(centre);
  const float ru = reach(project.s), rv = reach(project.t);
  return at.x + ru >= static_cast<float>(drawn.fromColumn) &&
         at.x - ru <= static_cast<float>(drawn.toColumn) && at.y + rv >= static_cast<float>(drawn.fromRow) &&
         at.y - rv <= static_cast<float>(drawn.toRow);
}

void bin(const ProjectedTriangle& t, const DrawnTexels& drawn, Bins& bins) {
  DrawnTriangle triangle;
  if (!triangle.set(t.a, t.b, t.c, drawn)) return;
  for (int band = triangle.rows.first / kBandRows; band <= triangle.rows.last / kBandRows; ++band)
    bins[static_cast<std::size_t>(band)].push_back(t);
}

/// Draws the part of a triangle in rows [from, to).
void draw(const ProjectedTriangle& t, const MapView& view, int from, int to, float* depth) {
  DrawnTriangle triangle;
  if (!triangle.set(t.a, t.b, t.c, view.drawn)) return;
  const int last = std::min(triangle.rows.last, to - 1);
  for (int row = std::max(triangle.rows.first, from); row <= last; ++row) {
    float* line = depth + static_cast<std::size_t>(row) * static_cast<std::size_t>(view.columns);
    for (int column = triangle.columns.first; column <= triangle.columns.last; ++column) {
      float z = 0.0f;
      const bool inside = triangle.at(static_cast<float>(column), static_cast<float>(row), z);
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
  view.drawn = {0, view.columns, 0, view.rows};
  return view;
}

void MapView::keep(const std::vector<Vec3d>& points) {
  if (points.empty()) return;
  Vec2d least = texelOf(points.front()), most = least;
  for (const Vec3d& p : points) {
    const Vec2d at = texelOf(p);
    least = {std::min(least.x, at.x), std::min(least.y, at.y)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y)};
  }
  // One texel for the comparison of four round a point, one for rounding.
  const auto bounded = [](double at, int count) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count)));
  };
  drawn.fromColumn = bounded(std::floor(least.x) - 2.0, columns),
  drawn.toColumn = bounded(std::ceil(most.x) + 3.0, columns);
  drawn.fromRow = bounded(std::floor(least.y) - 2.0, rows),
  drawn.toRow = bounded(std::ceil(most.y) + 3.0, rows);
}

MapProjection MapView::projection() const {
  return {frame.s.to<float>(),
          frame.t.to<float>(),
          frame.n.to<float>(),
          static_cast<float>(1.0 / texel),
          static_cast<float>(low[0] / texel + 0.5),
          static_cast<float>(low[1] / texel + 0.5)};
}

OcclusionMap::OcclusionMap(const Occluders& occluders, const MapView& view, CpuBackend& backend,
                           const CancelToken& cancel)
    : m_view(view),
      m_depth(static_cast<std::size_t>(view.columns) * static_cast<std::size_t>(view.rows), kNothing) {
  const MapProjection project = view.projection();
  const auto bands = static_cast<std::size_t>((view.rows + kBandRows - 1) / kBandRows);
  const std::vector<Occluders::Block>& blocks = occluders.blocks();
  std::vector<Bins> found((blocks.size() + kBlocksAtOnce - 1) / kBlocksAtOnce);
  backend.forChunks("occlusion map", blocks.size(), kBlocksAtOnce,
                    [&](std::size_t begin, std::size_t end, std::size_t chunk) {
                      if (cancel.cancelled()) return;
                      Bins& bins = found[chunk];
                      for (std::size_t block = begin; block < end; ++block) {
                        if (!sees(project, view.drawn, blocks[block])) continue;
                        bins.resize(bands);
                        const std::size_t first = block * Occluders::kBlock;
                        const std::size_t last = std::min(first + Occluders::kBlock, occluders.size());
                        for (std::size_t k = first; k < last; ++k) {
                          const Occluders::Triangle& t = occluders.triangles()[k];
                          bin({project(t[0]), project(t[1]), project(t[2])}, view.drawn, bins);
                        }
                      }
                    });
  // The nearest of many does not depend on their order.
  backend.forChunks("occlusion map", bands, 1, [&](std::size_t band, std::size_t, std::size_t) {
    if (cancel.cancelled()) return;
    const int from = static_cast<int>(band) * kBandRows, to = std::min(from + kBandRows, view.rows);
    for (const Bins& bins : found)
      if (!bins.empty())
        for (const ProjectedTriangle& t : bins[band]) draw(t, view, from, to, m_depth.data());
  });
}

double OcclusionMap::openness(Vec3d point, Vec3d normal) const {
  const auto [u, v] = m_view.texelOf(point);
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
  // Facets beside the point's own may lean towards the sky by about kLean more than its plane: what that is
  // in depth grows as the square of the slope across the fall.
  constexpr double kLean = 0.1, kMost = 1.0;
  const double steep = (du * du + dv * dv) / (m_view.texel * m_view.texel);
  const double bias = m_view.texel * std::min(kLean * (1.0 + steep), kMost) + 1e-6 * std::abs(own);
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
