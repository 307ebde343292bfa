// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "core/physics/clear_sky.h"
#include "core/physics/melt_laws.h"
#include "core/physics/moved_snow.h"
#include "core/sim/scene_time.h"
#include "core/snow/cover_weather.h"
#include "core/snow/snow_cells.h"
#include "tests/core/snow/snow_test_scene.h"

namespace spin {
namespace {

using test::TestScene;

/// A scene whose snow ages, an hour of weather a frame.
struct AgingScene : TestScene {
  explicit AgingScene(CoverLaw law = CoverLaw::EnergyBalance) {
    cover.law = law;
    simulation.timeScale = 24.0 * 3600.0;
    simulation.newSnowDensity = 0.0;
    weather.precipitationRate = 0.0;
    weather.windSpeed = 3.0;
    weather.sun = MeltingSun::Pictured;
    snowfall.oldSnowDepth = 0.4;
    snowfall.oldSnowDensity = 250.0;
  }
};

double flat(double, double) {
  return 0.0;
}

Frame framesOf(const SceneSnapshot& scene, int frames, int threads = 2) {
  SnowRun run(scene, makeBvhRayScene, threads);
  const Status status = run.run(frames);
  EXPECT_TRUE(status.ok());
  return run.frame();
}

double sweAt(const Frame& frame, std::size_t cell) {
  return static_cast<double>(test::coverOf(frame).values[0].swe[cell]);
}

TEST(CoverMelt, WarmAirMeltsAndRunsOffAndTheBudgetCloses) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(6.0);
  test.weather.cloudCover = 0.0;
  const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 24);
  const MassBudget& budget = frame.info.budget;
  EXPECT_LT(sweAt(frame, 14), 95.0);
  EXPECT_GT(sweAt(frame, 14), 20.0);
  EXPECT_GT(budget.get("runoff"), 0.0);
  EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-6);
  EXPECT_GT(frame.info.figures.at("melted_kg"), budget.get("runoff"));
}

TEST(CoverMelt, ColdSnowStaysAndSettles) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(-12.0);
  test.weather.sunElevationDegrees = -10.0;
  test.snowfall.oldSnowDensity = 120.0;
  const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 100);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_NEAR(cover.values[0].swe[14], 48.0f, 2.0f);
  EXPECT_LT(cover.values[0].depth[14], 0.3f);
  EXPECT_EQ(frame.info.budget.get("runoff"), 0.0);
  EXPECT_LT(cover.values[0].temperature[14], 268.0f);
}

TEST(CoverMelt, SnowThatLiesAsItFellDoesNotChange) {
  AgingScene test(CoverLaw::Lies);
  test.weather.airTemperature = celsiusToKelvin(15.0);
  const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 24);
  EXPECT_FLOAT_EQ(static_cast<float>(sweAt(frame, 14)), 100.0f);
  EXPECT_TRUE(test::coverOf(frame).values[0].temperature.empty());
}

TEST(CoverMelt, DegreeDayMeltsItsFactor) {
  AgingScene test(CoverLaw::DegreeDay);
  test.weather.airTemperature = celsiusToKelvin(5.0);
  test.cover.degreeDayFactor = 4.0 / 86400.0;
  const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 24);
  EXPECT_NEAR(sweAt(frame, 14), 80.0, 1e-3);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
}

TEST(CoverMelt, ThePublishedLawIsGuardedAndClampedAndSaysSo) {
  for (const double celsius : {0.0, -1.0}) {
    AgingScene test(CoverLaw::Published);
    GroundTemperatureLayerNode ground;
    ground.base = celsiusToKelvin(celsius);
    test.snapshot.nodes.push_back(test::node(kGroundTemperatureLayerType, "warmth", ground));
    const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 2);
    if (celsius == 0.0) {
      EXPECT_GT(frame.info.figures.at("published_law_guarded_m2_h"), 0.0);
    } else {
      EXPECT_GT(frame.info.figures.at("published_law_growth_refused_kg"), 0.0);
      EXPECT_NEAR(sweAt(frame, 14), 100.0, 1e-3);
    }
    EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
  }
}

