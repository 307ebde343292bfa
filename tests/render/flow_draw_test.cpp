// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/render/flow_pass.h"
#include "tests/render/flow_parts.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class FlowDraw : public GlTest {
 protected:
  /// Level dark ground, the camera before it.
  static SceneBuilder ground(const std::function<void(RenderNode&)>& edit = [](RenderNode&) {}) {
    SceneBuilder scene;
    addWeather(scene);
    addGround(scene, 2);
    addTerrain(scene, 33, 33, [](int, int) { return 0.0; });
    scene.add<RenderNode>(kRenderType, "render", edit);
    return scene;
  }
  static SnapshotPointer showing(FlowDisplay display, double low, double high) {
    return ground([=](RenderNode& r) {
             r.flowDisplay = display;
             r.flowRangeAuto = false;
             r.flowRangeLow = low;
             r.flowRangeHigh = high;
           })
        .build();
  }
  static constexpr RenderCamera kView{{80, 60, 6}, {80, 80, 1}, 40};
  /// A block of particles in the middle of the view, 8 m wide, 3 m deep and high.
  static ParticleSet block(double density) { return particleBlock({76, 78, 0}, {84, 81, 3}, 0.25, density); }
};

/// Whether two pictures differ at a pixel.
bool touched(const Picture& a, const Picture& b, int x, int y) {
  return std::abs(a.red(x, y) - b.red(x, y)) + std::abs(a.green(x, y) - b.green(x, y)) +
             std::abs(a.blue(x, y) - b.blue(x, y)) >
         12;
}

TEST_F(FlowDraw, TheSurfaceIsWhereTheParticlesAre) {
  const SnapshotPointer scene = ground().build();
  const Picture without = draw(scene, nullptr, kView, sized(200, 120));
  const Picture with = draw(scene, flowFrame(block(300.0)), kView, sized(200, 120));
  // The front face covers columns 64 to 136 and rows 47 to 72.
  int inside = 0, missed = 0, beyond = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 200; ++x) {
      const bool is = touched(without, with, x, y);
      const bool core = x > 68 && x < 132 && y > 50 && y < 71;
      const bool away = x < 55 || x > 145 || y < 36 || y > 96;
      inside += core;
      missed += core && !is;
      beyond += away && is && y < 60;
    }
  EXPECT_GT(inside, 1000);
  EXPECT_EQ(missed, 0) << "holes in the surface";
  EXPECT_EQ(beyond, 0) << "something where nothing flows";
}

TEST_F(FlowDraw, SnowIsWhiteAndWaterIsDarkBesideIt) {
  const SnapshotPointer scene = ground().build();
  const Picture snow = draw(scene, flowFrame(block(300.0)), kView, sized(200, 120));
  const Picture water = draw(scene, flowFrame(block(1000.0)), kView, sized(200, 120));
  EXPECT_GT(snow.bright(100, 66), 150);
  EXPECT_LT(std::abs(snow.red(100, 66) - snow.blue(100, 66)), 45) << "without a hue";
  EXPECT_LT(water.bright(100, 66), snow.bright(100, 66) - 40);
  EXPECT_LT(water.red(100, 66), water.blue(100, 66));
}

TEST_F(FlowDraw, ValuesGetTheirColours) {
  ParticleSet set = block(300.0);
  ParticleAttribute& velocity = set.attributes[0];
  ASSERT_EQ(velocity.name, "velocity");
  // 10 m/s in the left half, 30 m/s in the right one.
  for (std::size_t k = 0; k < set.size(); ++k)
    velocity.values[3 * k] = set.positions[k].x < 80.0f ? 10.0f : 30.0f;
  const SnapshotPointer scene = showing(FlowDisplay::Speed, 10.0, 30.0);
  const Picture p = draw(scene, flowFrame(set), kView, sized(200, 120));
  FlowScale scale;
  const auto expectHue = [&](int x, double place) {
    // Light scales all three channels alike; their ratios tell the colour.
    const Vec3d colour = scaleColour(scale, place);
    const auto linear = [](int byte) {
      const double s = byte / 255.0;
      return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    const Vec3d seen{linear(p.red(x, 66)), linear(p.green(x, 66)), linear(p.blue(x, 66))};
    EXPECT_GT(dot(seen, colour) / (length(seen) * length(colour)), 0.995) << "at column " << x;
    EXPECT_GT(length(seen) / length(colour), 0.5);
  };
  expectHue(80, 0.0);
  expectHue(120, 1.0);
}

TEST_F(FlowDraw, FastSnowRaisesDustAndSlowSnowHardlyAny) {
  const SnapshotPointer scene = ground().build();
  const Picture without = draw(scene, nullptr, kView, sized(200, 120));
  const auto dustAbove = [&](float speed) {
    ParticleSet set = block(300.0);
    for (std::size_t k = 0; k < set.size(); ++k) set.attributes[0].values[3 * k] = speed;
    set.attributes[2].values.assign(set.size(), 8.0f);
    const Picture with = draw(scene, flowFrame(set), kView, sized(200, 120));
    int count = 0;
    // The block's top is in row 47.
    for (int y = 0; y < 36; ++y)
      for (int x = 0; x < 200; ++x) count += touched(without, with, x, y);
    return count;
  };
  EXPECT_EQ(dustAbove(0.0f), 0);
  const int slow = dustAbove(8.0f), fast = dustAbove(30.0f);
  EXPECT_GT(fast, 1000);
  EXPECT_LT(slow, fast / 5);
}

TEST_F(FlowDraw, TornWaterRaisesNoDust) {
  const SnapshotPointer scene = ground().build();
  ParticleSet whole = block(1000.0);
  for (std::size_t k = 0; k < whole.size(); ++k) whole.attributes[0].values[3 * k] = 30.0f;
  whole.attributes[2].values.assign(whole.size(), 8.0f);
  whole.attributes.push_back({"material", "", 1, std::vector<float>(whole.size(), 1.0f)});
  ParticleSet torn = whole;
  for (std::size_t k = 0; k < torn.size(); k += 5) torn.attributes[1].values[k] = 600.0f;
  const Picture a = draw(scene, flowFrame(whole), kView, sized(200, 120)),
                b = draw(scene, flowFrame(torn), kView, sized(200, 120));
  int differ = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 200; ++x) differ += touched(a, b, x, y);
  EXPECT_EQ(differ, 0);
}

