// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/reference_surface.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace spin {
namespace {

/// Whether the triangle has a part over the square in plan, judged by its box.
bool meets(const PlacedTriangle& t, double x, double y, double half) {
  const auto [x0, x1] = std::minmax({t.corners[0].x, t.corners[1].x, t.corners[2].x});
  const auto [y0, y1] = std::minmax({t.corners[0].y, t.corners[1].y, t.corners[2].y});
  return static_cast<double>(x0) <= x + half && static_cast<double>(x1) >= x - half &&
         static_cast<double>(y0) <= y + half && static_cast<double>(y1) >= y - half;
}

}  // namespace

Vec3d referenceDirection(const FallCone& cone, const CounterRandom& random, std::uint64_t index) {
  const UInt4 w = random.words(index, 1);
  const double cosine = 1.0 - cone.oneMinusCos * toUnitDouble(w.x, w.y);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double turn = 2.0 * kPi * toUnitDouble(w.z, w.w);
  return cone.frame.s * (sine * std::cos(turn)) + cone.frame.t * (sine * std::sin(turn)) +
         cone.frame.n * cosine;
}

ReferenceSurface::ReferenceSurface(const SceneSnapshot& snapshot, const SnowGround& ground,
                                   const SnowScene& scene, std::size_t grid, std::size_t cell)
    : m_snapshot(&snapshot), m_ground(&ground) {
  const Raster<float>& base = ground.layout->grids[grid].base;
  const int i = static_cast<int>(cell) % base.width, j = static_cast<int>(cell) / base.width;
  m_x = base.x(i);
  m_y = base.y(j);
  m_size = base.cellSize;
  for (const TerrainGrid& terrain : ground.terrain) {
    if (terrain.grid != grid) continue;
    m_terrain = true;
    m_coarse = terrain.refinement == 0;
  }
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (const ModelPatch& patch : ground.models[m].patches) {
      if (patch.grid != grid) continue;
      m_place = scene.models[m].placement.translation;
      std::set<std::uint32_t> sources;
      for (const PatchPiece& piece : patch.pieces) sources.insert(piece.source);
      for (const std::uint32_t source : sources)
        if (meets(ground.models[m].triangles[source], m_x, m_y, 0.5 * m_size))
          m_triangles.push_back(ground.models[m].triangles[source]);
    }
}

void ReferenceSurface::pointsAt(const CounterRandom& random, std::uint64_t index,
                                std::vector<ReferencePoint>& points) const {
  const UInt4 w = random.words(index, 0);
  const double x = m_x + m_size * (toUnitDouble(w.x, w.y) - 0.5),
               y = m_y + m_size * (toUnitDouble(w.z, w.w) - 0.5);
  if (m_terrain)
    terrainPoint(x, y, points);
  else
    modelPoints(x, y, points);
}

bool ReferenceSurface::fineGridCovers(double x, double y) const {
  return std::any_of(m_ground->terrain.begin(), m_ground->terrain.end(), [&](const TerrainGrid& terrain) {
    if (terrain.refinement == 0) return false;
    const Raster<float>& base = m_ground->layout->grids[terrain.grid].base;
    return base.contains(base.column(x), base.row(y));
  });
}

void ReferenceSurface::terrainPoint(double x, double y, std::vector<ReferencePoint>& points) const {
  if (m_coarse && fineGridCovers(x, y)) return;
  const TerrainSurface surface(m_snapshot->terrain->heights);
  if (const auto z = surface.heightAt(x, y)) points.push_back({{x, y, *z}, surface.normalAt(x, y)});
}

void ReferenceSurface::modelPoints(double x, double y, std::vector<ReferencePoint>& points) const {
  for (const PlacedTriangle& triangle : m_triangles) {
    const Vec3d a = triangle.corners[0].to<double>(), b = triangle.corners[1].to<double>(),
                c = triangle.corners[2].to<double>();
    const Vec3d n = triangle.normal();
    // Shares of the corners by areas in plan; the point is inside where none is negative.
    const double sb = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / n.z;
    const double sc = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / n.z;
    if (!(sb >= 0.0 && sc >= 0.0 && sb + sc <= 1.0)) continue;
    const Vec3d up = normalized(n.z < 0.0 ? -n : n);
    points.push_back({m_place + a + (b - a) * sb + (c - a) * sc, up});
  }
}

}  // namespace spin
