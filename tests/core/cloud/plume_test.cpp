// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "core/cloud/cloud_process.h"
#include "core/flow/flow_process.h"
#include "core/nodes/air_nodes.h"
#include "core/sim/air_part.h"
#include "tests/core/flow/flow_test_scene.h"

namespace spin {
namespace {

constexpr double kCrest = 55.0;
/// Of the water that comes over the crest with 4 m/s: the fall's own spray begins there.
constexpr double kCrestWater = kCrest + 3.5 / 4.0;

/// A block fall of 55 m, 3.5 m3/s per metre of a crest of 16 m, in coarse particles; water so much warmer
/// than the air.
FramePointer blockFall(double airTemperature, double warmer, double seconds) {
  test::FlowTestScene scene;
  scene.land(86, 31, 2.0, [](double x, double) {
    return x <= 30.0 ? kCrest : x >= 32.0 ? 0.0 : 0.5 * kCrest;
  });
  scene.settings.spacing = 0.8;
  scene.settings.margin = 4.0, scene.settings.headroom = 6.0;
  scene.settings.rock = scene.settings.vegetation = 0.05;
  scene.settings.turbulence = 1000.0;
  scene.simulation.frameRate = 12.0;
  WaterSourceNode source;
  source.position = {26.0, 22.0, 0.1}, source.end = {26.0, 38.0, 0.1};
  source.velocity = {4.0, 0.0, 0.0}, source.flowPerMetre = 3.5;
  FlowSinkNode outlet;
  outlet.shape = FlowSinkShape::Plane;
  outlet.position = {166.0, 30.0, 0.0}, outlet.normal = {-1, 0, 0};
  WeatherNode weather;
  weather.airTemperature = airTemperature, weather.windSpeed = 2.0, weather.precipitationRate = 0.0;
  AirNode air;
  air.waterTemperature = airTemperature + warmer;
  air.margin = 10.0, air.headroom = 40.0;
  scene.add(kWaterSourceType, "crest", source).add(kFlowSinkType, "outlet", outlet);
  scene.add(kWeatherType, "weather", weather).add(kAirType, "air", air);
  RunOptions options = test::flowOptions(static_cast<int>(seconds * 12.0));
  options.types = {flowProcessType(), cloudProcessType()};
  FrameStore store;
  const Status done = runSimulation(scene.build(), store, options, {}, CancelToken());
  SPIN_CHECK(done.ok(), done.error().text());
  return store.get(options.lastFrame);
}

/// Height above which there is 1 % of the mist that is beyond x, linear within a layer of cells.
double topOf(const AirPart& air, double x) {
  const AirField* mist = air.find("mist");
  SPIN_CHECK(mist, "no mist");
  std::map<double, double> byHeight;
  double all = 0.0;
  for (std::size_t b = 0; b < air.bricks.size(); ++b)
    for (std::size_t c = 0; c < kBrickCells; ++c) {
      const auto k =
          static_cast<double>(air.bricks[b][2] * kBrickZ) + static_cast<double>(c / (kBrickX * kBrickY));
      const auto i = static_cast<double>(air.bricks[b][0] * kBrickX) + static_cast<double>(c % kBrickX);
      if (air.origin.x + air.cell * (i + 0.5) < x) continue;
      const auto value = static_cast<double>(mist->at(b, 0, c));
      byHeight[air.origin.z + air.cell * (k + 0.5)] += value;
      all += value;
    }
  double above = 0.0;
  for (auto it = byHeight.rbegin(); it != byHeight.rend(); ++it) {
    if (above + it->second > 0.01 * all)
      return it->first + air.cell * (0.5 - (0.01 * all - above) / it->second);
    above += it->second;
  }
  return air.origin.z;
}

TEST(Plume, OfWaterWarmerThanTheAirRisesAboveTheCrestAndOfColderWaterStaysBelow) {
  if (!std::getenv("SPIN_LONG_TESTS")) GTEST_SKIP() << "takes minutes; set SPIN_LONG_TESTS=1";
  // A plume that rises with 2 m/s takes half a minute to the crest.
  const FramePointer warm = blockFall(263.15, 10.0, 60.0), cold = blockFall(283.15, -5.0, 60.0);
  for (const FramePointer& frame : {warm, cold}) {
    EXPECT_GT(frame->info.figures.at("air_mist_kg"), 1.0);
    EXPECT_LT(std::abs(frame->info.budget.relativeImbalance()), 1e-5);
  }
  // All mist, that of the fall itself among it, and what drifts away from it.
  for (const double beyond : {-100.0, 44.0}) {
    const double warmTop = topOf(*warm->part<AirPart>("air"), beyond);
    const double coldTop = topOf(*cold->part<AirPart>("air"), beyond);
    RecordProperty(fmt::format("warm_top_beyond_{}_m", beyond), std::to_string(warmTop));
    RecordProperty(fmt::format("cold_top_beyond_{}_m", beyond), std::to_string(coldTop));
    EXPECT_GT(warmTop, kCrestWater);
    EXPECT_LT(coldTop, beyond < 0.0 ? kCrestWater : 0.4 * kCrest) << "it hugs the river";
  }
}

}  // namespace
}  // namespace spin
