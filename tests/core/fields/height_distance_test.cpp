// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/height_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/fields/mesh_distance.h"
#include "core/fields/terrain_surface.h"

namespace spin {
namespace {

struct Heights {
  const float* heights;
  std::int32_t width, height;
  double originX, originY, cell;
};
Heights viewOf(const Raster<float>& r) {
  return {r.values.data(), r.width, r.height, r.originX, r.originY, r.cellSize};
}

/// Steps of one metre, up at 45 degrees on the whole: flat, one cell steep, flat.
Raster<float> steps() {
  Raster<float> r(24, 8, 0, 0, 0.25);
  for (int j = 0; j < r.height; ++j)
    for (int i = 0; i < r.width; ++i) r.at(i, j) = static_cast<float>(std::floor((i + 1) / 4.0));
  return r;
}

TriangleMesh meshOf(const Raster<float>& r) {
  TriangleMesh m;
  for (int j = 0; j < r.height; ++j)
    for (int i = 0; i < r.width; ++i)
      m.positions.push_back({r.x(i), r.y(j), static_cast<double>(r.at(i, j))});
  for (int j = 0; j + 1 < r.height; ++j)
    for (int i = 0; i + 1 < r.width; ++i) {
      const auto a = static_cast<std::uint32_t>(r.index(i, j)), b = a + 1,
                 c = a + static_cast<std::uint32_t>(r.width), d = c + 1;
      for (const std::uint32_t k : {a, b, d, a, d, c}) m.indices.push_back(k);
    }
  return m;
}

TEST(HeightDistanceTest, AtStepsItIsTheDistanceFromTheNearestFacet) {
  const Raster<float> ground = steps();
  const auto shells = makeMeshShells(meshOf(ground));
  ASSERT_TRUE(shells.ok());
  const ShellDistance exact(*shells, 0);
  const CounterRandom random{4, 4};
  const double reach = 0.25;
  int near = 0;
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Vec3d p{0.5 + 4.5 * random.uniformDouble(i, 0), 0.5 + 0.7 * random.uniformDouble(i, 1),
                  6.0 * random.uniformDouble(i, 2)};
    const double height = *TerrainSurface(ground).heightAt(p.x, p.y);
    HeightContact<double> contact;
    const bool found = nearestGround(viewOf(ground), p.x, p.y, p.z, reach, contact);
    const auto truth = exact.nearest(p - shells->origin, 1.06 * reach);
    if (p.z < height - reach) {
      ASSERT_TRUE(found) << "deep under the ground is solid";
      continue;
    }
    // What is nearly plane is taken for plane: near the reach both answers are right.
    if (truth && truth->distance > 0.94 * reach) continue;
    ASSERT_EQ(found, p.z < height || truth.has_value());
    if (!truth) continue;
    ++near;
    const double sign = p.z < height ? -1.0 : 1.0;
    worst = std::max(worst, std::abs(contact.distance - sign * truth->distance));
    const double size = std::sqrt(contact.normal.dot(contact.normal));
    ASSERT_NEAR(size, 1.0, 1e-9);
  }
  EXPECT_GT(near, 1000);
  EXPECT_LT(worst, 0.06 * reach);
}

TEST(HeightDistanceTest, OnAPlaneItIsThePlane) {
  Raster<float> ramp(8, 8, 0, 0, 1.0);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 8; ++i) ramp.at(i, j) = static_cast<float>(i);
  HeightContact<double> contact;
  ASSERT_TRUE(nearestGround(viewOf(ramp), 3.3, 2.1, 3.5, 0.5, contact));
  EXPECT_NEAR(contact.distance, 0.2 * std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(contact.normal.x, -std::sqrt(0.5), 1e-6);
  EXPECT_FALSE(nearestGround(viewOf(ramp), 3.3, 2.1, 4.5, 0.5, contact));
  EXPECT_FALSE(nearestGround(viewOf(ramp), -0.1, 2.1, 0.0, 0.5, contact)) << "beyond the rim";
}

TEST(HeightDistanceTest, HolesAreNoGround) {
  Raster<float> flat(6, 6, 0, 0, 1.0);
  flat.at(2, 2) = std::numeric_limits<float>::quiet_NaN();
  HeightContact<double> contact;
  EXPECT_FALSE(nearestGround(viewOf(flat), 2.0, 2.0, 0.1, 0.5, contact));
  EXPECT_TRUE(nearestGround(viewOf(flat), 4.0, 4.0, 0.1, 0.5, contact));
  ASSERT_TRUE(nearestGround(viewOf(flat), 2.9, 2.5, 0.1, 0.5, contact)) << "the rim of the hole is near";
  EXPECT_NEAR(contact.distance, std::hypot(0.1, 0.1), 1e-6);
}

}  // namespace
}  // namespace spin
