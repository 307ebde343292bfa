// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "core/fields/mesh.h"
#include "core/fields/particles.h"
#include "core/fields/raster.h"
#include "core/fields/tiled_raster.h"

namespace spin {
namespace {

TEST(RasterTest, RowsRunNorthAndColumnsEast) {
  Raster<int> raster(3, 2, 100.0, 200.0, 5.0, 7);
  raster.at(2, 1) = 9;
  EXPECT_EQ(raster.values[5], 9);
  EXPECT_EQ(raster.x(2), 110.0);
  EXPECT_EQ(raster.y(1), 205.0);
  EXPECT_EQ(raster.column(112.4), 2);
  EXPECT_EQ(raster.column(112.6), 3);
  EXPECT_EQ(raster.row(197.0), -1);
}

TEST(RasterTest, ContainsOnlyItsCells) {
  const Raster<float> raster(3, 2, 0, 0, 1);
  EXPECT_TRUE(raster.contains(0, 0));
  EXPECT_TRUE(raster.contains(2, 1));
  EXPECT_FALSE(raster.contains(3, 0));
  EXPECT_FALSE(raster.contains(0, 2));
  EXPECT_FALSE(raster.contains(-1, 0));
  EXPECT_TRUE((Raster<float>().empty()));
}

TEST(RasterTest, SameShapeCopiesPlaceAndSize) {
  const Raster<float> raster(3, 2, 1.5, -2.5, 0.5);
  const auto other = raster.sameShape<std::uint8_t>(4);
  EXPECT_TRUE(raster.hasShapeOf(other));
  EXPECT_EQ(other.values, std::vector<std::uint8_t>(6, 4));
  Raster<float> moved = raster;
  moved.originX += 1;
  EXPECT_FALSE(raster.hasShapeOf(moved));
}

TEST(TiledRasterTest, SharesTilesUntilOneIsWritten) {
  TiledRaster<std::uint8_t> a(130, 70, 1);
  EXPECT_EQ(a.tileCount(), 6u);
  a.set(0, 0, 2);
  TiledRaster<std::uint8_t> b = a;
  for (std::size_t t = 0; t < a.tileCount(); ++t) EXPECT_EQ(a.tile(t), b.tile(t));
  b.set(65, 3, 9);
  EXPECT_EQ(a.at(65, 3), 1);
  EXPECT_EQ(b.at(65, 3), 9);
  for (std::size_t t = 0; t < a.tileCount(); ++t)
    EXPECT_EQ(a.tile(t) == b.tile(t), t != a.tileIndex(65, 3)) << t;
}

TEST(TiledRasterTest, UnpaintedCellsAreEqualThoughTheyHoldNaN) {
  const float none = std::nanf("");
  TiledRaster<float> a(130, 70, none), b(130, 70, none);
  a.set(3, 3, none);
  EXPECT_EQ(a.tile(0), a.tile(1)) << "nothing was written";
  EXPECT_TRUE(a == b);
  a.set(3, 3, 270.0f);
  EXPECT_FALSE(a == b);
}

TEST(TiledRasterTest, TilesOfOneRasterDoNotShareWrites) {
  // All tiles start as one and the same.
  TiledRaster<int> a(128, 128, 0);
  a.set(0, 0, 5);
  EXPECT_EQ(a.at(64, 0), 0);
  EXPECT_EQ(a.at(0, 64), 0);
  EXPECT_EQ(a.at(64, 64), 0);
}

TEST(TiledRasterTest, WritingTheSameValueCopiesNothing) {
  TiledRaster<int> a(64, 64, 3);
  TiledRaster<int> b = a;
  b.set(1, 1, 3);
  EXPECT_EQ(a.tile(0), b.tile(0));
}

TEST(TiledRasterTest, EqualityComparesValuesNotPointers) {
  TiledRaster<int> a(100, 100, 0), b(100, 100, 0);
  EXPECT_TRUE(a == b);
  b.set(99, 99, 1);
  EXPECT_FALSE(a == b);
  b.set(99, 99, 0);
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a == (TiledRaster<int>(100, 99, 0)));
}

TEST(TiledRasterTest, SetTileRestoresAnOldState) {
  TiledRaster<int> a(64, 64, 0);
  const auto before = a.tile(0);
  a.set(3, 4, 8);
  a.setTile(0, before);
  EXPECT_EQ(a.at(3, 4), 0);
}

ModelData twoInstances() {
  ModelData model;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  mesh.indices = {0, 1, 2};
  model.meshes = {mesh};
  model.instances = {{0, Transform{}}, {0, translationOf({10, 0, 5})}};
  return model;
}

TEST(ModelDataTest, BoundsAndTrianglesCountEveryInstance) {
  const ModelData model = twoInstances();
  EXPECT_EQ(model.triangleCount(), 2u);
  const Box3d box = model.bounds();
  EXPECT_EQ(box.min, (Vec3d{0, 0, 0}));
  EXPECT_EQ(box.max, (Vec3d{11, 2, 5}));
  EXPECT_TRUE(ModelData{}.bounds().empty());
}

TEST(ParticleSetTest, FindsAttributesByName) {
  ParticleSet set;
  set.positions.resize(2);
  set.attributes = {{"velocity", "m/s", 3, {1, 2, 3, 4, 5, 6}}};
  ASSERT_NE(set.find("velocity"), nullptr);
  EXPECT_EQ(set.find("velocity")->components, 3);
  EXPECT_EQ(set.find("mass"), nullptr);
  EXPECT_EQ(set.size(), 2u);
}

TEST(WrapTest, NearestCopyLiesWithinHalfAPeriod) {
  const Vec3d centre{1003.0, -57.0, 12.0};
  for (const Vec3d p : {Vec3d{0, 0, 0}, Vec3d{9.9, 0.1, 5}, Vec3d{3, 3, 3}}) {
    const Vec3d copy = wrapAround(p, centre, 10.0);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(std::abs(copy[axis] - centre[axis]), 5.0);
      const double periods = (copy[axis] - p[axis]) / 10.0;
      EXPECT_NEAR(periods, std::round(periods), 1e-12);
    }
  }
}

}  // namespace
}  // namespace spin
