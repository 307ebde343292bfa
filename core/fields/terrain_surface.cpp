// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_surface.h"

#include <algorithm>
#include <limits>

namespace spin {
namespace {

struct QuadPoint {
  int i = 0, j = 0;     // quad
  double u = 0, v = 0;  // position in it, 0..1
};

std::optional<QuadPoint> locate(const Raster<float>& h, double x, double y) {
  const double gx = (x - h.originX) / h.cellSize;
  const double gy = (y - h.originY) / h.cellSize;
  if (!(gx >= 0.0 && gy >= 0.0 && gx <= h.width - 1 && gy <= h.height - 1)) return {};
  QuadPoint p;
  p.i = std::min(static_cast<int>(gx), h.width - 2);
  p.j = std::min(static_cast<int>(gy), h.height - 2);
  p.u = gx - p.i;
  p.v = gy - p.j;
  return p;
}

/// Slopes of the triangle that holds the point: dz/du and dz/dv, and z.
struct Plane {
  double z, du, dv;
};

Plane planeAt(const Raster<float>& h, const QuadPoint& p) {
  const double z00 = h.at(p.i, p.j), z10 = h.at(p.i + 1, p.j);
  const double z01 = h.at(p.i, p.j + 1), z11 = h.at(p.i + 1, p.j + 1);
  const bool lower = p.u >= p.v;
  const double du = lower ? z10 - z00 : z11 - z01;
  const double dv = lower ? z11 - z10 : z01 - z00;
  return {z00 + du * p.u + dv * p.v, du, dv};
}

}  // namespace

bool TerrainSurface::quadExists(int i, int j) const {
  const Raster<float>& h = *m_heights;
  if (i < 0 || j < 0 || i + 1 >= h.width || j + 1 >= h.height) return false;
  return !std::isnan(h.at(i, j)) && !std::isnan(h.at(i + 1, j)) && !std::isnan(h.at(i, j + 1)) &&
         !std::isnan(h.at(i + 1, j + 1));
}

std::optional<double> TerrainSurface::heightAt(double x, double y) const {
  const auto p = locate(*m_heights, x, y);
  if (!p || !quadExists(p->i, p->j)) return {};
  return planeAt(*m_heights, *p).z;
}

Vec3d TerrainSurface::normalAt(double x, double y) const {
  const auto p = locate(*m_heights, x, y);
  if (!p || !quadExists(p->i, p->j)) return {0, 0, 1};
  const Plane plane = planeAt(*m_heights, *p);
  return normalized(Vec3d{-plane.du, -plane.dv, m_heights->cellSize});
}

double TerrainSurface::cellArea(int i, int j) const {
  const int quads = quadExists(i - 1, j - 1) + quadExists(i, j - 1) + quadExists(i - 1, j) + quadExists(i, j);
  return 0.25 * quads * m_heights->cellSize * m_heights->cellSize;
}

std::optional<Vec3d> TerrainSurface::raycast(Vec3d from, Vec3d direction) const {
  const Raster<float>& h = *m_heights;
  const double horizontal = std::hypot(direction.x, direction.y);
  if (horizontal < 1e-12) {
    const auto z = heightAt(from.x, from.y);
    if (!z || (direction.z < 0.0) != (from.z >= *z)) return {};
    return Vec3d{from.x, from.y, *z};
  }
  // March in half cells along the horizontal, then bisect the crossing; a crossing is a change of side.
  const double step = 0.5 * h.cellSize / horizontal;
  const Box3d box = boundsOf(h);
  const double reach = (length(box.size()) + length(from - box.centre())) / length(direction);
  double previous = 0.0;
  std::optional<double> sidePrevious;
  for (double t = 0.0; t <= reach; t += step) {
    const Vec3d p = from + direction * t;
    const auto z = heightAt(p.x, p.y);
    const std::optional<double> side = z ? std::optional<double>(p.z - *z) : std::nullopt;
    if (side && sidePrevious && *sidePrevious >= 0.0 && *side < 0.0) {
      double low = previous, high = t;
      for (int k = 0; k < 40; ++k) {
        const double mid = 0.5 * (low + high);
        const Vec3d q = from + direction * mid;
        const auto zq = heightAt(q.x, q.y);
        (zq && q.z < *zq ? high : low) = mid;
      }
      return from + direction * high;
    }
    previous = t;
    sidePrevious = side;
  }
  return {};
}

Vec2d valueRange(const Raster<float>& raster) {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const float v : raster.values) {
    if (std::isnan(v)) continue;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  return low <= high ? Vec2d{low, high} : Vec2d{};
}

Box3d boundsOf(const Raster<float>& h) {
  Box3d box;
  for (int j = 0; j < h.height; ++j)
    for (int i = 0; i < h.width; ++i)
      if (const float z = h.at(i, j); !std::isnan(z)) box.extend(Vec3d{h.x(i), h.y(j), z});
  return box;
}

}  // namespace spin
