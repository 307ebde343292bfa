// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/occlusion_map.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/snow/exposure_field.h"
#include "core/snow/map_raster_impl.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::boxMesh;
using test::modelOf;
using test::sheetMesh;
using test::TestScene;

struct Drawn {
  SceneSnapshot snapshot;
  SnowGroundPointer ground;
  SnowScene scene;

  explicit Drawn(SceneSnapshot s) : snapshot(std::move(s)), ground(makeSnowGround(snapshot)) {
    scene = std::move(*makeSnowScene(snapshot, *ground, 0.0, makeBvhRayScene));
  }
  OcclusionMap map(Vec3d fall, double texel, int threads = 2) const {
    CpuBackend backend(threads);
    std::vector<Vec3d> corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back(Vec3d{k & 1 ? scene.domain.max.x : scene.domain.min.x,
                              k & 2 ? scene.domain.max.y : scene.domain.min.y,
                              k & 4 ? scene.domain.max.z : scene.domain.min.z} -
                        scene.centre);
    return OcclusionMap(Occluders(snapshot, scene), MapView::round(corners, normalized(fall), texel, 4096),
                        backend);
  }
};

TestScene hutOnSlope() {
  TestScene test;
  ModelNode placed;
  placed.position = {20.0, 20.0, 0.0};
  test.land(21, 21, 2.0, [](double x, double y) { return 0.3 * x + 0.1 * y; });
  test.model("hut", modelOf(boxMesh({-3, -3, 0}, {3, 3, 5})), placed);
  return test;
}

TEST(OcclusionMap, AgreesWithRaysAwayFromEdges) {
  const Drawn drawn(hutOnSlope().build());
  const Vec3d fall = normalized(Vec3d{0.5, 0.2, -1.0});
  const OcclusionMap map = drawn.map(fall, 0.1);
  const TerrainSurface surface(drawn.snapshot.terrain->heights);
  const Vec3d normal = normalized(Vec3d{-0.3, -0.1, 1.0});
  const CounterRandom random{11, 3};
  int compared = 0, shaded = 0, wrong = 0;
  for (std::uint64_t k = 0; k < 4000; ++k) {
    const UInt4 words = random.words(k, 0);
    const double x = 1.0 + 38.0 * toUnitDouble(words.x, words.y),
                 y = 1.0 + 38.0 * toUnitDouble(words.z, words.w);
    const Vec3d p{x, y, *surface.heightAt(x, y)};
    const double open = map.openness(p - drawn.scene.centre, normal);
    if (open > 0.01 && open < 0.99) continue;  // the shadow's edge runs through these four texels
    std::uint8_t blocked = 0;
    const Ray ray = drawn.scene.towardsSky(p, normal, fall);
    drawn.scene.rays->occludedMany(&ray, 1, &blocked);
    ++compared;
    shaded += blocked;
    wrong += (open < 0.5) != (blocked != 0);
  }
  EXPECT_GT(compared, 3900);
  EXPECT_GT(shaded, 60);
  EXPECT_LE(wrong, compared / 1000);
}

TEST(OcclusionMap, ThinRoofsDoNotLeakAndSlopesDoNotShadeThemselves) {
  for (const double slope : {0.0, 0.5, 1.7}) {
    TestScene test;
    test.land(21, 21, 2.0, [=](double x, double) { return slope * x; });
    ModelNode placed;
    placed.position = {20.0, 20.0, 0.0};
    test.model("sheet", modelOf(sheetMesh({-6, -6, 0.3f}, {6, -6, 0.3f}, {-6, 6, 0.3f})), placed);
    const Drawn drawn(test.build());
    const OcclusionMap map = drawn.map({0.1, 0.0, -1.0}, 0.25);
    const Vec3d normal = normalized(Vec3d{-slope, 0.0, 1.0});
    for (double y = 3.0; y < 38.0; y += 0.37) {
      const auto openAt = [&](double x) {
        return map.openness(Vec3d{x, y, slope * x} - drawn.scene.centre, normal);
      };
      EXPECT_NEAR(openAt(5.3), 1.0, 1e-12) << slope << " " << y;
      if (slope == 0.0 && std::abs(y - 20.0) < 5.0) {
        EXPECT_EQ(openAt(20.1), 0.0) << y;
      }
    }
  }
}

