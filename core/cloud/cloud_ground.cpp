// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/cloud/cloud_ground.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

/// Holes get the height of a cell with data that is few cells away, from the rims inwards.
void fillHoles(Raster<float>& heights) {
  std::deque<std::pair<int, int>> front;
  for (int j = 0; j < heights.height; ++j)
    for (int i = 0; i < heights.width; ++i)
      if (!std::isnan(heights.at(i, j))) front.emplace_back(i, j);
  if (front.size() == heights.size() || front.empty()) return;
  for (; !front.empty(); front.pop_front()) {
    const auto [i, j] = front.front();
    for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const int a = i + di, b = j + dj;
      if (a < 0 || b < 0 || a >= heights.width || b >= heights.height || !std::isnan(heights.at(a, b)))
        continue;
      heights.at(a, b) = heights.at(i, j);
      front.emplace_back(a, b);
    }
  }
}

}  // namespace

CloudGround::CloudGround(const SceneSnapshot& scene) {
  if (!scene.terrain || scene.terrain->heights.empty()) return;
  auto heights = std::make_shared<Raster<float>>(scene.terrain->heights);
  fillHoles(*heights);
  if (std::isnan(heights->values.front())) return;
  m_highest = static_cast<double>(*std::max_element(heights->values.begin(), heights->values.end()));
  m_heights = std::move(heights);
}

Vec2d CloudGround::held(double x, double y) const {
  const Raster<float>& h = *m_heights;
  return {std::clamp(x, h.x(0), h.x(h.width - 1)), std::clamp(y, h.y(0), h.y(h.height - 1))};
}

double CloudGround::height(double x, double y) const {
  if (!m_heights) return 0.0;
  const Vec2d p = held(x, y);
  return TerrainSurface(*m_heights)
      .heightAt(p.x, p.y)
      .value_or(static_cast<double>(m_heights->values.front()));
}

double CloudGround::distance(Vec3d p) const {
  if (!m_heights) return p.z;
  const Vec2d at = held(p.x, p.y);
  const double above = p.z - height(p.x, p.y);
  return above * TerrainSurface(*m_heights).normalAt(at.x, at.y).z;
}

bool CloudGround::mayTouch(Vec3d low, Vec3d high) const {
  if (!m_heights) return low.z <= 0.0;
  if (low.z > m_highest) return false;
  // The surface between cells lies between their heights.
  const Raster<float>& h = *m_heights;
  const Vec2d first = held(low.x, low.y), last = held(high.x, high.y);
  const int i0 = std::max(h.column(first.x) - 1, 0), i1 = std::min(h.column(last.x) + 1, h.width - 1);
  const int j0 = std::max(h.row(first.y) - 1, 0), j1 = std::min(h.row(last.y) + 1, h.height - 1);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i)
      if (static_cast<double>(h.at(i, j)) >= low.z) return true;
  return false;
}

}  // namespace spin
