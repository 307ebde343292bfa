// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/draw_context.h"

#include <algorithm>

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

double distanceTo(const Box3d& box, Vec3d p) {
  const auto outside = [](double low, double v, double high) { return std::max({low - v, 0.0, v - high}); };
  return length(Vec3d{outside(box.min.x, p.x, box.max.x), outside(box.min.y, p.y, box.max.y),
                      outside(box.min.z, p.z, box.max.z)});
}

}  // namespace spin