TEST(OcclusionMap, ThreadsChangeNothing) {
  const Drawn drawn(hutOnSlope().build());
  const OcclusionMap one = drawn.map({0.3, 0.1, -1.0}, 0.1, 1), four = drawn.map({0.3, 0.1, -1.0}, 0.1, 4);
  ASSERT_EQ(one.view().rows, four.view().rows);
  for (int j = 0; j < one.view().rows; ++j)
    for (int i = 0; i < one.view().columns; ++i) ASSERT_EQ(one.depth(i, j), four.depth(i, j));
}

TEST(OcclusionMap, ExposureByMapsIsThatByRays) {
  TestScene test = hutOnSlope();
  test.snowfall.fallSpreadDegrees = 15.0;
  test.weather.windSpeed = 1.0;
  test.simulation.exposureRays = 256;
  test.terrain.coverDetailCell = 0.5;
  Drawn drawn(test.build());
  CpuBackend backend(2);
  const CancelToken cancel;
  ExposureSettings settings = exposureSettings(drawn.snapshot, 0.0);
  const auto rays =
      makeExposureField(drawn.snapshot, *drawn.ground, drawn.scene, settings, {backend, cancel, {}});
  settings.mapDirections = 64;
  const auto maps =
      makeExposureField(drawn.snapshot, *drawn.ground, drawn.scene, settings, {backend, cancel, {}});
  ASSERT_TRUE(rays && maps);
  double squares = 0.0, cells = 0.0, held = 0.0;
  for (std::size_t g = 0; g < rays->grids.size(); ++g)
    for (std::size_t c = 0; c < rays->grids[g].exposure.size(); ++c) {
      const double error = static_cast<double>(rays->grids[g].exposure[c] - maps->grids[g].exposure[c]);
      const double area = static_cast<double>(drawn.ground->layout->grids[g].area.values[c]);
      if (!(area > 0.0)) continue;
      squares += error * error;
      cells += 1.0;
      held += static_cast<double>(maps->grids[g].held[c]) * area;
    }
  EXPECT_LT(std::sqrt(squares / cells), 0.03);
  EXPECT_NEAR(held / rays->rates.deposited, 1.0, 0.01);
  const std::vector<float>& seen = maps->grids[1].exposure;
  EXPECT_LT(*std::min_element(seen.begin(), seen.end()), 0.1f)
      << "the hut shelters the fine ground beside it";
}

/// Facets of rough ground lean towards the sky beside a point; under slanting snow that is much in depth.
TEST(OcclusionMap, RoughGroundIsNotDarkenedByItsOwnFacets) {
  TestScene test;
  const CounterRandom random{5, 1};
  test.land(41, 41, 5.0, [&](double x, double y) {
    return 0.1 * x + 12.0 * std::sin(x / 25.0) * std::cos(y / 31.0) +
           0.6 * random.uniformDouble(static_cast<std::uint64_t>(x * 1000.0 + y));
  });
  test.snowfall.fallSpreadDegrees = 15.0;
  test.weather.windSpeed = 3.0;
  test.simulation.exposureRays = 256;
  const Drawn drawn(test.build());
  CpuBackend backend(2);
  const CancelToken cancel;
  ExposureSettings settings = exposureSettings(drawn.snapshot, 0.0);
  const Workshop workshop{backend, cancel, {}};
  const auto rays = makeExposureField(drawn.snapshot, *drawn.ground, drawn.scene, settings, workshop);
  settings.mapDirections = 64;
  const auto maps = makeExposureField(drawn.snapshot, *drawn.ground, drawn.scene, settings, workshop);
  ASSERT_TRUE(rays && maps);
  double surplus = 0.0, squares = 0.0;
  const std::vector<float>&seen = maps->grids[0].exposure, &cast = rays->grids[0].exposure;
  for (std::size_t c = 0; c < seen.size(); ++c) {
    const double error = static_cast<double>(seen[c] - cast[c]);
    surplus += error, squares += error * error;
  }
  const auto cells = static_cast<double>(seen.size());
  EXPECT_LT(std::abs(surplus / cells), 0.02);
  EXPECT_LT(std::sqrt(squares / cells), 0.04);
  EXPECT_LT(*std::min_element(cast.begin(), cast.end()), 0.7f) << "some lies in the lee";
}

