// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/bench/reference_surface.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace spin {
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
  const double half = 0.5 * base.cellSize;
  m_low = {base.x(i) - half, base.y(j) - half};
  m_high = {base.x(i) + half, base.y(j) + half};
  for (const TerrainGrid& terrain : ground.terrain) {
    if (terrain.grid != grid) continue;
    m_terrain = true;
    m_coarse = terrain.refinement == 0;
  }
  for (std::size_t m = 0; m < ground.models.size(); ++m)
    for (const ModelPatch& patch : ground.models[m].patches) {
      if (patch.grid != grid) continue;
      m_place = scene.models[m].placement.translation;
      addPart(ground.models[m], patch);
    }
}

/// The patch's triangles whose boxes in plan meet the cell; slivers would be hit too seldom in all of its
/// square.
void ReferenceSurface::addPart(const ModelGround& model, const ModelPatch& patch) {
  std::set<std::uint32_t> sources;
  for (const PatchPiece& piece : patch.pieces) sources.insert(piece.source);
  Vec2d low = m_high, high = m_low;
  for (const std::uint32_t source : sources) {
    const PlacedTriangle& t = model.triangles[source];
    const auto [x0, x1] = std::minmax({t.corners[0].x, t.corners[1].x, t.corners[2].x});
    const auto [y0, y1] = std::minmax({t.corners[0].y, t.corners[1].y, t.corners[2].y});
    const Vec2d from{std::max(m_low.x, double(x0)), std::max(m_low.y, double(y0))};
    const Vec2d to{std::min(m_high.x, double(x1)), std::min(m_high.y, double(y1))};
    if (from.x > to.x || from.y > to.y) continue;
    m_triangles.push_back(t);
    low = {std::min(low.x, from.x), std::min(low.y, from.y)};
    high = {std::max(high.x, to.x), std::max(high.y, to.y)};
  }
  m_low = low;
  m_high = high;
}

void ReferenceSurface::pointsAt(const CounterRandom& random, std::uint64_t index,
                                std::vector<ReferencePoint>& points) const {
  const UInt4 w = random.words(index, 0);
  const double x = m_low.x + (m_high.x - m_low.x) * toUnitDouble(w.x, w.y);
  const double y = m_low.y + (m_high.y - m_low.y) * toUnitDouble(w.z, w.w);
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
