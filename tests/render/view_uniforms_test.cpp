// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/view_uniforms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/nodes/settings_nodes.h"
#include "core/physics/size_spectrum.h"
#include "editor/render/draw_context.h"
#include "editor/render/noise_texture.h"
#include "editor/render/terrain_pass.h"
#include "tests/render/render_scene.h"

namespace spin {
namespace {

struct Clip {
  double x, y, z, w;
};
Clip project(const Matrix4& m, Vec3d p) {
  const auto row = [&](std::size_t r) {
    return static_cast<double>(m[r]) * p.x + static_cast<double>(m[4 + r]) * p.y +
           static_cast<double>(m[8 + r]) * p.z + static_cast<double>(m[12 + r]);
  };
  return {row(0), row(1), row(2), row(3)};
}

TEST(View, TargetIsInTheMiddleAndTheFrameEdgeAtHalfTheAngle) {
  const RenderCamera camera{{10, 20, 30}, {110, 20, 30}, 60.0};
  const Matrix4 m = viewProjection(camera, 2.0, 0.1);
  const Clip middle = project(m, camera.target);
  EXPECT_NEAR(middle.x / middle.w, 0.0, 1e-6);
  EXPECT_NEAR(middle.y / middle.w, 0.0, 1e-6);
  EXPECT_NEAR(middle.w, 100.0, 1e-3);
  const Clip top = project(m, {110, 20, 30 + 100 * std::tan(30.0 * 3.14159265358979 / 180.0)});
  EXPECT_NEAR(top.y / top.w, 1.0, 1e-5);
  const Clip right = project(m, {110, 20 - 10, 30});  // looking east, south is on the right
  EXPECT_GT(right.x, 0.0);
  EXPECT_NEAR(project(m, {10.1, 20, 30}).z / project(m, {10.1, 20, 30}).w, 1.0, 1e-4) << "near plane";
  EXPECT_LT(middle.z / middle.w, 0.01) << "reversed depth falls to 0 far away";
}

TEST(View, FrustumKeepsWhatIsSeenAndDropsWhatIsBehind) {
  const RenderCamera camera{{0, 0, 0}, {0, 100, 0}, 45.0};
  const Frustum frustum(viewProjection(camera, 16.0 / 9.0, 0.1));
  EXPECT_TRUE(frustum.mayShow({{-1, 50, -1}, {1, 52, 1}}));
  EXPECT_FALSE(frustum.mayShow({{-1, -52, -1}, {1, -50, 1}}));
  EXPECT_FALSE(frustum.mayShow({{200, 50, -1}, {201, 52, 1}}));
  EXPECT_TRUE(frustum.mayShow({{-500, -500, -5}, {500, 500, 5}})) << "a box round the eye";
}

TEST(View, LightMatrixHoldsStillForSmallMoves) {
  const Vec3d sun = normalized(Vec3d{1, 1, 1});
  EXPECT_EQ(lightMatrix({100, 100, 10}, sun, 48, 96, 1024),
            lightMatrix({100.1, 100.1, 10}, sun, 48, 96, 1024));
  EXPECT_NE(lightMatrix({100, 100, 10}, sun, 48, 96, 1024), lightMatrix({120, 100, 10}, sun, 48, 96, 1024));
}

TEST(Light, ExposureAndWeatherActInTheRightDirection) {
  const auto light = [](double stops, double cloud, double elevation) {
    test::SceneBuilder scene;
    scene.add<RenderNode>(kRenderType, "render", [=](RenderNode& r) { r.exposure = stops; });
    scene.add<WeatherNode>(kWeatherType, "weather", [=](WeatherNode& w) {
      w.cloudCover = cloud;
      w.sunElevationDegrees = elevation;
    });
    return lightModel(*scene.build(), 0.0, 0.5);
  };
  EXPECT_NEAR(light(1, 0.3, 30).sun.y / light(0, 0.3, 30).sun.y, 2.0, 1e-9);
  EXPECT_NEAR(light(1, 0.3, 30).sky.y / light(0, 0.3, 30).sky.y, 2.0, 1e-9);
  EXPECT_EQ(light(0, 1.0, 30).sun.y, 0.0) << "no beam through a closed cloud";
  EXPECT_EQ(light(0, 0.2, -5).sun.y, 0.0) << "no beam at night";
  EXPECT_GT(light(0, 0.0, 4).sun.x / light(0, 0.0, 4).sun.z,
            light(0, 0.0, 60).sun.x / light(0, 0.0, 60).sun.z)
      << "a low sun is redder";
  EXPECT_GT(light(0, 0.0, 30).sky.z / light(0, 0.0, 30).sky.x,
            light(0, 1.0, 30).sky.z / light(0, 1.0, 30).sky.x)
      << "a clear sky is bluer";
}

TEST(Light, HazeGrowsWithSnowfallAndItsSetting) {
  const auto extinction = [](double rate, double share) {
    test::SceneBuilder scene;
    scene.add<RenderNode>(kRenderType, "render", [=](RenderNode& r) { r.snowfallHaze = share; });
    scene.add<WeatherNode>(kWeatherType, "weather", [=](WeatherNode& w) { w.precipitationRate = rate; });
    scene.add<SnowfallNode>(kSnowfallType, "snowfall", [](SnowfallNode&) {});
    return lightModel(*scene.build(), 0.0, 0.5).hazeExtinction;
  };
  const double clear = extinction(0.0, 1.0);
  const double grams = 1e3 * makeSizeSpectrum(kUnrimedDendriteAggregate, 1e-3).massConcentration;
  const double expected = 10.36e-3 * std::pow(grams, 0.7776);
  EXPECT_GT(expected, 5e-3);
  EXPECT_NEAR(extinction(1e-3, 1.0) - clear, expected, 1e-9);
  EXPECT_NEAR(extinction(1e-3, 0.25) - clear, 0.25 * expected, 1e-9);
}

TEST(Light, FarViewsStayReadable) {
  EXPECT_EQ(readableHaze(1e-3, 500.0), 1.0);
  EXPECT_EQ(readableHaze(0.0, 1e9), 1.0);
  EXPECT_NEAR(readableHaze(1e-3, 7000.0) * 1e-3 * 7000.0, 0.7, 1e-12);
}

TEST(TerrainLevel, KeepsQuadsBelowTheAskedSize) {
  EXPECT_EQ(terrainLevel(0.0, 5.0, 900.0, 12.0), 0);
  for (const double distance : {100.0, 500.0, 1000.0, 2000.0, 4000.0, 9000.0}) {
    const int level = terrainLevel(distance, 5.0, 900.0, 12.0);
    const double pixels = 5.0 * (1 << level) * 900.0 / distance;
    if (level > 0) {
      EXPECT_LE(pixels, 12.0 + 1e-9) << distance;
    }
    if (level < kTerrainLevels - 1) {
      EXPECT_GT(2.0 * pixels, 12.0) << distance << ": not finer than needed";
    }
  }
}

TEST(Noise, TileIsCentredAndRepeatsWithoutASeam) {
  const auto tile = makeNoiseTile();
  double mean = 0.0, inner = 0.0, seam = 0.0;
  const auto at = [&](int i, int j) {
    return static_cast<double>(tile[static_cast<std::size_t>((j * kNoiseSize + i) * 4)]);
  };
  for (int j = 0; j < kNoiseSize; ++j) {
    for (int i = 0; i < kNoiseSize; ++i) mean += at(i, j);
    inner += std::abs(at(100, j) - at(101, j));
    seam += std::abs(at(kNoiseSize - 1, j) - at(0, j));
  }
  EXPECT_NEAR(mean / (kNoiseSize * kNoiseSize), 127.5, 8.0);
  EXPECT_LT(seam, 2.0 * inner);
}

}  // namespace
}  // namespace spin
