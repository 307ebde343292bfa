// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "core/nodes/settings_nodes.h"
#include "core/nodes/weather_nodes.h"
#include "editor/render/value_scale.h"
#include "tests/render/air_parts.h"
#include "tests/render/flow_parts.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

constexpr double kDrop = 30e-6;
/// kg/m3 of mist for an extinction of 1/m.
constexpr double kPerExtinction = 1000.0 * kDrop / 3.0;

class AirDraw : public GlTest {
 protected:
  static SceneBuilder ground(const std::function<void(RenderNode&)>& edit = [](RenderNode&) {}) {
    SceneBuilder scene;
    addWeather(scene);
    addGround(scene, 2);
    addTerrain(scene, 33, 33, [](int, int) { return 0.0; });
    scene.add<RenderNode>(kRenderType, "render", edit);
    return scene;
  }
  static constexpr RenderCamera kView{{80, 60, 6}, {80, 100, 6}, 20};

  static std::shared_ptr<Frame> mist(Vec3d low, Vec3d high, double cell,
                                     const std::function<double(Vec3d)>& extinction) {
    const auto part = airBricks(low, high, cell);
    part->dropDiameter = kDrop;
    addField(*part, "mist", "kg/m3", 1e-3f, [&](Vec3d p) { return kPerExtinction * extinction(p); });
    return airFrame(part);
  }
  /// 16 m deep between the eye and what stands at y = 90.
  static std::shared_ptr<Frame> slab(double extinction) {
    return mist({72, 68, 0}, {88, 84, 16}, 1.0, [=](Vec3d) { return extinction; });
  }
  static std::vector<float> linear(SnapshotPointer scene, FramePointer frame, int width, int height) {
    s_renderer->setScene(std::move(scene));
    s_renderer->setFrame(std::move(frame));
    auto pixels = s_renderer->drawLinear(kView, 0.0, sized(width, height), 1);
    EXPECT_TRUE(pixels.ok());
    return std::move(pixels).value();
  }
  /// What is left of the contrast between two quarters of a coloured square at (80, y, 5).
  static double keptContrast(double y, FramePointer frame) {
    SceneBuilder builder = ground();
    addModel(builder, "square", texturedSquare(), {80, y, 5});
    const SnapshotPointer scene = builder.build();
    constexpr int kWidth = 240, kHeight = 160;
    const double scale = 0.5 * kHeight / std::tan(0.5 * 20.0 * 3.14159265 / 180.0) / (y - 60.0);
    const auto contrast = [&](const std::vector<float>& pixels) {
      const auto redAt = [&](double x, double z) {
        const auto px = static_cast<std::size_t>(0.5 * kWidth + scale * (x - 80.0));
        const auto py = static_cast<std::size_t>(0.5 * kHeight - scale * (z - 6.0));
        return static_cast<double>(pixels[4 * (py * kWidth + px)]);
      };
      // Red is in the left quarter above, blue below it.
      return redAt(79.5, 6.5) - redAt(79.5, 5.5);
    };
    const double bare = contrast(linear(scene, nullptr, kWidth, kHeight));
    EXPECT_GT(bare, 0.1);
    return contrast(linear(scene, std::move(frame), kWidth, kHeight)) / bare;
  }
};

TEST_F(AirDraw, ASlabLetsThroughWhatBeerSays) {
  for (const double extinction : {0.02, 0.06, 0.15})
    EXPECT_NEAR(keptContrast(90.0, slab(extinction)) / std::exp(-16.0 * extinction), 1.0, 0.04) << extinction;
}

TEST_F(AirDraw, TheWayEndsAtTheScene) {
  EXPECT_NEAR(keptContrast(76.0, slab(0.1)), std::exp(-0.8), 0.04);
  EXPECT_NEAR(keptContrast(66.0, slab(1.0)), 1.0, 0.01);
}

TEST_F(AirDraw, CellsOfAnySizeLetThroughTheSame) {
  for (const double cell : {0.25, 2.0})
    EXPECT_NEAR(keptContrast(110.0, mist({64, 68, 0}, {96, 100, 16}, cell,
                                         [](Vec3d p) { return p.y < 84.0 ? 0.06 : 0.0; })),
                std::exp(-16.0 * 0.06), 0.03)
        << cell;
}

TEST_F(AirDraw, AWallHidesACloudBehindIt) {
  SceneBuilder builder = ground();
  addModel(builder, "wall", boxModel({60, 0.2, 30}), {80, 65, 0});
  const SnapshotPointer scene = builder.build();
  const Picture without = draw(scene, nullptr, kView, sized(160, 90));
  EXPECT_LT(difference(without, draw(scene, slab(0.5), kView, sized(160, 90))), 0.05);
}

