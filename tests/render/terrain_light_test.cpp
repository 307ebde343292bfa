// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/terrain_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace spin {
namespace {

TEST(TerrainLight, NormalOfAPlaneIsExactAndHolesDoNotSpread) {
  Raster<float> h(20, 20, 0, 0, 2.0);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) h.at(i, j) = static_cast<float>(0.5 * h.x(i) - 0.25 * h.y(j));
  h.at(10, 10) = std::numeric_limits<float>::quiet_NaN();
  const auto light = terrainNormalsAndSky(h);
  const double l = std::sqrt(1.0 + 0.25 + 0.0625);
  for (int j = 0; j < 20; ++j)
    for (int i = 0; i < 20; ++i) {
      if (i == 10 && j == 10) continue;
      EXPECT_NEAR(static_cast<double>(light[h.index(i, j)].x), -0.5 / l, 1e-4);
      EXPECT_NEAR(static_cast<double>(light[h.index(i, j)].y), 0.25 / l, 1e-4);
    }
  EXPECT_EQ(light[h.index(10, 10)].w, 0.0f);
}

TEST(TerrainLight, AFlatPlainSeesAllTheSkyAndAPitLess) {
  Raster<float> h(41, 41, 0, 0, 5.0, 50.0f);
  EXPECT_FLOAT_EQ(terrainNormalsAndSky(h)[h.index(20, 20)].z, 1.0f);
  for (int j = 18; j <= 22; ++j)
    for (int i = 18; i <= 22; ++i) h.at(i, j) = 0.0f;
  // Walls of 50 m at 15 to 20 m: horizon angles beyond 65 degrees all round.
  EXPECT_LT(terrainNormalsAndSky(h)[h.index(20, 20)].z, 0.2f);
}

TEST(TerrainLight, AWallShadesAsFarAsTheSunIsLow) {
  for (const double azimuth : {0.0, 90.0, 180.0, 270.0, 25.0}) {
    const double elevation = 30.0 * 3.14159265 / 180.0, a = azimuth * 3.14159265 / 180.0;
    const Vec3d toSun{std::sin(a) * std::cos(elevation), std::cos(a) * std::cos(elevation),
                      std::sin(elevation)};
    Raster<float> h(121, 121, 0, 0, 1.0, 0.0f);
    // A ridge across the sun's direction through the middle.
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i) {
        const double along = (i - 60) * std::sin(a) + (j - 60) * std::cos(a);
        if (std::abs(along) < 1.0) h.at(i, j) = 20.0f;
      }
    const auto shadow = terrainShadowHeights(h, toSun);
    const double reach = 20.0 / std::tan(elevation);
    for (const double d : {0.5 * reach, 0.9 * reach}) {
      const int i = static_cast<int>(std::lround(60 - d * std::sin(a))),
                j = static_cast<int>(std::lround(60 - d * std::cos(a)));
      const float expected = static_cast<float>(20.0 - d * std::tan(elevation));
      EXPECT_NEAR(shadow[h.index(i, j)], expected, 1.2f) << azimuth << " at " << d;
    }
    // Beyond the shadow and on the sunny side the ground lies a cell's climb above the rays that graze it.
    const auto light =
        packTerrainLight(h, terrainNormalsAndSky(h), shadow, static_cast<float>(0.5 * std::tan(elevation)));
    const auto sunAt = [&](double d) {
      const int i = static_cast<int>(std::lround(60 - d * std::sin(a)));
      const int j = static_cast<int>(std::lround(60 - d * std::cos(a)));
      return int{light[4 * h.index(i, j) + 3]};
    };
    EXPECT_EQ(sunAt(0.9 * reach), 0) << azimuth;
    EXPECT_EQ(sunAt(1.15 * reach), 255) << azimuth;
    EXPECT_EQ(sunAt(-10.0), 255) << azimuth;
  }
}

TEST(TerrainLight, PackedBytesCarryNormalSkyAndSun) {
  Raster<float> h(3, 1, 0, 0, 1.0, 10.0f);
  h.at(2, 0) = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Vec4f> normals{{0, 0, 1, 1}, {0.5f, -0.5f, 0.25f, 1}, {0, 0, 1, 0}};
  const auto bytes = packTerrainLight(h, normals, {0.0f, 20.0f, 1e9f}, 2.0f);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{128, 128, 255, 255, 192, 65, 64, 0, 128, 128, 255, 255}));
}

}  // namespace
}  // namespace spin
