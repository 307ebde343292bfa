// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/fields/ray_scene.h"
#include "tests/core/raycast/ray_scene_cases.h"
#include "tests/support/time_limit.h"

namespace spin {
namespace {

TEST(BvhRayScene, NoRayLeaksOutOfAClosedBall) {
  EXPECT_EQ(test::leaksOfBall(*makeBvhRayScene(), 500000, false), 0);
  EXPECT_EQ(test::leaksOfBall(*makeBvhRayScene(), 500000, true), 0);
}

TEST(BvhRayScene, NoRayLeaksThroughAHeightField) {
  EXPECT_EQ(test::leaksOfField(*makeBvhRayScene(), 1000000), 0);
}

TEST(BvhRayScene, EmptySceneHidesNothing) {
  const auto scene = makeBvhRayScene();
  scene->commit();
  EXPECT_FALSE(scene->occluded({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene->closest({{0, 0, 0}, {0, 0, 1}}).has_value());
}

TEST(BvhRayScene, FindsTheClosestOfSeveralAndItsNumber) {
  const auto scene = makeBvhRayScene();
  for (const float z : {5.0f, 2.0f, 9.0f})
    scene->addTriangles({{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}}, {0, 1, 2, 0, 2, 3});
  scene->commit();
  const auto hit = scene->closest({{-0.5f, 0.5f, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit.has_value());
  EXPECT_FLOAT_EQ(hit->t, 2.0f);
  EXPECT_EQ(hit->geometry, 1u);
  EXPECT_EQ(hit->triangle, 1u);
  // From behind the nearest, and with limits on both ends.
  EXPECT_FLOAT_EQ(scene->closest({{0.5f, 0, 3}, {0, 0, 1}})->t, 2.0f);
  EXPECT_FALSE(scene->occluded({{0.5f, 0, 0}, {0, 0, 1}, 0.0f, 1.9f}));
  EXPECT_FALSE(scene->occluded({{0.5f, 0, 0}, {0, 0, 1}, 9.5f, 100.0f}));
  EXPECT_TRUE(scene->occluded({{0.5f, 0, 10}, {0, 0, -1}}));
  EXPECT_FALSE(scene->occluded({{0.5f, 0, 10}, {0, 0, 1}}));
}

TEST(BvhRayScene, CancelEndsTheBuildSoon) {
  const test::CancelledBuild build = test::cancelledBuild(*makeBvhRayScene());
  EXPECT_FALSE(build.done);
  EXPECT_LT(build.seconds, 1.0 * test::patience());
}

TEST(BvhRayScene, ManyTrianglesInOnePlaceStillBuild) {
  const auto scene = makeBvhRayScene();
  std::vector<Vec3f> positions;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t k = 0; k < 3 * 5000; ++k) {
    positions.push_back({k % 3 == 1 ? 1.0f : 0.0f, k % 3 == 2 ? 1.0f : 0.0f, 1.0f});
    indices.push_back(k);
  }
  scene->addTriangles(positions, indices);
  scene->commit();
  EXPECT_TRUE(scene->occluded({{0.2f, 0.2f, 0}, {0, 0, 1}}));
  EXPECT_FALSE(scene->occluded({{0.8f, 0.8f, 0}, {0, 0, 1}}));
}

}  // namespace
}  // namespace spin
