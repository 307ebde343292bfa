// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "core/base/random.h"
#include "core/fields/ray_scene.h"

namespace spin::test {

struct Soup {
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
};

/// A closed ball of triangles with shared corners.
inline Soup ball(int rings, float radius) {
  Soup soup;
  const int segments = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const double a = 3.14159265358979 * r / rings, b = 2 * 3.14159265358979 * s / segments;
      // The poles must coincide exactly, sin(pi) does not give 0.
      const double ring = r == 0 || r == rings ? 0.0 : std::sin(a);
      soup.positions.push_back({radius * float(ring * std::cos(b)), radius * float(ring * std::sin(b)),
                                radius * float(std::cos(a))});
    }
  for (int r = 0; r < rings; ++r)
    for (int s = 0; s < segments; ++s) {
      const auto at = [&](int i, int j) { return std::uint32_t(i * segments + j % segments); };
      soup.indices.insert(soup.indices.end(), {at(r, s), at(r + 1, s), at(r + 1, s + 1), at(r, s),
                                               at(r + 1, s + 1), at(r, s + 1)});
    }
  return soup;
}

/// A bumpy height field of n x n points, 1 m apart, about the origin.
inline Soup field(int n) {
  Soup soup;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      soup.positions.push_back({float(i - n / 2), float(j - n / 2),
                                3.0f * std::sin(0.37f * float(i)) * std::cos(0.21f * float(j))});
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < n; ++i) {
      const auto a = std::uint32_t(j * n + i), b = a + 1, c = a + std::uint32_t(n) + 1,
                 d = a + std::uint32_t(n);
      soup.indices.insert(soup.indices.end(), {a, b, c, a, c, d});
    }
  return soup;
}

inline Vec3f randomDirection(const CounterRandom& random, std::uint64_t k) {
  const UInt4 w = random.words(k, 9);
  const float z = 2.0f * toUnitFloat(w.x) - 1.0f, turn = 6.2831853f * toUnitFloat(w.y);
  const float r = std::sqrt(std::max(0.0f, 1.0f - z * z));
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Rays from inside a closed ball that get out: in random directions, or aimed at corners and at the middles
/// of edges, where leaks would be.
inline int leaksOfBall(RayScene& scene, int rays, bool aimed) {
  const Soup soup = ball(24, 100.0f);
  scene.addTriangles(soup.positions, soup.indices);
  scene.commit();
  const CounterRandom random{17, 1};
  int leaks = 0;
  for (int k = 0; k < rays; ++k) {
    const auto index = static_cast<std::uint64_t>(k);
    const UInt4 w = random.words(index);
    Ray ray;
    ray.origin = {80 * (toUnitFloat(w.x) - 0.5f), 80 * (toUnitFloat(w.y) - 0.5f),
                  80 * (toUnitFloat(w.z) - 0.5f)};
    ray.direction = randomDirection(random, index);
    const auto corner = [&](std::uint32_t i) {
      return soup.positions[soup.indices[i % soup.indices.size()]];
    };
    if (aimed && k % 2 == 0) ray.direction = normalized(corner(w.w) - ray.origin);
    if (aimed && k % 2 == 1)
      ray.direction = normalized((corner(w.w / 3 * 3) + corner(w.w / 3 * 3 + 1)) * 0.5f - ray.origin);
    leaks += scene.occluded(ray) ? 0 : 1;
  }
  return leaks;
}

/// A large field's hierarchy, cancelled a moment after its start: whether it noticed, and how soon.
struct CancelledBuild {
  bool done = true;
  double seconds = 0.0;  ///< from the cancel to the end
};
inline CancelledBuild cancelledBuild(RayScene& scene) {
  const Soup soup = field(1200);
  scene.addTriangles(soup.positions, soup.indices);
  using Clock = std::chrono::steady_clock;
  const CancelToken cancel;
  Clock::time_point asked;
  std::thread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    asked = Clock::now();
    cancel.cancel();
  });
  CancelledBuild build;
  build.done = scene.commit(cancel);
  const auto ended = Clock::now();
  stopper.join();
  build.seconds = std::chrono::duration<double>(ended - asked).count();
  return build;
}

/// Vertical and slanting rays at the field's interior, a third straight through its corners.
inline int leaksOfField(RayScene& scene, int rays) {
  const Soup soup = field(65);
  scene.addTriangles(soup.positions, soup.indices);
  scene.commit();
  const CounterRandom random{18, 1};
  int leaks = 0;
  for (int k = 0; k < rays; ++k) {
    const UInt4 w = random.words(static_cast<std::uint64_t>(k));
    Vec3f target{20 * (toUnitFloat(w.x) - 0.5f), 20 * (toUnitFloat(w.y) - 0.5f), 0};
    if (k % 3 == 0) target = {std::round(target.x), std::round(target.y), 0};
    Ray ray;
    ray.direction = normalized(Vec3f{0.4f * (toUnitFloat(w.z) - 0.5f), 0.4f * (toUnitFloat(w.w) - 0.5f), -1});
    if (k % 2 == 0) ray.direction = {0, 0, -1};
    ray.origin = target - ray.direction * 50.0f;
    leaks += scene.occluded(ray) ? 0 : 1;
  }
  return leaks;
}

}  // namespace spin::test
