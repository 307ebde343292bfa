// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.h"
#include "core/nodes/weather_nodes.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class FlakeDraw : public GlTest {
 protected:
  static std::shared_ptr<ParticlePart> flakes(int count, double box) {
    auto part = std::make_shared<ParticlePart>();
    part->particles.name = "flakes";
    part->particles.wrapBox = box;
    part->particles.weight = 100.0;
    ParticleAttribute diameter{"diameter", "m", 1, {}}, velocity{"velocity", "m/s", 3, {}};
    const CounterRandom random{3, 1};
    const float edge = static_cast<float>(box);
    for (int k = 0; k < count; ++k) {
      const auto u = [&](std::uint32_t draw) { return random.uniform(static_cast<std::uint64_t>(k), draw); };
      part->particles.positions.push_back({edge * u(0), edge * u(1), edge * u(2)});
      diameter.values.push_back(0.008f);
      velocity.values.insert(velocity.values.end(), {0.5f, 0.0f, -1.0f});
    }
    part->particles.attributes = {diameter, velocity};
    return part;
  }
  static FramePointer frameOf(std::shared_ptr<ParticlePart> part) {
    auto frame = std::make_shared<Frame>();
    frame->parts["flakes"] = std::move(part);
    return frame;
  }
  static SnapshotPointer night() {
    SceneBuilder scene;
    addWeather(scene);
    return scene.build();
  }
  static constexpr RenderCamera kView{{3, 4, 5}, {3, 14, 7}, 50};
};

TEST_F(FlakeDraw, FlakesAppearAndCanBeHidden) {
  const SnapshotPointer scene = night();
  const Picture without = draw(scene, nullptr, kView, sized(160, 90));
  const FramePointer frame = frameOf(flakes(4000, 16.0));
  EXPECT_GT(difference(without, draw(scene, frame, kView, sized(160, 90))), 0.15);
  RenderOptions hidden = sized(160, 90);
  hidden.showFlakes = false;
  EXPECT_EQ(difference(without, draw(scene, frame, kView, hidden)), 0.0);
}

TEST_F(FlakeDraw, TheBoxWrapsRoundTheCamera) {
  const SnapshotPointer scene = night();
  const FramePointer frame = frameOf(flakes(4000, 16.0));
  const Picture here = draw(scene, frame, kView, sized(160, 90));
  // Whole periods away the picture repeats; half a period away it does not.
  const Vec3d periods{32, -16, 48}, odd{8, 8, 0};
  const Picture there =
      draw(scene, frame, {kView.position + periods, kView.target + periods, 50}, sized(160, 90));
  const Picture between = draw(scene, frame, {kView.position + odd, kView.target + odd, 50}, sized(160, 90));
  EXPECT_LT(difference(here, there), 0.1 * difference(here, between));
}

TEST_F(FlakeDraw, SolidThingsHideFlakesBehindThem) {
  SceneBuilder builder;
  addWeather(builder);
  addModel(builder, "wall", boxModel({40, 0.2, 40}), {3, 5.2, -10});
  const SnapshotPointer scene = builder.build();
  // All flakes stand in one row behind the wall.
  auto part = flakes(500, 0.0);
  for (Vec3f& p : part->particles.positions) p = {p.x + 3.0f, 9.0f, p.z + 5.5f};
  EXPECT_EQ(difference(draw(scene, nullptr, kView, sized(160, 90)),
                       draw(scene, frameOf(part), kView, sized(160, 90))),
            0.0);
  for (Vec3f& p : part->particles.positions) p.y = 4.8f;
  auto before = std::make_shared<ParticlePart>(*part);
  EXPECT_GT(difference(draw(scene, nullptr, kView, sized(160, 90)),
                       draw(scene, frameOf(before), kView, sized(160, 90))),
            0.0);
}

TEST_F(FlakeDraw, NearFlakesHaveTheirTrueSize) {
  SceneBuilder builder;
  builder.add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) { w.cloudCover = 1.0; });
  addModel(builder, "wall", boxModel({40, 0.2, 40}), {3, 9, -10});
  const SnapshotPointer scene = builder.build();
  auto part = std::make_shared<ParticlePart>();
  part->particles.positions = {{3.0f, 6.0f, 5.0f}};
  part->particles.attributes = {{"diameter", "m", 1, {0.2f}}, {"velocity", "m/s", 3, {0.0f, 0.0f, 0.0f}}};
  const RenderCamera camera{{3, 4, 5}, {3, 14, 5}, 50};
  const Picture with = draw(scene, frameOf(part), camera, sized(200, 200));
  const Picture without = draw(scene, nullptr, camera, sized(200, 200));
  int touched = 0;
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 200; ++y) touched += std::abs(with.bright(x, y) - without.bright(x, y)) > 12;
  // 0.2 m at 2 m with 214 px per unit: 21 px across; the irregular shape fills a good part of that circle.
  EXPECT_GT(touched, 90);
  EXPECT_LT(touched, 460);
}

}  // namespace
}  // namespace spin::test
