// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "core/base/check.h"
#include "core/fields/ray_scene.h"
#include "core/fields/triangle_bvh.h"

namespace spin {
namespace {

/// What a ray needs for the watertight test (Woop, Benthin and Wald 2013): the axis along which it runs
/// longest becomes z, and a shear makes it run exactly along z, so that edges are decided alike from both
/// sides.
struct ShearedRay {
  Vec3f origin, inverse;
  int kx, ky, kz;
  float sx, sy, sz;

  explicit ShearedRay(const Ray& ray) : origin(ray.origin) {
    const Vec3f d = ray.direction;
    const Vec3f a{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    if (d[kz] < 0.0f) std::swap(kx, ky);
    sx = d[kx] / d[kz];
    sy = d[ky] / d[kz];
    sz = 1.0f / d[kz];
    inverse = {1.0f / d.x, 1.0f / d.y, 1.0f / d.z};
  }
};

/// Ray parameter of the crossing in (tMin, tMax), or a negative number.
float intersect(const ShearedRay& ray, const BvhTriangle& triangle, float tMin, float tMax) {
  const Vec3f a = triangle.corners[0] - ray.origin, b = triangle.corners[1] - ray.origin,
              c = triangle.corners[2] - ray.origin;
  // Products of two floats are exact in double, so both triangles of an edge see the same sign.
  const auto shearX = [&ray](Vec3f p) { return static_cast<double>(p[ray.kx] - ray.sx * p[ray.kz]); };
  const auto shearY = [&ray](Vec3f p) { return static_cast<double>(p[ray.ky] - ray.sy * p[ray.kz]); };
  const double ax = shearX(a), bx = shearX(b), cx = shearX(c);
  const double ay = shearY(a), by = shearY(b), cy = shearY(c);
  const double u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
  if ((u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0)) return -1.0f;
  const double det = u + v + w;
  if (det == 0.0) return -1.0f;
  const Vec3d z = Vec3f{a[ray.kz], b[ray.kz], c[ray.kz]}.to<double>();
  const double t = static_cast<double>(ray.sz) * dot(Vec3d{u, v, w}, z) / det;
  return t > static_cast<double>(tMin) && t < static_cast<double>(tMax) ? static_cast<float>(t) : -1.0f;
}

/// Slab test that never misses: the far distance is widened by the rounding of the products (Ize 2013). A
/// ray that runs in a slab's face gives NaN there, which min and max below skip.
bool meets(const ShearedRay& ray, const BvhNode& node, float tMin, float tMax) {
  constexpr float kWiden = 1.0f + 4.0f * 0x1p-23f;
  float near = tMin, far = tMax;
  for (int axis = 0; axis < 3; ++axis) {
    const float t0 = (node.low[axis] - ray.origin[axis]) * ray.inverse[axis];
    const float t1 = (node.high[axis] - ray.origin[axis]) * ray.inverse[axis];
    if (std::isnan(t0) || std::isnan(t1)) continue;
    near = std::max(near, std::min(t0, t1));
    far = std::min(far, std::max(t0, t1) * kWiden);
  }
  return near <= far;
}

class BvhRayScene final : public RayScene {
 public:
  std::uint32_t addTriangles(const std::vector<Vec3f>& positions,
                             const std::vector<std::uint32_t>& indices) override {
    SPIN_CHECK(indices.size() % 3 == 0, "indices come in threes");
    m_pending.reserve(m_pending.size() + indices.size() / 3);
    for (std::size_t t = 0; t < indices.size() / 3; ++t)
      m_pending.push_back(
          {{positions[indices[3 * t]], positions[indices[3 * t + 1]], positions[indices[3 * t + 2]]},
           m_geometries,
           static_cast<std::uint32_t>(t)});
    return m_geometries++;
  }
  bool commit(const CancelToken& cancel) override {
    const bool whole = m_bvh.build(std::move(m_pending), cancel);
    m_pending.clear();
    return whole;
  }
  bool occluded(const Ray& ray) const override {
    bool hit = false;
    traverse(ray, [&](float, const BvhTriangle&) { return hit = true; });
    return hit;
  }
  std::optional<RayHit> closest(const Ray& ray) const override {
    std::optional<RayHit> best;
    traverse(ray, [&](float t, const BvhTriangle& triangle) {
      best = RayHit{t, triangle.geometry, triangle.triangle};
      return false;
    });
    return best;
  }
  const char* name() const override { return "bvh"; }

 private:
  /// Calls found(t, triangle) for hits, each nearer than the last; stops when it returns true.
  template <class Found>
  void traverse(const Ray& ray, const Found& found) const {
    if (m_bvh.nodes().empty()) return;
    const ShearedRay sheared(ray);
    float tMax = ray.tMax;
    // A tree of up to 2^31 triangles that is halved at worst never comes near this depth unless centres
    // coincide, and then too it is halved.
    std::uint32_t stack[512];
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
      const BvhNode& node = m_bvh.nodes()[stack[--height]];
      if (!meets(sheared, node, ray.tMin, tMax)) continue;
      if (node.count == 0) {
        SPIN_CHECK(height + 2 <= std::size(stack), "the tree is too deep");
        stack[height++] = node.first;
        stack[height++] = node.first + 1;
        continue;
      }
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        const BvhTriangle& triangle = m_bvh.triangles()[k];
        const float t = intersect(sheared, triangle, ray.tMin, tMax);
        if (t < 0.0f) continue;
        if (found(t, triangle)) return;
        tMax = t;
      }
    }
  }

  TriangleBvh m_bvh;
  std::vector<BvhTriangle> m_pending;
  std::uint32_t m_geometries = 0;
};

}  // namespace

std::unique_ptr<RayScene> makeBvhRayScene() {
  return std::make_unique<BvhRayScene>();
}

}  // namespace spin