TEST_F(AirDraw, NothingIsDrawnWhereNothingHangs) {
  const SnapshotPointer scene = ground().build();
  const Picture without = draw(scene, nullptr, kView, sized(160, 90));
  EXPECT_EQ(difference(without, draw(scene, airFrame(std::make_shared<AirPart>()), kView, sized(160, 90))),
            0.0);
  EXPECT_EQ(difference(without, draw(scene, slab(0.0), kView, sized(160, 90))), 0.0);
  const auto behind = mist({72, 20, 0}, {88, 36, 16}, 1.0, [](Vec3d) { return 1.0; });
  EXPECT_LT(difference(without, draw(scene, behind, kView, sized(160, 90))), 0.05);
  EXPECT_GT(difference(without, draw(scene, slab(0.5), kView, sized(160, 90))), 5.0);
  EXPECT_EQ(difference(without, draw(scene, nullptr, kView, sized(160, 90))), 0.0);
}

/// Lumps of some metres.
double lumps(Vec3d p) {
  const double wave = std::sin(0.9 * p.x) + std::sin(0.8 * p.y + 1.0) + std::sin(1.1 * p.z);
  return std::max(0.0, 0.08 * (wave + 1.0));
}

TEST_F(AirDraw, TheSameCloudGivesTheSameBytesInBandsToo) {
  const SnapshotPointer scene = ground().build();
  const auto frame = mist({70, 68, 0}, {94, 92, 16}, 0.5, lumps);
  const Picture first = draw(scene, frame, kView, sized(161, 91));
  draw(scene, nullptr, kView, sized(64, 64));
  EXPECT_EQ(difference(first, draw(scene, frame, kView, sized(161, 91))), 0.0);
  const Picture bands =
      drawPicture(*s_renderer, kView, sized(161, 91), {{0.0, 0.3}, {0.3, 0.55}, {0.55, 1.0}});
  EXPECT_EQ(difference(first, bands), 0.0);
}

TEST_F(AirDraw, BricksLeaveNoSeams) {
  const SnapshotPointer scene = ground().build();
  // The same cells, cut into bricks and blocks at other places.
  const auto inside = [](Vec3d p) {
    return p.x > 70.0 && p.x < 90.0 && p.y > 68.0 && p.y < 84.0 && p.z < 12.0 ? lumps(p) : 0.0;
  };
  const Picture a = draw(scene, mist({62, 62, 0}, {98, 92, 16}, 0.5, inside), kView, sized(200, 120));
  const Picture b =
      draw(scene, mist({62 - 3.5, 62 - 2.5, -1.5}, {98, 92, 16}, 0.5, inside), kView, sized(200, 120));
  int most = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) most = std::max(most, std::abs(a.rgb[k] - b.rgb[k]));
  EXPECT_LT(difference(a, b), 0.3);
  EXPECT_LE(most, 8);
  // And an even cloud is even.
  const Picture even =
      draw(scene, mist({56, 68, 0}, {104, 84, 48}, 1.0, [](Vec3d) { return 0.1; }), kView, sized(200, 120));
  for (int x = 21; x < 180; ++x) EXPECT_LE(std::abs(even.bright(x, 30) - even.bright(x - 1, 30)), 2) << x;
}

TEST_F(AirDraw, ThickPowderInTheSunIsWhiteAndDarkerOnItsOtherSide) {
  SceneBuilder builder;
  builder.add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) {
    w.cloudCover = 0.0;
    w.sunElevationDegrees = 35.0;
    w.sunAzimuthDegrees = 270.0;  // from the left
  });
  addGround(builder, 1);
  addTerrain(builder, 33, 33, [](int, int) { return 0.0; });
  const auto part = airBricks({64, 68, 0}, {96, 92, 12}, 0.5);
  addField(*part, "snow", "kg/m3", 1.0f, [](Vec3d p) {
    const Vec3d q = p - Vec3d{80, 80, 5};
    return length(q) < 4.0 ? 3.0 : 0.0;
  });
  const Picture p = draw(builder.build(), airFrame(part), kView, sized(200, 120));
  // A ball of 4 m 20 m away: 68 pixels to either side.
  const int lit = p.bright(70, 50), shaded = p.bright(135, 70);
  EXPECT_GT(lit, 215);
  EXPECT_LT(shaded, lit - 40);
  EXPECT_GT(shaded, 90) << "light comes through and round";
  EXPECT_LT(std::abs(p.red(70, 50) - p.blue(70, 50)), 40);
}