TEST(OcclusionMap, NothingToDrawIsOpen) {
  TestScene test;
  const Drawn drawn(test.land(4, 4, 2.0, [](double, double) { return 0.0; }).build());
  const OcclusionMap map = drawn.map({0.0, 0.0, -1.0}, 0.5);
  EXPECT_EQ(map.openness({0, 0, 100.0}, {0, 0, 1}), 1.0);
  EXPECT_EQ(map.openness({1e6, 0, 0}, {0, 0, 1}), 1.0) << "outside the map";
}

/// The raster that cards use, over the processor's backend.
TEST(OcclusionMap, ATriangleAThreadDrawsTheSameMap) {
  const Drawn drawn(hutOnSlope().build());
  const Occluders occluders(drawn.snapshot, drawn.scene);
  MapRasterOn<CpuBackend> raster(occluders, CpuBackend(3));
  const OcclusionMap map = drawn.map({0.5, 0.2, -1.0}, 0.2);
  MapView view = map.view();
  view.keep({Vec3d{-8, -8, -3}, Vec3d{6, 9, 5}});
  EXPECT_GT(view.drawn.fromColumn, 0);
  EXPECT_LT(view.drawn.toRow, view.rows);
  CpuBackend backend(2);
  for (const MapView& wanted : {map.view(), view}) {
    const OcclusionMap other(raster, wanted), banded(occluders, wanted, backend);
    std::size_t seen = 0;
    for (int row = 0; row < wanted.rows; ++row)
      for (int column = 0; column < wanted.columns; ++column) {
        ASSERT_EQ(other.depth(column, row), banded.depth(column, row)) << column << " " << row;
        const bool isDrawn = column >= wanted.drawn.fromColumn && column < wanted.drawn.toColumn &&
                             row >= wanted.drawn.fromRow && row < wanted.drawn.toRow;
        if (!isDrawn) continue;
        ASSERT_EQ(other.depth(column, row), map.depth(column, row));
        seen += std::isfinite(other.depth(column, row)) ? 1 : 0;
      }
    EXPECT_GT(seen, 1000u);
  }
}

TEST(OcclusionMap, ALargeLandIsShownInTilesOfFullDetail) {
  TestScene test;
  test.land(120, 90, 2.0, [](double x, double y) { return 4.0 * std::sin(x / 9.0) + 0.1 * y; });
  const SceneSnapshot scene = test.build();
  const Drawn drawn(scene);
  CpuBackend backend(2);
  const CancelToken cancel;
  ExposureSettings settings;
  settings.cone = fallCone({1.0, 0.5, 0.0}, 1.0, 0.1);
  settings.mapDirections = 8;
  const auto exposureWith = [&](int mapSize) {
    settings.mapSize = mapSize;
    return makeExposureField(drawn.snapshot, *drawn.ground, drawn.scene, settings, {backend, cancel, {}})
        ->grids[0]
        .exposure;
  };
  const std::vector<float> whole = exposureWith(4096), tiled = exposureWith(64);
  double difference = 0.0;
  for (std::size_t c = 0; c < whole.size(); ++c)
    difference += std::abs(static_cast<double>(whole[c] - tiled[c]));
  EXPECT_LT(difference / static_cast<double>(whole.size()), 0.01);
}

}  // namespace
}  // namespace spin
