// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/flake/flake_atlas.h"
#include "core/nodes/weather_nodes.h"
#include "core/snow/flake_field.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

/// Flakes of one size that stand still in the air.
std::shared_ptr<FlakesPart> standing(double diameter, double perCubicMetre, double cover) {
  auto part = std::make_shared<FlakesPart>();
  FlakeClass one;
  one.diameter = diameter;
  part->flakes.classes.assign(kFlakeClasses, one);
  part->flakes.numberDensity = perCubicMetre;
  part->flakes.cover = cover;
  return part;
}

FramePointer frameOf(std::shared_ptr<FlakesPart> part) {
  auto frame = std::make_shared<Frame>();
  frame->parts["flakes"] = std::move(part);
  return frame;
}

SnowfallNode fewFlakes() {
  SnowfallNode snowfall;
  snowfall.boxSize = 4.0;
  snowfall.groups = 1;
  snowfall.flakeCount = 16;
  return snowfall;
}

SnapshotPointer sceneOf(const SnowfallNode& snowfall, const std::function<void(SceneBuilder&)>& more = {}) {
  SceneBuilder scene;
  addWeather(scene);
  scene.add<SnowfallNode>(kSnowfallType, "snowfall", [&](SnowfallNode& node) { node = snowfall; });
  if (more) more(scene);
  return scene.build();
}

class FlakeDraw : public GlTest {
 protected:
  void TearDown() override {
    s_renderer->setFlakeAtlas(nullptr);
    GlTest::TearDown();
  }

  static SnowfallNode manyFlakes() {
    SnowfallNode snowfall;
    snowfall.boxSize = 16.0;
    snowfall.flakeCount = 40000;
    return snowfall;
  }
  static constexpr RenderCamera kView{{3, 4, 5}, {3, 14, 7}, 50};

  /// A camera at the origin that looks at one of few flakes, which nothing else is near.
  static RenderCamera atOneFlake(const FallingFlakes& flakes, const SnowfallNode& snowfall) {
    const auto groups = flakeGroups(snowfall, flakes.numberDensity);
    const FlakeField field(flakes.seed, groups);
    FlakeRecords seen;
    CpuBackend backend(1);
    field.look(flakes, groups, {}, backend, seen);
    for (std::size_t k = 0; k < seen.count; ++k) {
      const auto at = [&](FlakeValue v) { return static_cast<double>(seen[v][k]); };
      const Vec3d p{at(FlakeValue::X), at(FlakeValue::Y), at(FlakeValue::Z)};
      if (length(p) > 0.7 && length(p) < 1.5 && at(FlakeValue::Fade) > 0.999) return {{}, p, 30.0};
    }
    ADD_FAILURE() << "no flake stands well";
    return {};
  }
  /// All that the flakes add to a picture, in linear light.
  double lightOf(const FramePointer& frame, const SnapshotPointer& scene, const RenderCamera& camera) {
    const auto sum = [&](FramePointer shown) {
      s_renderer->setScene(scene);
      s_renderer->setFrame(std::move(shown));
      const auto pixels = s_renderer->drawLinear(camera, 0.0, sized(240, 240), 4);
      EXPECT_TRUE(pixels.ok());
      double all = 0.0;
      for (std::size_t k = 0; k < pixels->size(); k += 4) all += static_cast<double>((*pixels)[k]);
      return all;
    };
    return std::abs(sum(frame) - sum(nullptr));
  }
};

TEST_F(FlakeDraw, FlakesAppearAndCanBeHidden) {
  const SnapshotPointer scene = sceneOf(manyFlakes());
  const Picture without = draw(scene, nullptr, kView, sized(160, 90));
  const FramePointer frame = frameOf(standing(0.004, 3000.0, 0.4));
  EXPECT_GT(difference(without, draw(scene, frame, kView, sized(160, 90))), 0.15);
  RenderOptions hidden = sized(160, 90);
  hidden.showFlakes = false;
  EXPECT_EQ(difference(without, draw(scene, frame, kView, hidden)), 0.0);
  EXPECT_EQ(difference(without, draw(scene, frameOf(standing(0.004, 0.0, 0.4)), kView, sized(160, 90))), 0.0);
}

TEST_F(FlakeDraw, AMovingCameraMakesNoFlakePop) {
  const SnapshotPointer scene = sceneOf(manyFlakes());
  const FramePointer frame = frameOf(standing(0.004, 3000.0, 0.4));
  const auto from = [&](Vec3d by) {
    return draw(scene, frame, {kView.position + by, kView.target + by, 50}, sized(160, 90));
  };
  const Picture here = from({});
  EXPECT_LT(difference(here, from({1e-4, 0, 0})), 0.03 * difference(here, from({3.7, 1.1, 0.4})));
}