TEST(CoverMelt, SouthernSlopesLoseTheirSnowFirst) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(1.0);
  test.weather.cloudCover = 0.1;
  test.weather.sunAzimuthDegrees = 180.0;
  test.weather.sunElevationDegrees = 35.0;
  test.simulation.holdsBelowDegrees = 60.0;
  test.simulation.shedsAboveDegrees = 80.0;
  // A ridge along x: its southern side faces the sun.
  const auto ridge = [](double, double y) { return 30.0 - 0.4 * std::abs(y - 40.0); };
  const Frame frame = framesOf(test.land(9, 41, 2.0, ridge).build(), 24);
  const std::size_t south = 9 * 8 + 4, north = 9 * 32 + 4;
  EXPECT_LT(sweAt(frame, south), sweAt(frame, north) - 8.0);
  test.cover.slopesAndShadow = false;
  const Frame level = framesOf(test.build(), 24);
  EXPECT_NEAR(sweAt(level, south), sweAt(level, north), 0.05);
}

TEST(CoverMelt, OnlyTheSunThatMeltsCountsInFrameKeys) {
  for (const MeltingSun sun : {MeltingSun::None, MeltingSun::Pictured}) {
    AgingScene test;
    test.weather.sun = sun;
    const SceneSnapshot before = test.land(6, 6, 2.0, flat).build();
    test.weather.sunAzimuthDegrees += 20.0;
    const SceneSnapshot after = test.build();
    const auto keys = [](const SceneSnapshot& s) { return frameKeys(s, Pipeline::compile(s), "cpu", 2); };
    EXPECT_EQ(keys(before) == keys(after), sun == MeltingSun::None);
  }
}

TEST(CoverMelt, RainFallsBelowAndSnowAbove) {
  AgingScene test;
  test.snowfall.oldSnowDepth = 0.0;
  test.weather.airTemperature = celsiusToKelvin(7.0);
  test.weather.lapseRate = 0.0065;
  test.weather.precipitationGradient = 0.0005;
  test.weather.phase = PrecipitationPhase::ByTemperature;
  test.weather.precipitationRate = 2.0 / 3600.0;
  test.weather.cloudCover = 1.0;
  test.weather.sunElevationDegrees = -5.0;
  const auto slope = [](double x, double y) { return x < 60.0 && y > 180.0 ? double(test::kHole) : 0.7 * x; };
  const Frame frame = framesOf(test.land(41, 5, 50.0, slope).build(), 12);
  const std::size_t row = 41 * 2;
  EXPECT_NEAR(sweAt(frame, row + 3), 0.0, 1.0);
  EXPECT_GT(sweAt(frame, row + 37), 20.0);
  const MassBudget& budget = frame.info.budget;
  EXPECT_GT(budget.get("altitude_gain"), 0.0);
  EXPECT_GT(budget.get("runoff"), 0.0);
  EXPECT_LT(std::abs(budget.relativeImbalance()), 1e-6);
}

TEST(CoverMelt, RainRunsOffAlsoWhereSnowLiesAsItFell) {
  AgingScene test(CoverLaw::Lies);
  test.snowfall.oldSnowDepth = 0.0;
  test.weather.airTemperature = celsiusToKelvin(7.0);
  test.weather.lapseRate = 0.0065;
  test.weather.phase = PrecipitationPhase::ByTemperature;
  test.weather.precipitationRate = 2.0 / 3600.0;
  const Frame frame = framesOf(test.land(41, 5, 50.0, [](double x, double) { return 0.7 * x; }).build(), 12);
  const std::size_t row = 41 * 2;
  EXPECT_LT(sweAt(frame, row + 3), 0.5);
  EXPECT_GT(sweAt(frame, row + 37), 15.0);
  EXPECT_GT(frame.info.budget.get("runoff"), 0.0);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
}

