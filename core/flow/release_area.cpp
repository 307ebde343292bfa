// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/flow/release_area.h"

#include <algorithm>
#include <cmath>

#include "core/fields/terrain_surface.h"
#include "core/nodes/flow_nodes.h"

namespace spin {
namespace {

/// Samples along the longer side of an outline, at least.
constexpr double kOutlineSamples = 64.0;

double side(Vec2d a, Vec2d b, Vec2d p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool withinBox(Vec2d a, Vec2d b, Vec2d p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

bool segmentsMeet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double sc = side(a, b, c), sd = side(a, b, d), sa = side(c, d, a), sb = side(c, d, b);
  if (((sc > 0) != (sd > 0)) && ((sa > 0) != (sb > 0)) && sc != 0 && sd != 0 && sa != 0 && sb != 0)
    return true;
  return (sc == 0 && withinBox(a, b, c)) || (sd == 0 && withinBox(a, b, d)) ||
         (sa == 0 && withinBox(c, d, a)) || (sb == 0 && withinBox(c, d, b));
}

/// Two unit vectors that span the plane of a unit normal; the first is level.
std::pair<Vec3d, Vec3d> planeAxes(Vec3d n) {
  const Vec3d level{-n.y, n.x, 0.0};
  const Vec3d u = length(level) > 1e-9 ? normalized(level) : Vec3d{1, 0, 0};
  return {u, cross(n, u)};
}

double depthAlongNormal(const ReleaseArea& area, double depth, bool vertical) {
  return vertical ? depth * area.normal().z : depth;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> selfCrossing(const PlanPoints& outline) {
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
      if (!neighbours && segmentsMeet(outline[i], outline[(i + 1) % n], outline[j], outline[(j + 1) % n]))
        return std::pair{i, j};
    }
  return std::nullopt;
}

std::optional<double> FlowGround::heightAt(double x, double y) const {
  return m_heights ? TerrainSurface(*m_heights).heightAt(x, y) : std::optional<double>(0.0);
}

Vec3d FlowGround::normalAt(double x, double y) const {
  return m_heights ? TerrainSurface(*m_heights).normalAt(x, y) : Vec3d{0, 0, 1};
}

ReleaseArea::ReleaseArea(const SceneNode& node, const FlowGround& ground)
    : m_outline(static_cast<const AvalancheReleaseNode&>(*node.data).outline),
      m_painted(ground.heights() ? std::get_if<TiledRaster<std::uint8_t>>(&node.painted) : nullptr),
      m_ground(ground) {
  const Raster<float>* heights = ground.heights();
  if (m_painted && (m_painted->width() != heights->width || m_painted->height() != heights->height))
    m_painted = nullptr;
  m_step = heights ? heights->cellSize : 1e300;
  if (m_outline.size() >= 3) sampleOutline();
  if (m_painted) samplePainted();
  Vec3d sum{};
  for (const Vec3d& p : m_samples) sum += ground.normalAt(p.x, p.y);
  if (length(sum) > 0.0) m_normal = normalized(sum);
}

bool ReleaseArea::inOutline(double x, double y) const {
  bool inside = false;
  const std::size_t n = m_outline.size();
  for (std::size_t i = 0, j = n - 1; n >= 3 && i < n; j = i++) {
    const Vec2d a = m_outline[i], b = m_outline[j];
    if ((a.y > y) != (b.y > y) && x < (b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

bool ReleaseArea::isPainted(double x, double y) const {
  if (!m_painted) return false;
  const Raster<float>& r = *m_ground.heights();
  const int i = r.column(x), j = r.row(y);
  return r.contains(i, j) && m_painted->at(i, j) == kReleasePainted;
}

bool ReleaseArea::contains(double x, double y) const {
  return inOutline(x, y) || isPainted(x, y);
}

bool ReleaseArea::addSample(double x, double y) {
  const std::optional<double> z = m_ground.heightAt(x, y);
  if (z) m_samples.push_back({x, y, *z});
  return z.has_value();
}

void ReleaseArea::sampleOutline() {
  Vec2d low = m_outline[0], high = m_outline[0];
  for (const Vec2d& p : m_outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  m_step = std::min(m_step, std::max(high.x - low.x, high.y - low.y) / kOutlineSamples);
  if (!(m_step > 0.0)) return;
  double inside = 0.0, bare = 0.0;
  for (double y = low.y + 0.5 * m_step; y < high.y; y += m_step)
    for (double x = low.x + 0.5 * m_step; x < high.x; x += m_step) {
      if (!inOutline(x, y)) continue;
      inside += 1.0;
      if (!addSample(x, y)) bare += 1.0;
    }
  m_shareWithoutGround = inside > 0.0 ? bare / inside : 1.0;
}

void ReleaseArea::samplePainted() {
  const Raster<float>& r = *m_ground.heights();
  // As dense as the samples within the outline, so that all weigh the same.
  const int parts = std::max(1, static_cast<int>(std::ceil(r.cellSize / m_step - 1e-6)));
  const double step = r.cellSize / parts;
  for (int j = 0; j < r.height; ++j)
    for (int i = 0; i < r.width; ++i) {
      if (m_painted->at(i, j) != kReleasePainted) continue;
      for (int k = 0; k < parts * parts; ++k) {
        const double x = r.x(i) + (k % parts + 0.5) * step - 0.5 * r.cellSize;
        const double y = r.y(j) + (k / parts + 0.5) * step - 0.5 * r.cellSize;
        if (!inOutline(x, y)) addSample(x, y);
      }
    }
}

double slabParticles(const ReleaseArea& area, double depth, bool depthIsVertical, double spacing) {
  // Every sample stands for a square in plan, which is larger along the slope.
  double surface = 0.0;
  for (std::size_t k = 0; k < area.samples().size(); ++k) surface += area.sampleSize() * area.sampleSize();
  surface /= std::max(area.normal().z, 0.05);
  return surface * depthAlongNormal(area, depth, depthIsVertical) / (spacing * spacing * spacing);
}

namespace {

/// Where the line through p along n meets the ground; nothing where it does not.
std::optional<Vec3d> groundAlong(const FlowGround& ground, Vec3d p, Vec3d n, double tolerance) {
  constexpr int kTries = 24;
  for (int k = 0; k < kTries; ++k) {
    const std::optional<double> z = ground.heightAt(p.x, p.y);
    if (!z) return std::nullopt;
    const double above = p.z - *z;
    if (std::abs(above) < tolerance) return Vec3d{p.x, p.y, *z};
    const Vec3d m = ground.normalAt(p.x, p.y);
    const double slope = dot(m, n);
    if (!(slope > 0.1)) return std::nullopt;
    // Distance along n to the plane of the facet under p.
    p = p - n * (above * m.z / slope);
  }
  return std::nullopt;
}

}  // namespace

Slab fillSlab(const ReleaseArea& area, const FlowGround& ground, double depth, bool depthIsVertical,
              double spacing) {
  Slab slab;
  slab.depth = depthAlongNormal(area, depth, depthIsVertical);
  slab.layers = std::max(1, static_cast<int>(std::lround(slab.depth / spacing)));
  if (area.samples().empty()) return slab;
  const Vec3d n = area.normal(), origin = area.samples().front();
  const auto [u, v] = planeAxes(n);
  const double thick = slab.depth / slab.layers;
  const double pitch = std::sqrt(spacing * spacing * spacing / thick);
  double lowU = 0, highU = 0, lowV = 0, highV = 0;
  for (const Vec3d& p : area.samples()) {
    const double a = dot(p - origin, u), b = dot(p - origin, v);
    lowU = std::min(lowU, a), highU = std::max(highU, a);
    lowV = std::min(lowV, b), highV = std::max(highV, b);
  }
  const double reach = 2.0 * area.sampleSize();
  const auto first = [&](double low) { return static_cast<long>(std::floor((low - reach) / pitch)); };
  const auto last = [&](double high) { return static_cast<long>(std::ceil((high + reach) / pitch)); };
  for (long j = first(lowV); j <= last(highV); ++j)
    for (long i = first(lowU); i <= last(highU); ++i) {
      const Vec3d p = origin + u * ((static_cast<double>(i) + 0.5) * pitch) +
                      v * ((static_cast<double>(j) + 0.5) * pitch);
      const std::optional<Vec3d> foot = groundAlong(ground, p, n, 1e-3 * spacing);
      if (!foot || !area.contains(foot->x, foot->y)) continue;
      for (int k = 0; k < slab.layers; ++k) slab.positions.push_back(*foot + n * ((k + 0.5) * thick));
    }
  return slab;
}

}  // namespace spin