TEST_F(FlakeDraw, SolidThingsHideFlakesBehindThem) {
  const auto wall = [](double y) {
    return sceneOf(manyFlakes(), [y](SceneBuilder& b) {
      addModel(b, "wall", boxModel({40, 0.2, 40}), {3, y, -10});
    });
  };
  const FramePointer frame = frameOf(standing(0.004, 3000.0, 0.4));
  const auto shown = [&](const SnapshotPointer& scene) {
    return difference(draw(scene, nullptr, kView, sized(160, 90)), draw(scene, frame, kView, sized(160, 90)));
  };
  EXPECT_LT(shown(wall(4.5)), 0.25 * shown(wall(11.0)));
}

TEST_F(FlakeDraw, WhatAFlakeHidesDoesNotDependOnHowItIsDrawn) {
  const SnowfallNode snowfall = fewFlakes();
  const double perVolume = 16.0 / 64.0;  // each stands for itself
  const auto flakes = standing(0.04, perVolume, 0.4);
  const SnapshotPointer scene = sceneOf(snowfall);
  const RenderCamera camera = atOneFlake(flakes->flakes, snowfall);
  const double plain = lightOf(frameOf(flakes), scene, camera);
  ASSERT_GT(plain, 1.0);
  // A grown shape instead of a disc.
  const auto disc = drawFlake({{0.0, 0.0}, {3.0, 0.0}, {-3.0, 0.0}, {0.0, 3.0}, {0.0, -3.0}}, 128);
  ASSERT_TRUE(disc.ok());
  auto atlas = makeFlakeAtlas({*disc}, {1e-3}, 64, {});
  ASSERT_TRUE(atlas.ok());
  s_renderer->setFlakeAtlas(std::make_shared<const FlakeAtlas>(*atlas));
  EXPECT_NEAR(lightOf(frameOf(flakes), scene, camera) / plain, 1.0, 0.25);  // frames cover by their tilt
  // A swarm in place of six flakes, still and in motion.
  const auto one = standing(0.015, perVolume, 0.4), six = standing(0.015, 6.0 * perVolume, 0.4);
  const double single = lightOf(frameOf(one), scene, camera);
  EXPECT_NEAR(lightOf(frameOf(six), scene, camera) / single, 6.0, 0.9);
  auto fastSix = std::make_shared<FlakesPart>(*six);
  for (FlakeClass& c : fastSix->flakes.classes) c.velocity = {2.0, 0.5, -1.0};
  EXPECT_NEAR(lightOf(frameOf(fastSix), scene, camera) / single, 6.0, 0.9);
  s_renderer->setFlakeAtlas(nullptr);
  // Drawn out by its motion.
  auto fast = std::make_shared<FlakesPart>(*flakes);
  for (FlakeClass& c : fast->flakes.classes) c.velocity = {1.0, 0.5, -1.0};
  EXPECT_NEAR(lightOf(frameOf(fast), scene, camera) / plain, 1.0, 0.06);
  // Twice as many in the air, each twice as much.
  auto often = std::make_shared<FlakesPart>(*flakes);
  often->flakes.numberDensity *= 2.0;
  EXPECT_NEAR(lightOf(frameOf(often), scene, camera) / plain, 2.0, 0.1);
  // Smaller than a pixel.
  const auto tiny = standing(0.002, perVolume, 0.4);
  EXPECT_NEAR(lightOf(frameOf(tiny), scene, camera) / plain, 2.5e-3, 3e-4);
}

TEST_F(FlakeDraw, TheSizeLawShrinksNearFlakes) {
  SnowfallNode snowfall = fewFlakes();
  const auto flakes = standing(0.04, 16.0 / 64.0, 0.4);
  const RenderCamera camera = atOneFlake(flakes->flakes, snowfall);
  const double plain = lightOf(frameOf(flakes), sceneOf(snowfall), camera);
  snowfall.sizeLawA = 4.0 * std::pow(std::tan(0.5 * 30.0 * kPi / 180.0) * length(camera.target), 2);
  EXPECT_NEAR(lightOf(frameOf(flakes), sceneOf(snowfall), camera) / plain, 0.5, 0.05);
}

}  // namespace
}  // namespace spin::test