/// Eight plots side by side: four grounds, the eastern half of each colder.
struct PlotScene : AgingScene {
  static constexpr int kPlot = 5;
  explicit PlotScene(CoverLaw law) : AgingScene(law) {
    land(8 * kPlot, kPlot, 2.0, flat);
    SceneNode types = test::node(kGroundTypeLayerType, "types", GroundTypeLayerNode());
    SceneNode warmth = test::node(kGroundTemperatureLayerType, "warmth", GroundTemperatureLayerNode());
    TiledRaster<std::uint8_t> type(8 * kPlot, kPlot, kUnpaintedGround);
    TiledRaster<float> kelvin(8 * kPlot, kPlot, std::numeric_limits<float>::quiet_NaN());
    for (int j = 0; j < kPlot; ++j)
      for (int i = 0; i < 8 * kPlot; ++i) {
        type.set(i, j, static_cast<std::uint8_t>(i / kPlot / 2));
        kelvin.set(i, j, i / kPlot % 2 == 0 ? 274.15f : 272.15f);
      }
    types.painted = std::move(type);
    warmth.painted = std::move(kelvin);
    snapshot.nodes.push_back(types);
    snapshot.nodes.push_back(warmth);
  }
  /// kg/m2 on a ground at +1 or -1 degC.
  static double sweOn(const Frame& frame, GroundType ground, bool cold) {
    const int plot = 2 * static_cast<int>(ground) + (cold ? 1 : 0);
    return sweAt(frame, static_cast<std::size_t>(8 * kPlot * 2 + plot * kPlot + 2));
  }
};

TEST(CoverMelt, ConductiveGroundKeepsLessAndColdGroundMoreUnderBothLaws) {
  for (const CoverLaw law : {CoverLaw::EnergyBalance, CoverLaw::Published}) {
    const bool published = law == CoverLaw::Published;
    PlotScene test(law);
    // The published law takes centimetres an hour; by balance new snow goes in days, thin enough to show it.
    test.snowfall.oldSnowDepth = published ? 0.08 : 0.0;
    test.weather.relativeHumidity = 0.9;
    test.weather.windSpeed = 0.1;
    test.weather.sun = MeltingSun::None;
    test.weather.cloudCover = 1.0;
    SceneSnapshot scene = test.build();
    for (SceneNode& node : scene.nodes) {
      if (node.id != "weather" || published) continue;
      AnimationCurve& rate = node.curves["precipitation_rate_kg_m2_s"];
      rate.setKey({0.0, 1.6 / 3600.0, Interpolation::Step});
      rate.setKey({0.25, 0.0, Interpolation::Step});
      AnimationCurve& air = node.curves["air_temperature_k"];
      air.setKey({0.25, celsiusToKelvin(-0.5), Interpolation::Linear});
      air.setKey({0.5, celsiusToKelvin(1.0), Interpolation::Linear});
    }
    const Frame frame = framesOf(scene, published ? 1 : 84);
    // By conductivity: vegetation 0.13, sand 0.17, quartz 0.44, soil 0.63 W/(m K).
    const GroundType order[] = {GroundType::Vegetation, GroundType::Sand, GroundType::Quartz,
                                GroundType::Soil};
    for (int k = 0; k < 3; ++k)
      EXPECT_GT(PlotScene::sweOn(frame, order[k], false),
                PlotScene::sweOn(frame, order[k + 1], false) + 0.015)
          << "law " << static_cast<int>(law) << ", ground " << k;
    for (const GroundType ground : order)
      EXPECT_GT(PlotScene::sweOn(frame, ground, true), PlotScene::sweOn(frame, ground, false) + 0.015);
  }
}

TEST(CoverMelt, HeatSourcesMeltABareSpot) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(-4.0);
  test.weather.sunElevationDegrees = -5.0;
  HeatSourceNode spring;
  spring.position = {20.0, 20.0, 0.0};
  spring.radius = 8.0;
  spring.power = 600.0;
  test.snapshot.nodes.push_back(test::node(kHeatSourceType, "spring", spring));
  const Frame frame = framesOf(test.land(21, 21, 2.0, flat).build(), 72);
  EXPECT_LT(sweAt(frame, 21 * 10 + 10), 1.0);
  EXPECT_GT(sweAt(frame, 21 * 2 + 2), 95.0);
}

