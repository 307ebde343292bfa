// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/flow_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/render/flow_parts.h"
#include "tests/render/render_scene.h"

namespace spin::test {
namespace {

RenderNode settings(FlowDisplay shows) {
  RenderNode node;
  node.flowDisplay = shows;
  return node;
}

double luminance(Vec3d c) {
  return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
}

TEST(FlowScale, SpeedIsTheLengthOfTheVelocity) {
  ParticleSet set = particleBlock({0, 0, 0}, {2, 1, 1}, 1.0, 300.0);
  ASSERT_EQ(set.size(), 2u);
  set.attributes[0].values = {3, 0, 4, 0, 0, -2};
  EXPECT_EQ(flowValues(set, FlowDisplay::Speed), (std::vector<float>{5.0f, 2.0f}));
  EXPECT_EQ(flowValues(set, FlowDisplay::Density), (std::vector<float>{300.0f, 300.0f}));
  EXPECT_TRUE(flowValues(set, FlowDisplay::Pressure).empty()) << "the set has none";
  EXPECT_TRUE(flowValues(set, FlowDisplay::Material).empty());
  set.attributes[0].values.pop_back();
  EXPECT_TRUE(flowValues(set, FlowDisplay::Speed).empty()) << "damaged";
}

TEST(FlowScale, AFixedRangeIsTaken) {
  RenderNode node = settings(FlowDisplay::Speed);
  node.flowRangeAuto = false;
  node.flowRangeLow = 10.0;
  node.flowRangeHigh = 30.0;
  const FlowScale scale = flowScale(node, {0.0f, 100.0f});
  EXPECT_DOUBLE_EQ(scale.place(10.0), 0.0);
  EXPECT_DOUBLE_EQ(scale.place(15.0), 0.25);
  EXPECT_DOUBLE_EQ(scale.place(31.0), 1.0);
  EXPECT_DOUBLE_EQ(scale.place(std::numeric_limits<double>::quiet_NaN()), 0.0);
}

TEST(FlowScale, TheFramesRangeLeavesOutStrays) {
  std::vector<float> values;
  for (int k = 0; k < 1000; ++k) values.push_back(static_cast<float>(k) * 0.01f);
  values.push_back(1e6f);
  values.push_back(std::numeric_limits<float>::infinity());
  const FlowScale scale = flowScale(settings(FlowDisplay::Pressure), values);
  EXPECT_NEAR(scale.low, 0.1, 0.02);
  EXPECT_NEAR(scale.high, 9.9, 0.05);
}

TEST(FlowScale, AnyRangeGivesAUsableScale) {
  for (const bool logarithmic : {false, true})
    for (const auto& [low, high] :
         {std::pair{5.0, 5.0}, {7.0, -2.0}, {0.0, 0.0}, {-3.0, 4.0}, {1e-12, 1e9}}) {
      RenderNode node = settings(FlowDisplay::Viscosity);
      node.flowRangeAuto = false;
      node.flowRangeLow = low;
      node.flowRangeHigh = high;
      node.flowLogarithmic = logarithmic;
      const FlowScale scale = flowScale(node, {});
      EXPECT_LT(scale.low, scale.high) << low << " to " << high;
      if (logarithmic) {
        EXPECT_GT(scale.low, 0.0);
      }
      for (const double value : {-1.0, 0.0, 1.0, 1e12}) {
        EXPECT_GE(scale.place(value), 0.0);
        EXPECT_LE(scale.place(value), 1.0);
      }
    }
}

TEST(FlowScale, LogarithmicColoursGrowByFactors) {
  RenderNode node = settings(FlowDisplay::Viscosity);
  node.flowRangeAuto = false;
  node.flowRangeLow = 1.0;
  node.flowRangeHigh = 10000.0;
  node.flowLogarithmic = true;
  const FlowScale scale = flowScale(node, {});
  EXPECT_NEAR(scale.place(10.0), 0.25, 1e-12);
  EXPECT_NEAR(scale.place(100.0), 0.5, 1e-12);
}

TEST(FlowScale, TheColourMapGrowsBrighterAllTheWay) {
  const FlowScale scale;
  double before = -1.0;
  for (int k = 0; k <= 100; ++k) {
    const double now = luminance(scaleColour(scale, k / 100.0));
    EXPECT_GT(now, before) << "at " << k;
    before = now;
  }
  const Vec3d first = scaleColour(scale, 0.0), last = scaleColour(scale, 1.0);
  EXPECT_GT(first.z, first.y) << "violet";
  EXPECT_GT(last.x, 0.9 * last.y);
  EXPECT_LT(last.z, 0.1) << "yellow";
}

SnapshotPointer sceneShowing(const std::function<void(RenderNode&)>& edit) {
  SceneBuilder scene;
  scene.add<RenderNode>(kRenderType, "render", edit);
  return scene.build();
}

TEST(FlowLegend, IsThereOnlyWhereColoursStandForValues) {
  const auto frame = flowFrame(particleBlock({0, 0, 0}, {2, 2, 2}, 0.5, 300.0));
  const auto shows = [](FlowDisplay display, bool legend) {
    return sceneShowing([=](RenderNode& r) {
      r.flowDisplay = display;
      r.flowLegend = legend;
    });
  };
  EXPECT_FALSE(flowLegend(*shows(FlowDisplay::Material, true), frame.get(), 0.0));
  EXPECT_FALSE(flowLegend(*shows(FlowDisplay::Speed, false), frame.get(), 0.0));
  EXPECT_FALSE(flowLegend(*shows(FlowDisplay::Pressure, true), frame.get(), 0.0)) << "no such attribute";
  EXPECT_FALSE(flowLegend(*shows(FlowDisplay::Speed, true), nullptr, 0.0));
  const auto legend = flowLegend(*shows(FlowDisplay::Density, true), frame.get(), 0.0);
  ASSERT_TRUE(legend);
  EXPECT_STREQ(legend->title, "Density");
  EXPECT_EQ(legend->unit, "kg/m3");
  EXPECT_GE(legend->ticks.size(), 2u);
}

TEST(FlowLegend, TicksAreRoundNumbersAtTheirPlaces) {
  const auto scene = sceneShowing([](RenderNode& r) {
    r.flowDisplay = FlowDisplay::Speed;
    r.flowRangeAuto = false;
    r.flowRangeLow = 0.0;
    r.flowRangeHigh = 50.0;
  });
  const auto legend = flowLegend(*scene, flowFrame(particleBlock({0, 0, 0}, {1, 1, 1}, 0.5, 1.0)).get(), 0.0);
  ASSERT_TRUE(legend);
  std::vector<std::string> texts;
  for (const ValueLegend::Tick& tick : legend->ticks) {
    texts.push_back(tick.text);
    EXPECT_NEAR(tick.place, std::stod(tick.text) / 50.0, 1e-9);
  }
  EXPECT_EQ(texts, (std::vector<std::string>{"0", "10", "20", "30", "40", "50"}));
}

}  // namespace
}  // namespace spin::test
