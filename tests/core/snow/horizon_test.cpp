// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/horizon.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "core/physics/sunlight.h"
#include "core/snow/snow_cells.h"
#include "core/snow/station_weather.h"

namespace spin {
namespace {

constexpr double kNorth = 0.0, kEast = 0.5 * kPi, kSouth = kPi, kWest = 1.5 * kPi;

TEST(Horizon, PlaneIsFree) {
  CpuBackend backend(1);
  const HorizonMap map = HorizonMap::make(Raster<float>(9, 9, 0, 0, 10.0, 500.0f), 1000.0, backend);
  for (std::size_t cell = 0; cell < map.size(); ++cell) {
    EXPECT_EQ(map.horizonTangent(cell, kEast), 0.0);
    EXPECT_NEAR(map.skyView(cell), 1.0, 1e-9);
    EXPECT_NEAR(map.beamFactor(cell, normalized(Vec3d{1, 0, 0.3})), 1.0, 1e-9);
    EXPECT_EQ(map.beamFactor(cell, {1, 0, 0}), 0.0);
  }
}

TEST(Horizon, SlopeSeesLessSkyByItsAngle) {
  Raster<float> heights(41, 41, 0, 0, 10.0);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) heights.at(i, j) = static_cast<float>(10.0 * j);  // 45 degrees, faces south
  CpuBackend backend(1);
  const HorizonMap map = HorizonMap::make(heights, 1000.0, backend);
  const std::size_t middle = heights.index(20, 20);
  EXPECT_NEAR(map.skyView(middle), 0.5 * (1.0 + std::cos(kPi / 4)), 0.02);
  EXPECT_NEAR(map.horizonTangent(middle, kNorth), 1.0, 1e-5);
  EXPECT_EQ(map.horizonTangent(middle, kSouth), 0.0);
  EXPECT_NEAR(map.beamFactor(middle, normalized(Vec3d{0, -1, 1})), std::sqrt(2.0), 1e-6);
  EXPECT_EQ(map.beamFactor(middle, normalized(Vec3d{0, 1, 0.9})), 0.0);
}

TEST(Horizon, WallThrowsItsShadow) {
  Raster<float> heights(60, 9, 0, 0, 10.0, 0.0f);
  for (int j = 0; j < 9; ++j) heights.at(40, j) = 100.0f;
  CpuBackend backend(1);
  const HorizonMap map = HorizonMap::make(heights, 1000.0, backend);
  const Vec3d sun = normalized(Vec3d{1.0, 0.0, 0.5});  // the shadow is 200 m long
  EXPECT_EQ(map.beamFactor(heights.index(30, 4), sun), 0.0);
  EXPECT_EQ(map.beamFactor(heights.index(22, 4), sun), 0.0);
  EXPECT_GT(map.beamFactor(heights.index(17, 4), sun), 0.99);
  EXPECT_GT(map.beamFactor(heights.index(50, 4), sun), 0.99) << "the wall is behind";
  EXPECT_LT(map.skyView(heights.index(38, 4)), 0.75);
  EXPECT_NEAR(map.horizonTangent(heights.index(50, 4), kWest), 1.0, 1e-5);
}

TEST(Horizon, HolesAndOneCellHideNothing) {
  CpuBackend backend(2);
  Raster<float> heights(3, 1, 0, 0, 10.0, 5.0f);
  heights.at(1, 0) = std::nanf("");
  const HorizonMap map = HorizonMap::make(heights, 100.0, backend);
  EXPECT_NEAR(map.skyView(1), 1.0, 1e-9);
  EXPECT_NEAR(map.skyView(0), 1.0, 1e-9);
  const HorizonMap one = HorizonMap::make(Raster<float>(1, 1, 0, 0, 10.0, 5.0f), 100.0, backend);
  EXPECT_NEAR(one.skyView(0), 1.0, 1e-9);
  EXPECT_GT(one.beamFactor(0, {0, 0, 1}), 0.99);
}

/// Snow left on the middles of a south and a north slope after clear days of spring.
TEST(Horizon, SouthSlopesMeltFirst) {
  Raster<float> ridge(41, 41, 0, 0, 10.0);
  for (int j = 0; j < 41; ++j)
    for (int i = 0; i < 41; ++i) ridge.at(i, j) = static_cast<float>(400.0 - 5.0 * std::abs(j - 20));
  CpuBackend backend(1);
  const HorizonMap map = HorizonMap::make(ridge, 1000.0, backend);
  const std::size_t places[] = {ridge.index(20, 10), ridge.index(20, 30)};  // south, north
  SnowCells cells(2, {GroundMaterial{}}, {});
  for (std::size_t k = 0; k < 2; ++k) {
    SnowColumn<float> c = cells.column(k);
    c.snow[2].ice = 300.0f;
    c.snow[2].depth = 1.0f;
    cells.setColumn(k, c);
    cells.setting(kSkyView)[k] = static_cast<float>(map.skyView(places[k]));
  }
  WeatherRecord record;
  record.longwave = 260.0;
  record.airTemperature = kZeroCelsius + 1.0;
  record.relativeHumidity = 0.6;
  record.wind = 2.0;
  record.pressure = 9e4;
  for (int hour = 0; hour < 24 * 20; ++hour) {
    const double start = 1773964800.0;  // 2026-03-20 00:00 UTC
    const Sun sun = sunAt(start + 3600.0 * (hour + 0.5), degreesToRadians(47.0), 0.0);
    record.shortwave = sun.isUp() ? 0.7 * sun.extraterrestrial * sun.direction.z : 0.0;
    for (std::size_t k = 0; k < 2; ++k)
      cells.setting(kBeamFactor)[k] = static_cast<float>(map.beamFactor(places[k], sun.direction));
    cells.advance(stationWeather(record, 3600.0, &sun), backend);
  }
  EXPECT_LT(columnMass(cells.column(0)), columnMass(cells.column(1)) - 100.0);
}

}  // namespace
}  // namespace spin