TEST_F(FlowDraw, WhatStandsBeforeHidesTheFlow) {
  SceneBuilder builder = ground();
  addModel(builder, "wall", boxModel({60, 0.2, 30}), {80, 75, 0});
  const SnapshotPointer scene = builder.build();
  // The wall's shadow map changes with the flow; compare a column of the wall in front of it.
  const Picture without = draw(scene, nullptr, kView, sized(200, 120));
  const Picture with = draw(scene, flowFrame(block(300.0)), kView, sized(200, 120));
  for (int x = 70; x < 130; x += 10) EXPECT_LE(std::abs(without.bright(x, 66) - with.bright(x, 66)), 2);
  SceneBuilder hilly;
  addWeather(hilly);
  addGround(hilly, 2);
  addTerrain(hilly, 33, 33, [](int, int j) { return j == 14 ? 12.0 : 0.0; });
  const SnapshotPointer hidden = hilly.build();
  EXPECT_LT(difference(draw(hidden, nullptr, kView, sized(200, 120)),
                       draw(hidden, flowFrame(block(300.0)), kView, sized(200, 120))),
            0.5);
}

TEST_F(FlowDraw, TheFlowShadesTheGround) {
  SceneBuilder builder;
  builder.add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) {
    w.cloudCover = 0.0;
    w.sunElevationDegrees = 30.0;
    w.sunAzimuthDegrees = 270.0;  // from the left
  });
  addGround(builder, 1);
  addTerrain(builder, 33, 33, [](int, int) { return 0.0; });
  const SnapshotPointer scene = builder.build();
  const RenderCamera above{{80, 79, 40}, {80, 80, 0}, 45};
  const Picture without = draw(scene, nullptr, above, sized(160, 160));
  const Picture with = draw(scene, flowFrame(block(300.0)), above, sized(160, 160));
  // 3 m high, the sun at 30 degrees: 5 m of shade to the right of x = 84. A pixel is 0.2 m.
  const int right = 80 + static_cast<int>(6.0 / 0.2), left = 80 - static_cast<int>(6.0 / 0.2);
  EXPECT_LT(with.bright(right, 82), without.bright(right, 82) * 0.8);
  EXPECT_NEAR(with.bright(left, 82), without.bright(left, 82), 6);
}

TEST_F(FlowDraw, BoundaryParticlesAreShownOnRequestOnly) {
  auto frame = std::make_shared<Frame>(*flowFrame(particleBlock({10, 10, 0}, {11, 11, 1}, 0.25, 300.0)));
  auto part = std::make_shared<ParticlePart>();
  part->particles = block(0.0);
  frame->parts["flow_boundary"] = part;
  const SnapshotPointer plain = ground().build();
  const SnapshotPointer asked = ground([](RenderNode& r) { r.showFlowBoundary = true; }).build();
  const Picture nothing = draw(plain, nullptr, kView, sized(160, 90));
  EXPECT_LT(difference(nothing, draw(plain, frame, kView, sized(160, 90))), 0.3);
  EXPECT_GT(difference(nothing, draw(asked, frame, kView, sized(160, 90))), 3.0);
}

TEST_F(FlowDraw, BandsGiveTheSamePicture) {
  const SnapshotPointer scene = ground().build();
  s_renderer->setScene(scene);
  s_renderer->setFrame(flowFrame(block(1000.0)));
  const Picture whole = drawPicture(*s_renderer, kView, sized(160, 90));
  const Picture bands =
      drawPicture(*s_renderer, kView, sized(160, 90), {{0.0, 0.3}, {0.3, 0.55}, {0.55, 1.0}});
  EXPECT_EQ(difference(whole, bands), 0.0);
}

TEST_F(FlowDraw, OddSetsAreDrawnWithoutHarm) {
  const SnapshotPointer scene = showing(FlowDisplay::Viscosity, 5.0, 5.0);  // an empty range
  const Picture nothing = draw(scene, nullptr, kView, sized(64, 48));
  ParticleSet empty;
  EXPECT_EQ(difference(nothing, draw(scene, flowFrame(empty), kView, sized(64, 48))), 0.0);
  ParticleSet bare = block(300.0);
  bare.attributes.clear();
  draw(scene, flowFrame(bare), kView, sized(64, 48));
  ParticleSet one = particleBlock({80, 79, 1}, {80.2, 79.2, 1.2}, 0.25, 300.0);
  EXPECT_EQ(one.size(), 1u);
  draw(scene, flowFrame(one), kView, sized(64, 48));
  // All round the eye, some at it.
  draw(scene, flowFrame(particleBlock({78, 58, 4}, {82, 62, 8}, 0.25, 1000.0)), kView, sized(64, 48));
}

}  // namespace
}  // namespace spin::test
