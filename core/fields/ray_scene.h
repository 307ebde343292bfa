// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/cancel.h"
#include "core/math/vec.h"

namespace spin {

/// One ray, local metres; hits count in (tMin, tMax).
struct Ray {
  Vec3f origin{};
  Vec3f direction{};
  float tMin = 0.0f;
  float tMax = std::numeric_limits<float>::infinity();
};

struct RayHit {
  float t = 0.0f;
  std::uint32_t geometry = 0;  ///< what addTriangles returned
  std::uint32_t triangle = 0;  ///< index within the geometry
};

/// Static triangles that rays are cast against. Add, commit once, then query from any thread.
class RayScene {
 public:
  virtual ~RayScene() = default;
  /// Copies the triangles; indices 3 per triangle. Both sides count. Returns the geometry's number, from 0
  /// up.
  virtual std::uint32_t addTriangles(const std::vector<Vec3f>& positions,
                                     const std::vector<std::uint32_t>& indices) = 0;
  /// False when cancelled before it was done; then only destruction is allowed.
  virtual bool commit(const CancelToken& cancel = {}) = 0;
  virtual bool occluded(const Ray& ray) const = 0;
  /// occluded() of many rays; faster where neighbours in the list are alike. blocked[i] becomes 0 or 1.
  virtual void occludedMany(const Ray* rays, std::size_t count, std::uint8_t* blocked) const {
    for (std::size_t i = 0; i < count; ++i) blocked[i] = occluded(rays[i]) ? 1 : 0;
  }
  virtual std::optional<RayHit> closest(const Ray& ray) const = 0;
  /// For messages and provenance: "embree" or "bvh".
  virtual const char* name() const = 0;
};

using RaySceneFactory = std::function<std::unique_ptr<RayScene>()>;

/// The built-in bounding-volume hierarchy (no dependency; slower than Embree).
std::unique_ptr<RayScene> makeBvhRayScene();

}  // namespace spin
