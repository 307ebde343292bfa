// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/draw_context.h"

#include <algorithm>
#include <cmath>

namespace spin {

Frustum::Frustum(const Matrix4& m) : m_planes{} {
  // Rows of the matrix: inside means -w <= x <= w, -w <= y <= w and, with reversed depth, z <= w.
  const auto plane = [&](std::size_t k, std::size_t row, double sign) {
    for (std::size_t c = 0; c < 4; ++c) {
      const double w = static_cast<double>(m[c * 4 + 3]);
      m_planes[k][c] = w + sign * static_cast<double>(m[c * 4 + row]);
    }
  };
  plane(0, 0, 1.0);
  plane(1, 0, -1.0);
  plane(2, 1, 1.0);
  plane(3, 1, -1.0);
  plane(4, 2, -1.0);
}

bool Frustum::mayShow(const Box3d& box) const {
  for (const auto& p : m_planes) {
    const double x = p[0] > 0.0 ? box.max.x : box.min.x;
    const double y = p[1] > 0.0 ? box.max.y : box.min.y;
    const double z = p[2] > 0.0 ? box.max.z : box.min.z;
    if (p[0] * x + p[1] * y + p[2] * z + p[3] < 0.0) return false;
  }
  return true;
}

std::array<int, 4> pixelsOf(const Box3d& box, const Matrix4& m, int width, int height, double margin) {
  if (box.empty()) return {0, 0, 0, 0};
  double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3d p{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                  corner & 4 ? box.max.z : box.min.z};
    const auto row = [&](std::size_t r) {
      double sum = static_cast<double>(m[12 + r]);
      for (std::size_t c = 0; c < 3; ++c) sum += static_cast<double>(m[c * 4 + r]) * p[static_cast<int>(c)];
      return sum;
    };
    const double w = row(3);
    if (w < 1e-2) return {0, 0, width, height};
    for (std::size_t a = 0; a < 2; ++a) {
      const double pixel = (0.5 + 0.5 * row(a) / w) * (a == 0 ? width : height);
      low[a] = std::min(low[a], pixel);
      high[a] = std::max(high[a], pixel);
    }
  }
  const auto bounded = [](double v, int most) { return static_cast<int>(std::clamp(v, 0.0, 1.0 * most)); };
  const std::array<int, 4> r{
      bounded(std::floor(low[0] - margin), width), bounded(std::floor(low[1] - margin), height),
      bounded(std::ceil(high[0] + margin), width), bounded(std::ceil(high[1] + margin), height)};
  return r[0] < r[2] && r[1] < r[3] ? r : std::array<int, 4>{0, 0, 0, 0};
}

double distanceTo(const Box3d& box, Vec3d p) {
  const auto outside = [](double low, double v, double high) { return std::max({low - v, 0.0, v - high}); };
  return length(Vec3d{outside(box.min.x, p.x, box.max.x), outside(box.min.y, p.y, box.max.y),
                      outside(box.min.z, p.z, box.max.z)});
}

}  // namespace spin