TEST(CoverMelt, WarmRoofsKeepLess) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(-3.0);
  test.weather.sunElevationDegrees = -5.0;
  ModelNode cold, warm;
  cold.position = {12.0, 12.0, 0.0};
  warm.position = {32.0, 12.0, 0.0};
  warm.heat = 80.0;
  const auto roof = test::modelOf(test::sheetMesh({-4, -4, 3}, {4, -4, 3}, {-4, 4, 3}));
  test.model("cold", roof, cold).model("warm", roof, warm);
  const Frame frame = framesOf(test.land(23, 13, 2.0, flat).build(), 72);
  const CoverPart& cover = test::coverOf(frame);
  EXPECT_LT(test::massOn(cover, test::gridOf(cover, "warm/0")),
            test::massOn(cover, test::gridOf(cover, "cold/0")) - 64.0 * 20.0);
}

TEST(CoverMelt, ShortFramesAndLongOnesAgree) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(2.0);
  test.weather.precipitationRate = 1.0 / 3600.0;
  test.land(6, 6, 2.0, flat);
  const Frame hours = framesOf(test.build(), 6);
  test.simulation.timeScale = 24.0 * 20.0;  // 20 s of weather a frame: three wait for each other
  const Frame seconds = framesOf(test.build(), 6 * 180);
  EXPECT_NEAR(sweAt(hours, 14), sweAt(seconds, 14), 0.01 * sweAt(hours, 14));
  EXPECT_LT(std::abs(seconds.info.budget.relativeImbalance()), 1e-6);
  test.simulation.timeScale = 24.0 * 6.0 * 3600.0;
  const Frame leap = framesOf(test.build(), 1);
  EXPECT_NEAR(sweAt(hours, 14), sweAt(leap, 14), 1e-4 * sweAt(hours, 14));
}

TEST(CoverMelt, ThreadsAndCheckpointsChangeNothing) {
  AgingScene test;
  test.weather.airTemperature = celsiusToKelvin(1.0);
  test.weather.precipitationRate = 2.0 / 3600.0;
  test.weather.phase = PrecipitationPhase::ByTemperature;
  test.simulation.timeScale = 24.0 * 25.0;
  const SceneSnapshot scene =
      test.land(30, 30, 2.0, [](double x, double y) { return 3.0 * std::sin(0.2 * x) * std::cos(0.3 * y); })
          .build();
  const auto bytesOf = [](const Frame& frame) {
    ByteWriter out;
    saveFrame(frame, out, false);
    return out.take();
  };
  SnowRun one(scene, makeBvhRayScene, 1), four(scene, makeBvhRayScene, 4);
  ASSERT_TRUE(one.run(7).ok());
  ASSERT_TRUE(four.run(7).ok());
  EXPECT_EQ(bytesOf(one.frame()), bytesOf(four.frame()));
  SnowRun resumed(scene, makeBvhRayScene, 2);
  ASSERT_TRUE(resumed.load(7, one.save()).ok());
  for (int f = 0; f < 6; ++f) {
    ASSERT_TRUE(resumed.step().ok());
    ASSERT_TRUE(four.step().ok());
  }
  EXPECT_EQ(bytesOf(resumed.frame()), bytesOf(four.frame()));
}

TEST(CoverMelt, HardWeatherStaysFinite) {
  for (const double celsius : {-60.0, 60.0})
    for (const double wind : {0.0, 60.0})
      for (const double sun : {-20.0, 90.0}) {
        AgingScene test;
        test.weather.airTemperature = celsiusToKelvin(celsius);
        test.weather.windSpeed = wind;
        test.weather.sunElevationDegrees = sun;
        test.weather.precipitationRate = 50.0 / 3600.0;
        test.weather.phase = PrecipitationPhase::ByTemperature;
        const Frame frame =
            framesOf(test.land(9, 9, 1.0, [](double x, double) { return x > 4.5 ? 40.0 : 0.0; }).build(), 6);
        EXPECT_EQ(test::coverOf(frame).firstNonFinite(), "") << celsius << " " << wind << " " << sun;
        EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 2e-6) << celsius << " " << wind;
      }
}

TEST(CoverMelt, TenMetresInAnHour) {
  AgingScene test;
  test.snowfall.oldSnowDepth = 0.0;
  test.weather.airTemperature = celsiusToKelvin(-8.0);
  test.weather.precipitationRate = 700.0 / 3600.0;
  const Frame frame = framesOf(test.land(6, 6, 2.0, flat).build(), 1);
  EXPECT_GT(test::coverOf(frame).values[0].depth[14], 8.0f);
  EXPECT_LT(std::abs(frame.info.budget.relativeImbalance()), 1e-6);
}

