// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/flow/release_area.h"
#include "tests/core/flow/flow_test_scene.h"

namespace spin {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();

SceneNode releaseNode(const AvalancheReleaseNode& data) {
  SceneNode node = makeNode(kAvalancheReleaseType, "release", "Release");
  node.data = std::make_shared<AvalancheReleaseNode>(data);
  return node;
}

Raster<float> plane(double slopeX, double slopeY = 0.0) {
  Raster<float> land(61, 61, 0.0, 0.0, 0.5);
  for (int j = 0; j < 61; ++j)
    for (int i = 0; i < 61; ++i) land.at(i, j) = static_cast<float>(slopeX * land.x(i) + slopeY * land.y(j));
  return land;
}

double nearestPair(const std::vector<Vec3d>& points) {
  double nearest = 1e300;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      nearest = std::min(nearest, length(points[a] - points[b]));
  return nearest;
}

TEST(Outline, CrossesItselfOnlyWhereEdgesMeetApartFromCorners) {
  EXPECT_FALSE(selfCrossing({}));
  EXPECT_FALSE(selfCrossing({{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_FALSE(selfCrossing({{0, 0}, {4, 0}, {1, 1}, {0, 4}})) << "a dent is no crossing";
  const auto bow = selfCrossing({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
  ASSERT_TRUE(bow);
  EXPECT_EQ(bow->first, 0u);
  EXPECT_EQ(bow->second, 2u);
  EXPECT_TRUE(selfCrossing({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})) << "a corner on another edge";
}

TEST(ReleaseArea, OutlineAndPaintedCellsAddUp) {
  const Raster<float> land = plane(0.0);
  const FlowGround ground(&land);
  SceneNode node = releaseNode(test::squareRelease(2.0, 6.0, 1.0));
  TiledRaster<std::uint8_t> painted(61, 61, kReleaseUnpainted);
  painted.set(40, 40, kReleasePainted);
  node.painted = painted;
  const ReleaseArea area(node, ground);
  EXPECT_TRUE(area.contains(3.0, 5.0));
  EXPECT_FALSE(area.contains(6.5, 5.0));
  EXPECT_TRUE(area.contains(20.1, 19.9)) << "the painted cell";
  EXPECT_FALSE(area.contains(20.4, 20.0)) << "its neighbour";
  double square = 0.0;
  for (std::size_t k = 0; k < area.samples().size(); ++k) square += area.sampleSize() * area.sampleSize();
  EXPECT_NEAR(square, 16.0 + 0.25, 0.1);
}

TEST(ReleaseArea, WhatLiesOutsideTheTerrainOrOverHolesIsTold) {
  Raster<float> land = plane(0.2);
  for (int j = 0; j < 61; ++j)
    for (int i = 0; i < 8; ++i) land.at(i, j) = kHole;
  const FlowGround ground(&land);
  const SceneNode half = releaseNode(test::squareRelease(2.0, 6.0, 1.0));
  EXPECT_NEAR(ReleaseArea(half, ground).shareWithoutGround(), 0.5, 0.05);
  const SceneNode away = releaseNode(test::squareRelease(50.0, 60.0, 1.0));
  EXPECT_TRUE(ReleaseArea(away, ground).samples().empty());
}

/// Slope, depth and spacing.
class SlabOnSlope : public testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P(SlabOnSlope, HasItsVolumeAndKeepsItsDistances) {
  const auto [slope, depth, spacing] = GetParam();
  const Raster<float> land = plane(slope, 0.3 * slope);
  const FlowGround ground(&land);
  const SceneNode node = releaseNode(test::squareRelease(10.0, 20.0, depth));
  const ReleaseArea area(node, ground);
  const Slab slab = fillSlab(area, ground, depth, false, spacing);
  const double volume = 100.0 * std::sqrt(1.0 + 1.09 * slope * slope) * depth;
  const double filled = static_cast<double>(slab.positions.size()) * spacing * spacing * spacing;
  // The lattice meets the border within half a spacing.
  EXPECT_NEAR(filled / volume, 1.0, 0.5 * 4 * spacing / 10.0);
  EXPECT_NEAR(slabParticles(area, depth, false, spacing) / static_cast<double>(slab.positions.size()), 1.0,
              0.5 * 4 * spacing / 10.0);
  EXPECT_GT(nearestPair(slab.positions), 0.74 * spacing);
  for (const Vec3d& p : slab.positions) {
    const double above = (p.z - slope * p.x - 0.3 * slope * p.y) / std::sqrt(1.0 + 1.09 * slope * slope);
    EXPECT_GT(above, 0.25 * spacing);
    EXPECT_LT(above, depth);
  }
}
INSTANTIATE_TEST_SUITE_P(All, SlabOnSlope,
                         testing::Combine(testing::Values(0.0, 0.4, -1.0), testing::Values(1.0, 1.7),
                                          testing::Values(0.5, 0.6)));

TEST(Slab, VerticalDepthIsLessAlongTheNormal) {
  const Raster<float> land = plane(1.0);
  const FlowGround ground(&land);
  const SceneNode node = releaseNode(test::squareRelease(10.0, 20.0, 2.0));
  const ReleaseArea area(node, ground);
  EXPECT_NEAR(fillSlab(area, ground, 2.0, true, 0.5).depth, 2.0 * std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(fillSlab(area, ground, 2.0, false, 0.5).depth, 2.0, 1e-9);
}

TEST(Slab, FollowsRoughGroundWithoutOverlap) {
  Raster<float> land(61, 61, 0.0, 0.0, 0.5);
  for (int j = 0; j < 61; ++j)
    for (int i = 0; i < 61; ++i)
      land.at(i, j) =
          static_cast<float>(-0.6 * land.x(i) + 0.8 * std::sin(0.7 * land.x(i)) * std::cos(0.5 * land.y(j)));
  const FlowGround ground(&land);
  const SceneNode node = releaseNode(test::squareRelease(8.0, 22.0, 1.5));
  const ReleaseArea area(node, ground);
  const Slab slab = fillSlab(area, ground, 1.5, false, 0.5);
  EXPECT_EQ(slab.layers, 3);
  EXPECT_GT(slab.positions.size(), 14u * 14u * 3u * 4u);
  EXPECT_GT(nearestPair(slab.positions), 0.45);
  for (const Vec3d& p : slab.positions) EXPECT_GT(p.z - *ground.heightAt(p.x, p.y), 0.1);
}

TEST(Slab, LevelGroundServesWhereThereIsNoTerrain) {
  const FlowGround ground(nullptr);
  const SceneNode node = releaseNode(test::squareRelease(0.0, 4.0, 1.0));
  const Slab slab = fillSlab(ReleaseArea(node, ground), ground, 1.0, false, 0.25);
  EXPECT_EQ(slab.layers, 4);
  EXPECT_EQ(slab.positions.size(), 16u * 16u * 4u);
}

}  // namespace
}  // namespace spin
