// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/math/transform.h"

#include <gtest/gtest.h>

#include <limits>

namespace spin {
namespace {

void expectNear(Vec3d a, Vec3d b, double tolerance = 1e-12) {
  EXPECT_LT(length(a - b), tolerance)
      << a.x << " " << a.y << " " << a.z << " against " << b.x << " " << b.y << " " << b.z;
}

TEST(VecTest, CrossFollowsTheRightHand) {
  EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1}));
  EXPECT_EQ(dot(Vec3d{1, 2, 3}, Vec3d{4, 5, 6}), 32.0);
  EXPECT_EQ((Vec3d{7, 8, 9}[1]), 8.0);
}

TEST(VecTest, ZeroHasNoDirectionAndStaysZero) {
  EXPECT_EQ(normalized(Vec3d{}), Vec3d{});
  EXPECT_NEAR(length(normalized(Vec3d{3, -4, 12})), 1.0, 1e-15);
}

TEST(VecTest, FiniteMeansAllThree) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isFinite(Vec3d{1, 2, 3}));
  EXPECT_FALSE(isFinite(Vec3d{nan, 0, 0}));
  EXPECT_FALSE(isFinite(Vec3d{0, inf, 0}));
  EXPECT_FALSE(isFinite(Vec3d{0, 0, -inf}));
}

TEST(BoxTest, GrowsFromNothing) {
  Box3d box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.size(), Vec3d{});
  box.extend(Vec3d{1, 2, 3});
  EXPECT_FALSE(box.empty());
  box.extend(Vec3d{-1, 4, 3});
  EXPECT_EQ(box.size(), (Vec3d{2, 2, 0}));
  EXPECT_EQ(box.centre(), (Vec3d{0, 3, 3}));
  Box3d other = box;
  other.extend(Box3d{});
  EXPECT_EQ(other.min, box.min);
}

TEST(TransformTest, RotatesAboutXThenYThenZ) {
  expectNear(rotationOfDegrees({0, 0, 90}).point({1, 0, 0}), {0, 1, 0});
  expectNear(rotationOfDegrees({90, 0, 0}).point({0, 1, 0}), {0, 0, 1});
  expectNear(rotationOfDegrees({0, 90, 0}).point({0, 0, 1}), {1, 0, 0});
  // z to -y about x, then -y to x about z.
  expectNear(rotationOfDegrees({90, 0, 90}).point({0, 0, 1}), {1, 0, 0});
}

TEST(TransformTest, ProductAppliesTheRightOneFirst) {
  const Transform t = translationOf({10, 0, 0}) * scalingOf({2, 3, 4});
  expectNear(t.point({1, 1, 1}), {12, 3, 4});
  expectNear(t.vector({1, 1, 1}), {2, 3, 4});
}

TEST(TransformTest, InverseUndoes) {
  const Transform t = translationOf({1, -2, 3}) * rotationOfDegrees({20, -35, 70}) * scalingOf({2, -0.5, 3});
  const Vec3d p{0.3, 4, -5};
  expectNear(t.inverse().point(t.point(p)), p);
  expectNear((t * t.inverse()).point(p), p);
  EXPECT_NEAR(t.determinant(), -3.0, 1e-12);
}

TEST(TransformTest, NormalsStayPerpendicularUnderUnevenScaling) {
  const Transform t = rotationOfDegrees({10, 20, 30}) * scalingOf({1, 5, 0.2});
  const Vec3d a{1, 2, 0.5}, b{-1, 0.3, 2};
  const Vec3d n = t.normal(cross(a, b));
  EXPECT_NEAR(dot(n, t.vector(a)), 0.0, 1e-12);
  EXPECT_NEAR(dot(n, t.vector(b)), 0.0, 1e-12);
  EXPECT_GT(dot(n, cross(t.vector(a), t.vector(b))), 0.0);
}

TEST(TransformTest, ColumnMajorHoldsTheTranslationLast) {
  const auto m = (translationOf({7, 8, 9}) * rotationOfDegrees({0, 0, 90})).toColumnMajor();
  EXPECT_FLOAT_EQ(m[12], 7.0f);
  EXPECT_FLOAT_EQ(m[14], 9.0f);
  EXPECT_FLOAT_EQ(m[15], 1.0f);
  EXPECT_FLOAT_EQ(m[1], 1.0f);   // the first column is where x goes: to y
  EXPECT_FLOAT_EQ(m[4], -1.0f);  // the second where y goes: to -x
}

TEST(TransformDeathTest, SingularHasNoInverse) {
  EXPECT_DEATH(scalingOf({1, 0, 1}).inverse(), "singular");
}

}  // namespace
}  // namespace spin