std::shared_ptr<const WeatherSeries> recordOf(std::size_t hours, double celsius, double snow) {
  auto series = std::make_shared<WeatherSeries>();
  series->start = *parseDateTime("2006-01-10 00:00");
  for (std::size_t h = 0; h < hours; ++h) {
    WeatherRecord r{0.0, 280.0, 0.0, 0.0, celsiusToKelvin(celsius), 0.8, 2.0, 87000.0};
    if (h == 3) r.snowfall = snow;
    series->records.push_back(r);
  }
  return series;
}

TEST(CoverMelt, AStationsRecordRulesWhatFalls) {
  AgingScene test;
  test.snowfall.oldSnowDepth = 0.0;
  test.weather.precipitationRate = 0.01;
  test.snapshot.weather = recordOf(10, -5.0, 0.001);
  SceneSnapshot scene = test.land(6, 6, 2.0, flat).build();
  EXPECT_NEAR(sweAt(framesOf(scene, 3), 14), 0.0, 0.2);
  EXPECT_NEAR(sweAt(framesOf(scene, 9), 14), 3.6, 0.2);
  // Beyond the record nothing falls.
  EXPECT_NEAR(sweAt(framesOf(scene, 30), 14), 3.6, 0.4);
  test.weather.start = "2006-01-10 05:00";
  EXPECT_NEAR(sweAt(framesOf(test.build(), 4), 14), 0.0, 0.2);
}

TEST(CoverMelt, ADateThatCannotBeReadIsAnError) {
  AgingScene test;
  test.weather.start = "10. 1. 2006";
  const SceneSnapshot scene = test.land(6, 6, 2.0, flat).build();
  SnowRun run(scene, makeBvhRayScene, 1);
  const Status status = run.run(1);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::BadInput);
}

TEST(MovedSnow, KeepsMassWaterAndHeat) {
  SnowColumn<float> a{}, b{};
  a.snow[0] = {20.0f, 0.0f, 0.1f, -6.0f};
  a.snow[1] = {50.0f, 1.5f, 0.2f, 0.0f};
  b.snow[0] = {5.0f, 0.2f, 0.03f, 0.0f};
  const auto sums = [](const SnowColumn<float>& c) {
    std::array<double, 3> s{columnMass(c), 0.0, 0.0};
    for (const SnowLayer<float>& layer : c.snow) {
      s[1] += static_cast<double>(layer.depth);
      s[2] += static_cast<double>(layerEnthalpy(layer));
    }
    return s;
  };
  const auto before = sums(a), beforeB = sums(b);
  for (const double share : {0.3, 0.9}) {
    SnowColumn<float> from = a, to = b;
    const MovedSnow moved{share * 0.3, share * 70.0, share * 1.5,
                          share * (kIceHeat * 20.0 * -6.0 + kFusionHeat * 1.5)};
    takeFromColumn(from, {-moved.depth, -moved.ice, -moved.liquid, -moved.heat});
    layOnColumn(to, moved);
    const auto after = sums(from), afterB = sums(to);
    EXPECT_NEAR(after[0] + afterB[0], before[0] + beforeB[0], 2e-5);
    EXPECT_NEAR(after[1] + afterB[1], before[1] + beforeB[1], 1e-5);
    EXPECT_NEAR(after[2] + afterB[2], before[2] + beforeB[2], 0.5);
    EXPECT_NEAR(after[0], (1.0 - share) * before[0], 1e-5);
  }
}

/// Dry snow blew off and a little that is moist slid in: a net loss that brings water.
TEST(MovedSnow, ANetLossThatBringsWaterKeepsItsHeat) {
  SnowColumn<float> column{};
  column.snow[0] = {20.0f, 0.0f, 0.1f, -6.0f};
  const double before = static_cast<double>(layerEnthalpy(column.snow[0]));
  const MovedSnow change{-0.03, -6.0, 0.4, kIceHeat * 6.0 * 6.0 + kFusionHeat * 0.4};
  takeFromColumn(column, change);
  double after = 0.0;
  for (const SnowLayer<float>& layer : column.snow) after += static_cast<double>(layerEnthalpy(layer));
  EXPECT_NEAR(columnMass(column), 14.4, 1e-5);
  EXPECT_NEAR(after, before + change.heat, 1.0);
}

