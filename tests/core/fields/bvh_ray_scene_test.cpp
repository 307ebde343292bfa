// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/fields/layered_ray_scene.h"
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

TEST(LayeredRayScene, AnswersAsOneSceneOfBoth) {
  const test::Soup land = test::field(40), ball = test::ball(12, 4.0f);
  const auto whole = makeBvhRayScene();
  std::shared_ptr<RayScene> lower = makeBvhRayScene();
  for (RayScene* scene : {whole.get(), lower.get()}) scene->addTriangles(land.positions, land.indices);
  lower->commit();
  const auto both = makeLayeredRayScene(lower, 1, makeBvhRayScene());
  for (RayScene* scene : {whole.get(), both.get()}) {
    EXPECT_EQ(scene->addTriangles(ball.positions, ball.indices), 1u);
    scene->commit();
  }
  const CounterRandom random{7, 1};
  std::vector<Ray> rays;
  for (std::uint64_t k = 0; k < 4000; ++k) {
    const UInt4 w = random.words(k, 1);
    rays.push_back({{40.0f * toUnitFloat(w.x) - 20.0f, 40.0f * toUnitFloat(w.y) - 20.0f,
                     12.0f * toUnitFloat(w.z) - 2.0f},
                    test::randomDirection(random, k)});
  }
  std::vector<std::uint8_t> blocked(rays.size());
  both->occludedMany(rays.data(), rays.size(), blocked.data());
  std::size_t hits[2] = {0, 0};
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const auto a = whole->closest(rays[k]), b = both->closest(rays[k]);
    ASSERT_EQ(a.has_value(), b.has_value()) << k;
    EXPECT_EQ(whole->occluded(rays[k]), both->occluded(rays[k]));
    EXPECT_EQ(blocked[k] != 0, a.has_value());
    if (!a) continue;
    EXPECT_EQ(a->t, b->t);
    EXPECT_EQ(a->geometry, b->geometry);
    EXPECT_EQ(a->triangle, b->triangle);
    ++hits[a->geometry];
  }
  EXPECT_GT(hits[0], 100u);
  EXPECT_GT(hits[1], 50u);
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
