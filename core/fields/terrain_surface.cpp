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

/// The lower triangle lies where u >= v; its plane goes on beyond it.
Plane planeAt(const Raster<float>& h, const QuadPoint& p, bool lower) {
  const double z00 = h.at(p.i, p.j), z10 = h.at(p.i + 1, p.j);
  const double z01 = h.at(p.i, p.j + 1), z11 = h.at(p.i + 1, p.j + 1);
  const double du = lower ? z10 - z00 : z11 - z01;
  const double dv = lower ? z11 - z10 : z01 - z00;
  return {z00 + du * p.u + dv * p.v, du, dv};
}

Plane planeAt(const Raster<float>& h, const QuadPoint& p) {
  return planeAt(h, p, p.u >= p.v);
}

struct Line {
  Vec3d from, direction;  ///< direction of unit length
  Vec3d at(double t) const { return from + direction * t; }
};

/// Where the line from 0 on reaches an offset along one axis; never where it does not move along it.
double crossing(double offset, double speed) {
  return speed == 0.0 ? std::numeric_limits<double>::infinity() : offset / speed;
}

/// The part of a stretch of the line in which one coordinate lies within [low, high]; empty (y < x) if there
/// is none.
Vec2d cut(const Line& line, Vec2d stretch, int axis, double low, double high) {
  const double from = line.from[axis], d = line.direction[axis];
  if (d == 0.0) return from < low || from > high ? Vec2d{1.0, 0.0} : stretch;
  const double a = (low - from) / d, b = (high - from) / d;
  return {std::max(stretch.x, std::min(a, b)), std::min(stretch.y, std::max(a, b))};
}

/// Lowest and highest corner of a quad, a little apart so that level quads have room for rounding.
Vec2d quadRange(const Raster<float>& h, int i, int j) {
  const auto [low, high] = std::minmax({h.at(i, j), h.at(i + 1, j), h.at(i, j + 1), h.at(i + 1, j + 1)});
  const double margin = 1e-6 * (h.cellSize + static_cast<double>(std::max(std::abs(low), std::abs(high))));
  return {static_cast<double>(low) - margin, static_cast<double>(high) + margin};
}

/// First point of the stretch [t0, t1], which lies in the quad's column, on one of the quad's triangles. Over
/// each triangle the height above its plane is linear along the line, so the two ends tell. `side` carries on
/// which side the line left the triangle before, +1 above, -1 below, 0 where there was none: rounding opens
/// no crack between two triangles.
std::optional<double> hitInQuad(const Raster<float>& h, int i, int j, const Line& line, double t0, double t1,
                                int& side) {
  const auto above = [&](double t, bool lower) {
    const Vec3d p = line.at(t);
    QuadPoint q{i, j, (p.x - h.x(i)) / h.cellSize, (p.y - h.y(j)) / h.cellSize};
    return p.z - planeAt(h, q, lower).z;
  };
  const auto hit = [&](double a, double b, bool lower) -> std::optional<double> {
    const double za = above(a, lower), zb = above(b, lower);
    const int first = za > 0.0 ? 1 : -1;
    if (za == 0.0 || first == -side) return a;
    side = zb > 0.0 ? 1 : -1;
    if (side == first && zb != 0.0) return {};
    return a + (b - a) * (za / (za - zb));
  };
  const auto diagonal = [&](double t) {
    const Vec3d p = line.at(t);
    return (p.x - h.x(i)) - (p.y - h.y(j));
  };
  const double d0 = diagonal(t0), d1 = diagonal(t1);
  if ((d0 >= 0.0) == (d1 >= 0.0)) return hit(t0, t1, d0 + d1 >= 0.0);
  const double middle = t0 + (t1 - t0) * (d0 / (d0 - d1));
  if (const auto first = hit(t0, middle, d0 >= 0.0)) return first;
  return hit(middle, t1, d1 >= 0.0);
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

double TerrainSurface::nearestHeight(double x, double y) const {
  if (const auto z = heightAt(x, y)) return *z;
  const Raster<float>& h = *m_heights;
  double nearest = std::numeric_limits<double>::infinity(), height = 0.0;
  for (int j = 0; j < h.height; ++j)
    for (int i = 0; i < h.width; ++i) {
      const double distance = std::hypot(h.x(i) - x, h.y(j) - y);
      if (std::isnan(h.at(i, j)) || distance >= nearest) continue;
      nearest = distance;
      height = static_cast<double>(h.at(i, j));
    }
  return height;
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
  const double size = length(direction);
  if (h.width < 2 || h.height < 2 || !(size > 0.0)) return {};
  const Line line{from, direction / size};
  Vec2d inside{0.0, std::numeric_limits<double>::infinity()};
  inside = cut(line, inside, 0, h.x(0), h.x(h.width - 1));
  inside = cut(line, inside, 1, h.y(0), h.y(h.height - 1));
  if (!(inside.x <= inside.y)) return {};
  // Walk of Amanatides and Woo 1987 over the columns of quads, each with its exact stretch of the ray.
  double t = inside.x;
  const Vec3d entry = line.at(t);
  const auto cell = [&](double offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / h.cellSize), 0.0, count - 2.0));
  };
  int i = cell(entry.x - h.originX, h.width), j = cell(entry.y - h.originY, h.height), side = 0;
  const int stepI = line.direction.x < 0.0 ? -1 : 1, stepJ = line.direction.y < 0.0 ? -1 : 1;
  while (i >= 0 && j >= 0 && i + 1 < h.width && j + 1 < h.height) {
    const double outX = crossing(h.x(stepI > 0 ? i + 1 : i) - from.x, line.direction.x);
    const double outY = crossing(h.y(stepJ > 0 ? j + 1 : j) - from.y, line.direction.y);
    const double out = std::max(t, std::min({outX, outY, inside.y}));
    if (!quadExists(i, j)) {
      side = 0;
    } else {
      const Vec2d range = quadRange(h, i, j);
      const Vec2d near = cut(line, {t, out}, 2, range.x, range.y);
      if (!(near.x <= near.y))
        side = line.at(t).z > range.y ? 1 : -1;
      else if (const auto hit = hitInQuad(h, i, j, line, near.x, near.y, side))
        return line.at(*hit);
    }
    if (out >= inside.y) return {};
    (outX <= outY ? i : j) += outX <= outY ? stepI : stepJ;
    t = out;
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