TEST(CoverWeather, ARecordHoldsItsNearestValuesFarFromIt) {
  const auto series = recordOf(10, -5.0, 0.001);
  for (const double away : {-1e12, 1e12}) {
    const double at = static_cast<double>(series->start) + away;
    const WeatherRecord record = meanRecord(*series, at, at);
    EXPECT_NEAR(record.airTemperature, 268.15, 1e-9);
    EXPECT_NEAR(record.pressure, 87000.0, 1e-6);
    EXPECT_EQ(record.snowfall, 0.0);
  }
}

TEST(CoverWeather, PartsOfARecordsStepsAreWeighed) {
  const auto series = recordOf(10, -5.0, 0.001);
  const double start = static_cast<double>(series->start);
  EXPECT_NEAR(meanRecord(*series, start + 2.5 * 3600, start + 3.5 * 3600).snowfall, 0.0005, 1e-12);
  EXPECT_EQ(meanRecord(*series, start - 7200, start - 3600).snowfall, 0.0);
  EXPECT_NEAR(meanRecord(*series, start - 7200, start - 3600).pressure, 87000.0, 1e-6);
  EXPECT_NEAR(meanRecord(*series, start + 3 * 3600, start + 3 * 3600).snowfall, 0.001, 1e-9);
  EXPECT_NEAR(meanRecord(*series, start + 9.5 * 3600, start + 11.5 * 3600).airTemperature, 268.15, 1e-9);
  EXPECT_NEAR(meanWetPrecipitation(*series), 0.001, 1e-12);
}

TEST(CoverWeather, TheSunGoesRoundByDate) {
  AgingScene test;
  test.weather.start = "2006-06-21 00:00";
  test.weather.sun = MeltingSun::ByDate;
  test.weather.latitudeDegrees = 45.0;
  test.weather.longitudeDegrees = 0.0;
  SceneSnapshot scene = test.build();
  const auto sunAtHour = [&](double h) {
    return coverWeather(scene, {{0, 0.0, h * 3600}, {1, 0.0, h * 3600}}).sun.direction;
  };
  EXPECT_NEAR(radiansToDegrees(std::asin(sunAtHour(12.0).z)), 90.0 - 45.0 + 23.44, 0.3);
  EXPECT_LT(sunAtHour(0.0).z, 0.0);
  EXPECT_GT(sunAtHour(6.0).x, 0.5);
}

TEST(ClearSky, FollowsThePublishedFits) {
  EXPECT_NEAR(skyShortwave(0.5, 0.0), 425.0, 1e-9);
  EXPECT_NEAR(skyShortwave(0.5, 1.0), 0.25 * 425.0, 1e-9);
  EXPECT_EQ(skyShortwave(-0.3, 0.0), 0.0);
  // Brutsaert at 273.15 K and 6.11 hPa: 0.7207 sigma T^4 = 227.5.
  EXPECT_NEAR(skyLongwave(273.15, 1.0, 0.0), 227.5, 1.5);
  EXPECT_NEAR(skyLongwave(273.15, 1.0, 1.0), 315.6, 0.2);
  EXPECT_NEAR(standardPressure(1500.0), 84556.0, 30.0);
}

TEST(SceneTime, ReadsDatesAndRefusesNoDates) {
  EXPECT_EQ(*parseDateTime("1970-01-02 01:00"), 90000);
  EXPECT_EQ(*parseDateTime("1970-01-02T01:00:05Z"), 90005);
  EXPECT_EQ(*parseDateTime("2005-10-01"), 1128124800);
  EXPECT_EQ(dateTimeText(1128124800), "2005-10-01 00:00");
  for (const char* bad : {"", "x", "2005-13-01", "2005-02-30", "2005-02-28 24:00", "2005-02-28 12",
                          "05-02-28", "2005-02-28 12:00 PM", "2005-02-2812:00"})
    EXPECT_FALSE(parseDateTime(bad)) << bad;
}

}  // namespace
}  // namespace spin
