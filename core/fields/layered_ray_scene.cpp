// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/layered_ray_scene.h"

#include <algorithm>
#include <array>

namespace spin {
namespace {

constexpr std::size_t kBatch = 64;

class LayeredRayScene final : public RayScene {
 public:
  LayeredRayScene(std::shared_ptr<const RayScene> lower, std::uint32_t lowerCount,
                  std::unique_ptr<RayScene> upper)
      : m_lower(std::move(lower)), m_upper(std::move(upper)), m_lowerCount(lowerCount) {}

  std::uint32_t addTriangles(const std::vector<Vec3f>& positions,
                             const std::vector<std::uint32_t>& indices) override {
    return m_lowerCount + m_upper->addTriangles(positions, indices);
  }
  bool commit(const CancelToken& cancel) override { return m_upper->commit(cancel); }
  bool occluded(const Ray& ray) const override { return m_upper->occluded(ray) || m_lower->occluded(ray); }

  void occludedMany(const Ray* rays, std::size_t count, std::uint8_t* blocked) const override {
    m_lower->occludedMany(rays, count, blocked);
    std::array<Ray, kBatch> free;
    std::array<std::size_t, kBatch> number;
    std::array<std::uint8_t, kBatch> found;
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
      std::size_t left = 0;
      for (std::size_t k = begin; k < std::min(count, begin + kBatch); ++k)
        if (!blocked[k]) free[left] = rays[k], number[left++] = k;
      m_upper->occludedMany(free.data(), left, found.data());
      for (std::size_t k = 0; k < left; ++k) blocked[number[k]] = found[k];
    }
  }

  std::optional<RayHit> closest(const Ray& ray) const override {
    const std::optional<RayHit> below = m_lower->closest(ray);
    Ray rest = ray;
    if (below) rest.tMax = below->t;
    std::optional<RayHit> above = m_upper->closest(rest);
    if (!above) return below;
    above->geometry += m_lowerCount;
    return above;
  }
  const char* name() const override { return m_lower->name(); }

 private:
  std::shared_ptr<const RayScene> m_lower;
  std::unique_ptr<RayScene> m_upper;
  std::uint32_t m_lowerCount;
};

}  // namespace

std::unique_ptr<RayScene> makeLayeredRayScene(std::shared_ptr<const RayScene> lower, std::uint32_t lowerCount,
                                              std::unique_ptr<RayScene> upper) {
  return std::make_unique<LayeredRayScene>(std::move(lower), lowerCount, std::move(upper));
}

}  // namespace spin
