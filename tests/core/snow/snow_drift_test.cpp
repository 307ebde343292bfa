// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/snow/snow_drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/base/units.h"
#include "core/physics/blowing_snow.h"
#include "tests/core/snow/cover_land.h"

namespace spin {
namespace {

struct Field {
  std::shared_ptr<const CoverGraph> graph;
  std::vector<double> depth, swe;
  std::vector<float> friction, threshold;
  std::vector<Vec2f> direction;
  DriftSettings settings;
  DriftTotals totals;

  Field(std::shared_ptr<const CoverGraph> g, Vec2f towards, float u, double snow = 100.0)
      : graph(std::move(g)),
        depth(graph->size(), 0.0),
        swe(graph->size(), 0.0),
        friction(graph->size(), u),
        threshold(graph->size(), 0.25f),
        direction(graph->size(), towards) {
    for (std::uint32_t c = 0; c < graph->size(); ++c)
      if (graph->area(c) > 0.0f) swe[c] = snow, depth[c] = snow / 200.0;
  }
  void blow(double seconds) {
    SnowDrift drift(graph);
    drift.setDirections(direction);
    totals = drift.blow({depth.data(), swe.data()}, 1, friction, threshold, settings, seconds);
  }
  double mass() const { return test::sumOver(*graph, swe); }
};

double flat(double, double) {
  return 0.0;
}

TEST(BlowingSnow, RatesFollowTheirSources) {
  EXPECT_NEAR(driftThresholdWind(-10.0), 7.96, 1e-9);
  EXPECT_DOUBLE_EQ(driftThresholdWind(5.0), 9.43);
  EXPECT_NEAR(driftThresholdWind(-60.0), 6.975, 0.01);
  EXPECT_NEAR(driftThresholdFriction(300.0), 0.246, 1e-3);
  EXPECT_NEAR(driftThresholdFriction(300.001), 0.247, 1e-3);
  EXPECT_NEAR(saltationRate(0.5, 0.25), 0.68 * 1.2 / 9.80665 * 0.5 * 0.1875, 1e-12);
  EXPECT_EQ(driftRate(0.25, 0.25, 0.01), 0.0);
  // In strong wind nearly all of Tabler's transport: 15 m/s carry 0.13 kg/(m s).
  const double u = 15.0 * 0.4 / std::log(1000.0);
  EXPECT_NEAR(driftRate(u, 0.25, 0.01), std::pow(15.0, 3.8) / 233847.0, 0.015);
}

TEST(SnowDrift, NothingMovesBelowTheThreshold) {
  Field field(test::landGraph(40, 30, 5.0, flat), {1, 0}, 0.249f);
  const std::vector<double> before = field.swe;
  field.blow(3600.0);
  EXPECT_EQ(field.swe, before);
  EXPECT_EQ(field.totals.blownIn[1], 0.0);
}

TEST(SnowDrift, AnEvenFieldLosesSnowAtItsWindwardEdgeOnly) {
  Field field(test::landGraph(400, 5, 10.0, flat), {1, 0}, 0.5f);
  field.settings.inflow = 0.0;
  const double before = field.mass();
  field.blow(600.0);
  EXPECT_NEAR(field.mass() + field.totals.blownOut[1], before, 1e-9 * before);
  // Transport grows as 1 - exp(-x/fetch): so does what is taken.
  const double limit = driftRate(0.5, 0.25, field.settings.roughness);
  const double first = limit * -std::expm1(-10.0 / field.settings.fetch) * 600.0 / 10.0;
  EXPECT_NEAR(100.0 - field.swe[2 * 400], first, 1e-6 * first);
  EXPECT_NEAR(field.swe[2 * 400 + 390], 100.0, 1e-6);
  EXPECT_NEAR(field.totals.blownOut[1], limit * 50.0 * 600.0, 1e-6 * limit * 50.0 * 600.0);

  Field endless(test::landGraph(50, 40, 10.0, flat), {0.6f, 0.8f}, 0.5f);
  endless.blow(600.0);
  for (const double swe : endless.swe) ASSERT_NEAR(swe, 100.0, 1e-9);
  EXPECT_NEAR(endless.totals.blownIn[1], endless.totals.blownOut[1], 1e-9 * endless.totals.blownIn[1]);
}

TEST(SnowDrift, ACalmLeeGathersWhatTheWindBringsAndTheGroundBehindIsTaken) {
  Field field(test::landGraph(100, 3, 2.0, flat), {1, 0}, 0.6f);
  for (std::uint32_t c = 0; c < field.graph->size(); ++c)
    if (c % 100 >= 40 && c % 100 < 50) field.friction[c] = 0.1f;
  const double before = field.mass();
  field.blow(600.0);
  EXPECT_NEAR(field.mass() + field.totals.blownOut[1] - field.totals.blownIn[1], before, 1e-9 * before);
  EXPECT_GT(field.swe[100 + 40], 102.0);
  EXPECT_GT(field.swe[100 + 40], field.swe[100 + 45]);  // most falls at its start
  EXPECT_LT(field.swe[100 + 51], 100.0);
  EXPECT_NEAR(field.swe[100 + 20], 100.0, 1e-9);
  // Depth goes with the mass.
  for (std::size_t c = 0; c < field.swe.size(); ++c) ASSERT_NEAR(field.depth[c], field.swe[c] / 200.0, 1e-9);
}

TEST(SnowDrift, MassClosesInAnyWind) {
  Field field(test::landGraph(
                  80, 60, 5.0,
                  [](double x, double y) { return std::hypot(x - 200, y - 100) < 40 ? std::nan("") : 0.0; }),
              {1, 0}, 1.0f);
  const CounterRandom random{5, 9};
  for (std::uint32_t c = 0; c < field.graph->size(); ++c) {
    const double turn = 2.0 * kPi * random.uniformDouble(2 * c);  // rings too
    field.direction[c] = {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn))};
    field.friction[c] = static_cast<float>(1.5 * random.uniformDouble(2 * c + 1));
  }
  const double before = field.mass();
  field.blow(1800.0);
  EXPECT_NEAR(field.mass() + field.totals.blownOut[1] - field.totals.blownIn[1], before, 1e-9 * before);
  EXPECT_GT(field.totals.eroded[1], 0.0);
  for (const double swe : field.swe) ASSERT_GE(swe, 0.0);
  // What lay is what lies, by the totals too.
  EXPECT_NEAR(before - field.totals.eroded[1] + field.totals.deposited[1], field.mass(), 1e-9 * before);
}

TEST(SnowDrift, SixtyMetresASecondStaysFinite) {
  const double u = 60.0 * 0.4 / std::log(1000.0);
  Field field(test::landGraph(200, 20, 1.0, flat), {0.8f, -0.6f}, static_cast<float>(u), 30.0);
  field.settings.inflow = 0.0;
  const double before = field.mass();
  for (int hour = 0; hour < 3; ++hour) {
    const double start = field.mass();
    field.blow(3600.0);
    EXPECT_NEAR(field.mass() + field.totals.blownOut[1], start, 1e-9 * before);
  }
  for (const double swe : field.swe) ASSERT_TRUE(std::isfinite(swe) && swe >= 0.0);
  EXPECT_LT(field.mass(), 0.01 * before);  // swept bare
}

TEST(SnowDrift, CalmAirMovesNothing) {
  Field field(test::landGraph(10, 10, 1.0, flat), {0, 0}, 0.0f);
  const std::vector<double> before = field.swe;
  field.blow(3600.0);
  EXPECT_EQ(field.swe, before);
}

}  // namespace
}  // namespace spin