TEST_F(AirDraw, ACloudShadesTheGroundBeyondIt) {
  SceneBuilder builder;
  builder.add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) {
    w.cloudCover = 0.0;
    w.sunElevationDegrees = 45.0;
    w.sunAzimuthDegrees = 270.0;  // from the left
  });
  addGround(builder, 1);
  addTerrain(builder, 33, 33, [](int, int) { return 0.0; });
  const SnapshotPointer scene = builder.build();
  const RenderCamera above{{80, 79, 60}, {80, 80, 0}, 45};
  const auto cloud = mist({72, 76, 8}, {80, 84, 16}, 0.5, [](Vec3d) { return 3.0; });
  const Picture without = draw(scene, nullptr, above, sized(160, 160));
  const Picture with = draw(scene, cloud, above, sized(160, 160));
  // It hangs 8 to 16 m high over x = 72 to 80: its shadow lies at x = 80 to 96. A pixel is 0.31 m.
  EXPECT_LT(with.bright(80 + 32, 80), without.bright(80 + 32, 80) * 0.75);
  EXPECT_NEAR(with.bright(80 - 48, 80), without.bright(80 - 48, 80), 3);
  EXPECT_NEAR(with.bright(80 + 72, 80), without.bright(80 + 72, 80), 3);
}

Vec3d linearAt(const Picture& p, int x, int y) {
  const auto decode = [](int byte) {
    const double s = byte / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  return {decode(p.red(x, y)), decode(p.green(x, y)), decode(p.blue(x, y))};
}

/// A little of what is behind still shines through.
void expectHue(const Picture& p, int x, int y, double place) {
  const Vec3d colour = scaleColour({}, place), seen = linearAt(p, x, y);
  EXPECT_GT(dot(seen, colour) / (length(seen) * length(colour)), 0.96) << "at " << x << ", " << y;
}

/// Warm to the right, as a part and as the settings that show it.
std::shared_ptr<Frame> warmFrame() {
  const auto part = airBricks({72, 68, 0}, {88, 84, 16}, 1.0);
  addField(*part, "mist", "kg/m3", 1e-3f, [](Vec3d) { return 0.02; });
  addField(*part, "temperature", "K", 1.0f, [](Vec3d p) { return p.x < 80.0 ? 0.0 : 4.0; });
  return airFrame(part);
}

TEST_F(AirDraw, ValuesGetTheirColours) {
  const auto showing = [](AirSlice slice, double position) {
    return ground([=](RenderNode& r) {
             r.airDisplay = AirDisplay::Temperature;
             r.airRangeAuto = false;
             r.airRangeHigh = 4.0;
             r.airSlice = slice;
             r.airSlicePosition = position;
           })
        .build();
  };
  const Picture cloud = draw(showing(AirSlice::Off, 0.0), warmFrame(), kView, sized(200, 120));
  expectHue(cloud, 70, 60, 0.0);
  expectHue(cloud, 130, 60, 1.0);
  const Picture slice = draw(showing(AirSlice::AcrossY, 76.0), warmFrame(), kView, sized(200, 120));
  expectHue(slice, 70, 60, 0.0);
  expectHue(slice, 130, 60, 1.0);
  const Picture bare = draw(ground().build(), nullptr, kView, sized(200, 120));
  EXPECT_EQ(difference(bare, draw(showing(AirSlice::AcrossY, 300.0), warmFrame(), kView, sized(200, 120))),
            0.0);
  // What the frame does not tell is not shown.
  const SnapshotPointer other = ground([](RenderNode& r) { r.airDisplay = AirDisplay::Divergence; }).build();
  EXPECT_EQ(difference(bare, draw(other, warmFrame(), kView, sized(200, 120))), 0.0);
}

std::shared_ptr<Frame> withSpray(std::shared_ptr<const Frame> frame, double y) {
  auto part = std::make_shared<ParticlePart>();
  ParticleSet& set = part->particles;
  set.name = "spray";
  ParticleAttribute velocity{"velocity", "m/s", 3, {}}, diameter{"diameter", "m", 1, {}},
      mass{"mass", "kg", 1, {}}, age{"age", "s", 1, {}};
  for (int k = 0; k < 400; ++k) {
    set.positions.push_back(Vec3d{78.0 + 0.2 * (k % 20), y, 4.0 + 0.2 * (k / 20)}.to<float>());
    set.ids.push_back(static_cast<std::uint64_t>(k));
    velocity.values.insert(velocity.values.end(), {0.0f, 0.0f, -8.0f});
    diameter.values.push_back(1e-3f);
    mass.values.push_back(0.1f);
    age.values.push_back(0.2f);
  }
  set.attributes = {velocity, diameter, mass, age};
  auto both = std::make_shared<Frame>(*frame);
  both->parts["spray"] = std::move(part);
  return both;
}

TEST_F(AirDraw, SprayIsBrightAndHiddenByWhatStandsBefore) {
  const SnapshotPointer scene = ground().build();
  const auto nothing = std::make_shared<Frame>();
  const Picture bare = draw(scene, nullptr, kView, sized(200, 120));
  const Picture spray = draw(scene, withSpray(nothing, 80.0), kView, sized(200, 120));
  EXPECT_GT(spray.bright(100, 85), bare.bright(100, 85) + 30);
  EXPECT_EQ(spray.bright(20, 60), bare.bright(20, 60));
  SceneBuilder builder = ground();
  addModel(builder, "wall", boxModel({60, 0.2, 30}), {80, 65, 0});
  const SnapshotPointer walled = builder.build();
  EXPECT_EQ(difference(draw(walled, nullptr, kView, sized(200, 120)),
                       draw(walled, withSpray(nothing, 80.0), kView, sized(200, 120))),
            0.0);
  // Thick mist hides what is behind it and not what is before it.
  const Picture mist = draw(scene, slab(0.6), kView, sized(200, 120));
  EXPECT_LT(difference(mist, draw(scene, withSpray(slab(0.6), 88.0), kView, sized(200, 120))), 0.3);
  EXPECT_GT(difference(mist, draw(scene, withSpray(slab(0.6), 66.0), kView, sized(200, 120))), 1.0);
}

TEST_F(AirDraw, LooseWaterIsSprayAndNoSurface) {
  const SnapshotPointer scene = ground().build();
  const Picture bare = draw(scene, nullptr, kView, sized(200, 120));
  ParticleSet set = particleBlock({78, 78, 2}, {82, 80, 5}, 0.25, 1000.0);
  ParticleAttribute& neighbours = set.attributes[2];
  ASSERT_EQ(neighbours.name, "neighbours");
  const Picture whole = draw(scene, flowFrame(set), kView, sized(200, 120));
  for (float& n : neighbours.values) n = 2.0f;
  const Picture torn = draw(scene, flowFrame(set), kView, sized(200, 120));
  EXPECT_GT(torn.bright(100, 100), whole.bright(100, 100) + 30) << "white, not clear";
  EXPECT_GT(torn.bright(100, 100), bare.bright(100, 100) + 30);
  // Colours of values show all particles.
  const SnapshotPointer speeds = ground([](RenderNode& r) { r.flowDisplay = FlowDisplay::Speed; }).build();
  const Picture coloured = draw(speeds, flowFrame(set), kView, sized(200, 120));
  EXPECT_LT(coloured.bright(100, 100), 90) << "the darkest colour";
}

TEST_F(AirDraw, MistHangsBeforeWater) {
  const SnapshotPointer scene = ground().build();
  const ParticleSet water = particleBlock({76, 92, 0}, {84, 96, 6}, 0.25, 1000.0);
  const auto clear = flowFrame(water);
  auto misty = std::make_shared<Frame>(*clear);
  misty->parts["air"] = slab(0.3)->parts.at("air");
  const Picture bare = draw(scene, clear, kView, sized(200, 120));
  const Picture hidden = draw(scene, misty, kView, sized(200, 120));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  EXPECT_GT(difference(bare, hidden), 5.0);
}

TEST_F(AirDraw, OddPartsAreDrawnWithoutHarm) {
  const SnapshotPointer scene = ground().build();
  const auto far = airBricks({0, 0, 0}, {16, 4, 4}, 1.0);
  far->bricks.push_back({2'000'000'000, 2'000'000'000, 2'000'000'000});
  addField(*far, "mist", "kg/m3", 1.0f, [](Vec3d) { return 1.0; });
  draw(scene, airFrame(far), kView, sized(64, 48));
  // The eye within it, one brick only, and densities beyond those of halves.
  draw(scene, mist({72, 52, 0}, {88, 68, 16}, 1.0, [](Vec3d) { return 0.2; }), kView, sized(64, 48));
  draw(scene, mist({80, 80, 0}, {96, 84, 4}, 1.0, [](Vec3d) { return 1.0; }), kView, sized(1, 1));
  const auto heavy = airBricks({72, 68, 0}, {88, 84, 16}, 1.0);
  heavy->snowDiameter = 1e-9;
  addField(*heavy, "snow", "kg/m3", 1.0f, [](Vec3d) { return 900.0; });
  draw(scene, airFrame(heavy), kView, sized(64, 48));
}

}  // namespace
}  // namespace spin::test
