// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/raycast/embree_ray_scene.h"
#include "tests/core/raycast/ray_scene_cases.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

TEST(EmbreeRayScene, NoRayLeaks) {
  EXPECT_EQ(test::leaksOfBall(*makeEmbreeRayScene(), 1000000, false), 0);
  // Embree's robust mode lets a few of the rays pass that are aimed at a corner to the last bit.
  EXPECT_LE(test::leaksOfBall(*makeEmbreeRayScene(), 1000000, true), 1000);
  EXPECT_EQ(test::leaksOfField(*makeEmbreeRayScene(), 1000000), 0);
}

/// Random triangles in a cube: both casters must give the same hits but for rays that graze an edge.
TEST(EmbreeRayScene, AgreesWithTheBuiltInHierarchy) {
  const CounterRandom random{5, 2};
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
  for (std::uint64_t k = 0; k < 3 * 400; ++k) {
    const UInt4 w = random.words(k), centre = random.words(k / 3, 4);
    const auto at = [](std::uint32_t big, std::uint32_t small) {
      return 10 * toUnitFloat(big) + 2 * toUnitFloat(small);
    };
    positions.push_back({at(centre.x, w.x), at(centre.y, w.y), at(centre.z, w.z)});
    indices.push_back(static_cast<std::uint32_t>(k));
  }
  const auto embree = makeEmbreeRayScene(), bvh = makeBvhRayScene();
  for (RayScene* scene : {embree.get(), bvh.get()}) {
    EXPECT_EQ(scene->addTriangles(positions, indices), 0u);
    scene->commit();
  }
  int hits = 0, different = 0;
  std::vector<Ray> rays;
  for (std::uint64_t k = 0; k < 50000; ++k) {
    const UInt4 w = random.words(k, 7);
    rays.push_back({{12 * toUnitFloat(w.x), 12 * toUnitFloat(w.y), 12 * toUnitFloat(w.z)},
                    test::randomDirection(random, k)});
    const auto a = embree->closest(rays.back()), b = bvh->closest(rays.back());
    hits += a ? 1 : 0;
    const bool same = a.has_value() == b.has_value() &&
                      (!a || (std::abs(a->t - b->t) < 1e-4f && (a->triangle == b->triangle || a->t == b->t)));
    different += same ? 0 : 1;
    EXPECT_EQ(embree->occluded(rays.back()), a.has_value());
    EXPECT_EQ(bvh->occluded(rays.back()), b.has_value());
  }
  EXPECT_GT(hits, 10000);
  EXPECT_LE(different, 3);
  std::vector<std::uint8_t> packet(rays.size());
  embree->occludedMany(rays.data(), rays.size() - 5, packet.data());  // the last packet is not full
  int packetDifferent = 0;
  for (std::size_t k = 0; k + 5 < rays.size(); ++k)
    packetDifferent += (packet[k] != 0) == embree->occluded(rays[k]) ? 0 : 1;
  EXPECT_LE(packetDifferent, 3);
}

TEST(EmbreeRayScene, CancelEndsTheBuildSoon) {
  const test::CancelledBuild build = test::cancelledBuild(*makeEmbreeRayScene());
  EXPECT_FALSE(build.done);
  EXPECT_LT(build.seconds, 1.0 * test::patience());
}

TEST(EmbreeRayScene, EmptySceneAndEmptyMeshHideNothing) {
  const auto scene = makeEmbreeRayScene();
  scene->addTriangles({}, {});
  scene->commit();
  EXPECT_FALSE(scene->occluded({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_STREQ(scene->name(), "embree");
}

}  // namespace
}  // namespace spin
