// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
// What is made of a frame's air before it is drawn: optics, packed blocks, light, values.
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/units.h"
#include "editor/render/air_blocks.h"
#include "editor/render/air_light.h"
#include "editor/render/air_optics.h"
#include "editor/render/air_values.h"
#include "editor/render/flow_pass.h"
#include "editor/render/spray_pass.h"
#include "tests/render/air_parts.h"
#include "tests/render/flow_parts.h"
#include "tests/render/render_scene.h"

namespace spin::test {
namespace {

/// Over all directions; cosines lie dense at 1, where the peaks are.
double sphereIntegral(const std::function<double(double)>& ofCosine) {
  constexpr int kSteps = 100'000;
  double sum = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double u = (k + 0.5) / kSteps;
    sum += ofCosine(1.0 - 2.0 * u * u * u) * 6.0 * u * u;
  }
  return sum * 2.0 * kPi / kSteps;
}

TEST(AirOptics, PhasesScatterAllLightAndHaveTheirMeanCosine) {
  for (const AirPhase& phase : {dropPhase(8e-6), dropPhase(30e-6), dropPhase(1.0), grainPhase()}) {
    EXPECT_NEAR(sphereIntegral([&](double c) { return phase.at(c); }), 1.0, 2e-3);
    EXPECT_NEAR(sphereIntegral([&](double c) { return c * phase.at(c); }), phase.meanCosine(), 2e-3);
  }
  // Mie's theory for cloud droplets in visible light: 0.84 to 0.89.
  EXPECT_NEAR(dropPhase(10e-6).meanCosine(), 0.86, 0.03);
  EXPECT_NEAR(dropPhase(40e-6).meanCosine(), 0.88, 0.03);
  EXPECT_NEAR(grainPhase().meanCosine(), 0.75, 1e-9);
}

TEST(AirOptics, ExtinctionIsThatOfTheDropsSize) {
  const auto part = airBricks({0, 0, 0}, {16, 4, 4}, 1.0);
  part->dropDiameter = 20e-6;
  part->snowDiameter = 100e-6;
  addField(*part, "mist", "kg/m3", 1e-3f, [](Vec3d) { return 1e-3; });
  // A gram per cubic metre in drops of 20 um: 2 * 1e-3 * 1.5 / (1000 * 20e-6).
  EXPECT_NEAR(static_cast<double>(airOptics(*part).extinction[5]), 0.15, 1e-4);
  addField(*part, "snow", "kg/m3", 1.0f, [](Vec3d p) { return p.x < 8.0 ? 0.5 : 0.0; });
  const AirOptics both = airOptics(*part);
  EXPECT_NEAR(static_cast<double>(both.extinction[0]), 0.15 + 3.0 * 0.5 / (917.0 * 100e-6), 0.01);
  EXPECT_NEAR(static_cast<double>(both.extinction[15]), 0.15, 1e-4);
  // Nearly all light meets snow.
  EXPECT_NEAR(both.phase.meanCosine(), 0.75, 0.03);
  const auto clear = airBricks({0, 0, 0}, {16, 4, 4}, 1.0);
  addField(*clear, "mist", "kg/m3", 1.0f, [](Vec3d) { return 0.0; });
  EXPECT_TRUE(airOptics(*clear).extinction.empty());
}

/// A cell of the packed texture by its number among all cells of the box.
float texelAt(const AirBlocks& b, int x, int y, int z, int channel = 0) {
  const int block = ((z / 16) * b.size[1] + y / 16) * b.size[0] + x / 16;
  const int slot = b.index[static_cast<std::size_t>(block)] - 1;
  if (slot < 0) return -1.0f;
  const int tx = slot % b.slots[0] * 18 + x % 16 + 1, ty = slot / b.slots[0] % b.slots[1] * 18 + y % 16 + 1,
            tz = slot / (b.slots[0] * b.slots[1]) * 18 + z % 16 + 1;
  const int at = ((tz * b.slots[1] * 18 + ty) * b.slots[0] * 18 + tx) * b.channels + channel;
  return floatFromHalf(b.texels[static_cast<std::size_t>(at)]);
}

std::vector<float> ramp(const AirPart& part) {
  std::vector<float> values;
  for (const auto& brick : part.bricks)
    for (std::size_t c = 0; c < kBrickCells; ++c)
      values.push_back(
          static_cast<float>(1 + (kBrickX * brick[0] + static_cast<int>(c % kBrickX)) +
                             2 * (kBrickY * brick[1] + static_cast<int>(c / kBrickX % kBrickY)) +
                             3 * (kBrickZ * brick[2] + static_cast<int>(c / kBrickX / kBrickY))));
  return values;
}

TEST(AirBlocks, CellsAndTheirNeighboursAreWhereTheShaderLooks) {
  CpuBackend backend(2);
  const auto part = airBricks({-3, 5, 7}, {-3 + 48 * 0.5, 5 + 20 * 0.5, 7 + 36 * 0.5}, 0.5);
  for (auto& brick : part->bricks) brick[0] -= 1;  // blocks begin below 0
  const std::vector<float> values = ramp(*part);
  const AirBlocks b = packAir(*part, {&values}, 0.0f, {}, backend);
  EXPECT_EQ(b.size, (std::array<int, 3>{3, 2, 3}));
  EXPECT_EQ(b.origin, (Vec3d{-3 - 8, 5, 7}));
  EXPECT_EQ(b.cell, 0.5);
  for (const auto& [x, y, z] : {std::array{0, 0, 0}, {15, 15, 15}, {16, 3, 17}, {47, 19, 35}})
    EXPECT_EQ(texelAt(b, x, y, z), static_cast<float>(1 + x - 16 + 2 * y + 3 * z))
        << x << " " << y << " " << z;
  // The rim beyond x = 15 of the first block repeats x = 16 of the second.
  const auto rim = [&](int x, int y, int z) {
    return floatFromHalf(
        b.texels[static_cast<std::size_t>(((z + 1) * b.slots[1] * 18 + y + 1) * b.slots[0] * 18 + x + 1)]);
  };
  ASSERT_EQ(b.index[0], 1);
  EXPECT_EQ(rim(16, 4, 5), static_cast<float>(1 + 0 + 8 + 15));
  EXPECT_EQ(rim(16, 16, 16), static_cast<float>(1 + 0 + 32 + 48));
  // Nothing is before x = 0: the outermost cells again.
  EXPECT_EQ(rim(-1, 4, 5), static_cast<float>(1 - 16 + 8 + 15));
}

TEST(AirBlocks, EmptyPlacesTakeNothing) {
  CpuBackend backend(1);
  const auto part = airBricks({0, 0, 0}, {160, 16, 16}, 1.0);
  std::vector<float> values(part->cells(), 0.0f);
  for (std::size_t k = 0; k < part->bricks.size(); ++k)
    if (part->bricks[k][0] == 2 || part->bricks[k][0] == 9) values[k * kBrickCells] = 1.0f;
  const AirBlocks b = packAir(*part, {&values}, 0.0f, {}, backend);
  EXPECT_EQ(b.size, (std::array<int, 3>{8, 1, 1}));
  EXPECT_EQ(b.index, (std::vector<std::uint16_t>{1, 0, 0, 0, 0, 0, 0, 2}));
  const std::vector<float> nothing(part->cells(), 0.0f);
  EXPECT_TRUE(packAir(*part, {&nothing}, 0.0f, {}, backend).empty());
}

TEST(AirBlocks, TooMuchBecomesCoarserAndKeepsItsAmount) {
  CpuBackend backend(2);
  const auto part = airBricks({0, 0, 0}, {128, 64, 64}, 1.0);
  const std::vector<float> values = ramp(*part);
  AirLimits limits;
  limits.slots = 20;
  const AirBlocks b = packAir(*part, {&values}, 0.0f, limits, backend);
  EXPECT_EQ(b.cell, 2.0);
  EXPECT_EQ(b.size, (std::array<int, 3>{4, 2, 2}));
  // The mean of the ramp over cells 20..21, 10..11, 40..41.
  EXPECT_NEAR(texelAt(b, 10, 5, 20), 1 + 20.5 + 2 * 10.5 + 3 * 40.5, 0.1);
  limits.slots = 1;
  limits.blocks = 1;
  EXPECT_EQ(packAir(*part, {&values}, 0.0f, limits, backend).cell, 8.0);
  const auto far = airBricks({0, 0, 0}, {16, 4, 4}, 1.0);
  far->bricks.push_back({2'000'000'000, 0, 0});
  const std::vector<float> ones(far->cells(), 1.0f);
  EXPECT_TRUE(packAir(*far, {&ones}, 0.0f, {}, backend).empty());
}

TEST(AirBlocks, ThreadsChangeNothing) {
  const auto part = airBricks({0, 0, 0}, {64, 64, 64}, 1.0);
  const std::vector<float> values = ramp(*part);
  CpuBackend one(1), three(3);
  EXPECT_EQ(packAir(*part, {&values}, 0.0f, {}, one).texels,
            packAir(*part, {&values}, 0.0f, {}, three).texels);
}

/// Level layer of an optical depth, and what leaves it straight up: colours times the way's opacity.
struct Layer {
  double depth;
  double mu = 1.0;  // sine of the sun's height
  double g = 0.75;
  Vec3d sun{1, 1, 1}, sky{}, bounce{};
};

double shineOf(const Layer& layer) {
  CpuBackend backend(2);
  constexpr int kThick = 16, kMiddle = 64;
  // So wide that its sides are far out of sight.
  const auto part = airBricks({0, 0, 0}, {2.0 * kMiddle, 2.0 * kMiddle, kThick}, 1.0);
  AirOptics optics;
  optics.phase = {0.0, layer.g, 0.0, 1.0};
  optics.extinction.assign(part->cells(), static_cast<float>(layer.depth / kThick));
  AirSky sky;
  sky.toSun = {std::sqrt(1.0 - layer.mu * layer.mu), 0.0, layer.mu};
  sky.sun = layer.sun;
  sky.sky = layer.sky;
  sky.bounce = layer.bounce;
  const AirLight light = lightAir(*part, optics, sky, 2'000'000, backend);
  double seen = 0.0, kept = 1.0;
  const double passed = std::exp(-layer.depth / kThick);
  for (int z = kThick - 1; z >= 0; --z) {
    const auto at = static_cast<std::size_t>(4 * ((z * light.size[1] + kMiddle) * light.size[0] + kMiddle));
    seen += kept * (1.0 - passed) * static_cast<double>(floatFromHalf(light.texels[at]));
    kept *= passed;
  }
  return seen;
}

TEST(AirLight, ThickPowderIsAsWhiteAsTwoStreamTheorySays) {
  // R = 3/4 (1 - g) t / (1 + 3/4 (1 - g) t), of what absorbs nothing (Bohren 1987).
  for (const double depth : {3.0, 10.0, 30.0}) {
    const double reduced = 0.75 * 0.25 * depth;
    EXPECT_NEAR(shineOf({depth}), reduced / (1.0 + reduced), 0.1) << depth;
  }
  EXPECT_GT(shineOf({30.0}), 0.8);
  // It is lit by the cosine of the sun.
  EXPECT_NEAR(shineOf({30.0, 0.5}), 0.45, 0.1);
}

/// pi times the radiance from the middle of a ball towards `toEye` (+-1, or 0: from beside), of light that
/// was deflected; as the shader adds it up.
double ballSeen(double depth, double g, int toEye) {
  constexpr double kSide = 2.4 / 48;
  const auto part = airBricks({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, kSide);
  addField(*part, "ball", "1/m", 1.0f, [&](Vec3d p) { return length(p) < 1.0 ? 0.5 * depth : 0.0; });
  AirOptics optics;
  optics.phase = {0.0, g, 0.0, 1.0};
  for (const std::uint16_t half : part->fields[0].halves) optics.extinction.push_back(floatFromHalf(half));
  CpuBackend backend(2);
  AirSky sky{{0, 0, 1}, {1, 1, 1}, {}, {}, {}};
  const AirLight light = lightAir(*part, optics, sky, 1'000'000, backend);
  const Vec3d out = toEye == 0 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1.0 * toEye};
  double seen = 0.0, kept = 1.0;
  constexpr double kStep = 0.005;
  for (double t = 0.999; t > -0.999; t -= kStep) {
    const Vec3d at = (out * t - light.origin) * (1.0 / light.voxel);
    const auto voxel = static_cast<std::size_t>(
        (static_cast<int>(at.z) * light.size[1] + static_cast<int>(at.y)) * light.size[0] +
        static_cast<int>(at.x));
    const double sun = static_cast<double>(floatFromHalf(light.texels[4 * voxel + 3]));
    const double narrow = g * std::exp(-(1.0 / sun - 1.0) * 4.0 / 3.0);
    const AirPhase phase{0.0, narrow, 0.0, 1.0};
    const double own =
        static_cast<double>(floatFromHalf(light.texels[4 * voxel])) + sun * kPi * phase.at(-out.z);
    const double passed = std::exp(-0.5 * depth * kStep);
    seen += kept * (1.0 - passed) * own;
    kept *= passed;
  }
  return seen;
}

TEST(AirLight, BallsAreAsBrightAsMonteCarloSays) {
  // 400,000 photons on a ball that absorbs nothing, Henyey and Greenstein's phase function; those that leave
  // within 23 degrees of the direction, not farther than 0.45 radii from its middle.
  struct Seen {
    double g, depth, towardsSun, beside, behind;
  };
  for (const Seen& s : {Seen{0.75, 6, 0.124, 0.215, 0.508},
                        {0.75, 20, 0.352, 0.265, 0.085},
                        {0.75, 80, 0.703, 0.156, 0.015},
                        {0.88, 20, 0.185, 0.261, 0.222},
                        {0.88, 80, 0.524, 0.219, 0.037}}) {
    EXPECT_NEAR(ballSeen(s.depth, s.g, 1), s.towardsSun, 0.11) << s.g << " " << s.depth;
    EXPECT_NEAR(ballSeen(s.depth, s.g, 0), s.beside, 0.08) << s.g << " " << s.depth;
    EXPECT_NEAR(ballSeen(s.depth, s.g, -1), s.behind, 0.15) << s.g << " " << s.depth;
  }
}

TEST(AirLight, EvenLightFromAllSidesShowsNoCloud) {
  for (const double depth : {0.3, 3.0, 30.0})
    EXPECT_NEAR(shineOf({depth, 1.0, 0.75, {}, {1, 1, 1}, {1, 1, 1}}), 1.0 - std::exp(-depth), 2e-3) << depth;
  // Of light from above only, a thick layer sends all back.
  EXPECT_GT(shineOf({30.0, 1.0, 0.75, {}, {1, 1, 1}, {}}), 0.85);
}

TEST(AirLight, TheShadedSideIsDarkerAndLandTakesTheSun) {
  CpuBackend backend(2);
  const auto part = airBricks({0, 0, 0}, {64, 16, 16}, 1.0);
  AirOptics optics;
  optics.phase = {0.0, 0.75, 0.0, 1.0};
  optics.extinction.assign(part->cells(), 1.0f);
  AirSky sky{{1, 0, 1e-9}, {1, 1, 1}, {}, {}, {}};
  const auto sunAt = [&](const AirLight& light, int x) {
    return floatFromHalf(
        light.texels[static_cast<std::size_t>(4 * ((8 * light.size[1] + 8) * light.size[0] + x) + 3)]);
  };
  const AirLight light = lightAir(*part, optics, sky, 1'000'000, backend);
  EXPECT_EQ(light.voxel, 1.0);
  // Half a cell, and sixty-three and a half, of a reduced extinction of 1/4 per metre.
  EXPECT_NEAR(sunAt(light, 63), 1.0 / (1.0 + 0.75 * 0.125), 2e-3);
  EXPECT_NEAR(sunAt(light, 0), 1.0 / (1.0 + 0.75 * 0.25 * 63.5), 2e-3);
  sky.sunShare = [](Vec3d p) { return p.x > 32.0 ? 1.0 : 0.0; };
  const AirLight shaded = lightAir(*part, optics, sky, 1'000'000, backend);
  EXPECT_EQ(sunAt(shaded, 63), sunAt(light, 63));
  EXPECT_EQ(sunAt(shaded, 10), 0.0f);
  // Voxels of several cells when there are too many.
  EXPECT_EQ(lightAir(*part, optics, sky, 3000, backend).voxel, 2.0);
}

std::shared_ptr<AirPart> valuedPart() {
  const auto part = airBricks({10, 20, 30}, {10 + 32, 20 + 16, 30 + 16}, 1.0);
  addField(*part, "mist", "kg/m3", 1e-3f, [](Vec3d p) { return p.x < 26.0 ? 2e-3 : 0.0; });
  addField(*part, "temperature", "K", 1.0f, [](Vec3d p) { return p.z - 30.0; });
  AirField velocity{"velocity", "m/s", 3, 1.0f, {}};
  for (std::size_t brick = 0; brick < part->bricks.size(); ++brick)
    for (const float v : {3.0f, 0.0f, -4.0f})
      velocity.halves.insert(velocity.halves.end(), kBrickCells, halfFromFloat(v));
  part->fields.push_back(std::move(velocity));
  return part;
}

TEST(AirValues, AreThoseOfTheFieldsAndEmptyWhereThereIsNone) {
  const auto part = valuedPart();
  EXPECT_NEAR(static_cast<double>(airValues(*part, AirDisplay::Density)[3]), 2e-3, 1e-6);
  EXPECT_EQ(airValues(*part, AirDisplay::Velocity)[7], 5.0f);
  EXPECT_EQ(airValues(*part, AirDisplay::Temperature)[0], 0.5f);
  EXPECT_TRUE(airValues(*part, AirDisplay::Divergence).empty());
  EXPECT_TRUE(airValues(*part, AirDisplay::Natural).empty());
}

TEST(AirValues, TheScaleSpansWhatHangsInTheAir) {
  const auto part = valuedPart();
  RenderNode settings;
  settings.airDisplay = AirDisplay::Density;
  const ValueScale scale = airScale(settings, *part, airValues(*part, settings.airDisplay));
  EXPECT_EQ(scale.low, 0.0);
  EXPECT_NEAR(scale.high, 2e-3, 1e-5);
  settings.airRangeAuto = false;
  settings.airRangeLow = -1.0;
  settings.airRangeHigh = 4.0;
  EXPECT_EQ(airScale(settings, *part, {}).place(1.5), 0.5);
}

TEST(AirValues, TheLegendTellsWhatIsShown) {
  SceneBuilder builder;
  builder.add<RenderNode>(kRenderType, "render",
                          [](RenderNode& r) { r.airDisplay = AirDisplay::Temperature; });
  const auto frame = airFrame(valuedPart());
  const auto legend = airLegend(*builder.build(), frame.get(), 0.0);
  ASSERT_TRUE(legend);
  EXPECT_EQ(legend->unit, "K");
  EXPECT_GE(legend->ticks.size(), 3u);
  EXPECT_FALSE(airLegend(*builder.build(), nullptr, 0.0));
  EXPECT_FALSE(airLegend(*SceneBuilder{}.build(), frame.get(), 0.0));
}

TEST(AirValues, ASliceLiesBetweenTheLayersBesideIt) {
  const auto part = valuedPart();
  const std::vector<float> values = airValues(*part, AirDisplay::Temperature);
  ValueScale scale;
  scale.high = 16.0;
  const AirSliceImage level = sliceAir(*part, values, scale, 2, 34.25, 1'000'000);
  EXPECT_EQ(level.width, 32);
  EXPECT_EQ(level.height, 16);
  EXPECT_EQ(level.corner, (Vec3d{10, 20, 34.25}));
  EXPECT_FLOAT_EQ(level.texels[0] * 16.0f, 4.25f);
  EXPECT_EQ(level.texels[1], 1.0f);
  const AirSliceImage upright = sliceAir(*part, values, scale, 1, 21.0, 1'000'000);
  EXPECT_EQ(upright.width, 16);  // along z
  EXPECT_EQ(upright.height, 32);
  EXPECT_EQ(upright.corner, (Vec3d{10, 21, 30}));
  EXPECT_FLOAT_EQ(upright.texels[2 * 5] * 16.0f, 5.5f);
  EXPECT_TRUE(sliceAir(*part, values, scale, 2, 90.0, 1'000'000).empty());
  EXPECT_TRUE(sliceAir(*part, values, scale, 2, 34.0, 100).empty());
}

TEST(Spray, ParcelsHideWhatTheirDropsDo) {
  ParticleSet set;
  set.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  set.attributes = {{"mass", "kg", 1, {1.0f, 0.0f, 1.0f}},
                    {"diameter", "m", 1, {1e-3f, 1e-3f, 2e-3f}},
                    {"age", "s", 1, {0.0f, 0.0f, 1.0f}}};
  const std::vector<SprayPuff> puffs = sprayPuffs(set);
  double area[3] = {}, radius[3] = {};
  for (const SprayPuff& puff : puffs) {
    const auto which = static_cast<std::size_t>(std::lround(puff.position.x));
    area[which] += static_cast<double>(puff.area);
    radius[which] += static_cast<double>(puff.radius);
  }
  // n pi d^2 / 4 with n = m / (pi / 6 rho d^3).
  EXPECT_NEAR(area[0], 1.5, 1e-5);
  EXPECT_EQ(area[1], 0.0) << "a parcel without mass is nothing";
  EXPECT_NEAR(area[2], 0.75, 1e-5);
  EXPECT_GT(radius[2], radius[0]);
  set.attributes.erase(set.attributes.begin());
  EXPECT_TRUE(sprayPuffs(set).empty());
}

TEST(Spray, AParcelThatFallsIsDrawnOut) {
  ParticleSet set;
  set.positions = {{0, 0, 0}};
  set.attributes = {{"mass", "kg", 1, {8.0f}},
                    {"diameter", "m", 1, {0.1f}},
                    {"age", "s", 1, {0.0f}},
                    {"velocity", "m/s", 3, {3.0f, 0.0f, 0.0f}}};
  const auto extent = [&] {
    Box3d box;
    for (const SprayPuff& puff : sprayPuffs(set)) box.extend(puff.position.to<double>());
    return box.size();
  };
  const Vec3d before = extent();
  EXPECT_LT(before.x, 0.8);
  // After two seconds the way is steep, and seven times as fast.
  set.attributes[2].values = {2.0f};
  set.attributes[3].values = {3.0f, 0.0f, -19.6f};
  const Vec3d after = extent();
  EXPECT_GT(after.z, 1.0);
  EXPECT_LT(after.z, 4.0);
}

TEST(Spray, OnlyWaterWithoutNeighboursIsLoose) {
  ParticleSet set = particleBlock({0, 0, 0}, {0.75, 0.25, 0.25}, 0.25, 1000.0);
  ASSERT_EQ(set.size(), 3u);
  set.attributes[2].values = {2.0f, 3.0f, 12.0f};
  EXPECT_EQ(looseWater(set), (std::vector<bool>{true, true, false}));
  const std::vector<SprayPuff> puffs = loosePuffs(set, 0.2);
  ASSERT_EQ(puffs.size(), 2u);
  // All of a particle's water, in drops.
  EXPECT_NEAR(static_cast<double>(puffs[0].area), 1.5 * 0.008 / 6e-3, 1e-3);
  set.attributes[1].values.assign(3, 300.0f);
  EXPECT_EQ(looseWater(set), (std::vector<bool>{false, false, false})) << "snow";
  // Before the first step nobody has counted.
  set.attributes[2].values.assign(3, 0.0f);
  EXPECT_TRUE(looseWater(set).empty());
}

}  // namespace
}  // namespace spin::test
