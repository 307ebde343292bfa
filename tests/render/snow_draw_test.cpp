// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "core/base/units.h"
#include "core/fields/terrain_surface.h"
#include "core/nodes/settings_nodes.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class SnowDraw : public GlTest {
 protected:
  static SceneBuilder meadow() {
    SceneBuilder scene;
    addWeather(scene);
    addGround(scene, 2);  // soil: dark
    addTerrain(scene, 65, 65, [](int, int) { return 0.0; });
    return scene;
  }
  static constexpr RenderCamera kAbove{{160, 159, 240}, {160, 160, 0}, 45};
};

TEST_F(SnowDraw, DeepSnowIsWhiteAndBareGroundStaysAsItWas) {
  const SnapshotPointer scene = meadow().build();
  const Picture bare = draw(scene, nullptr, kAbove, sized(96, 96));
  const Picture half = draw(scene, frameWithCover(*scene, [](int i, int) { return i < 32 ? 0.3 : 0.0; }),
                            kAbove, sized(96, 96));
  EXPECT_GT(half.bright(20, 48), 190);
  EXPECT_GT(half.bright(20, 48), 2 * bare.bright(20, 48));
  EXPECT_LT(std::abs(half.bright(76, 48) - bare.bright(76, 48)), 25);
}

TEST_F(SnowDraw, ThinSnowLetsTheGroundThrough) {
  const SnapshotPointer scene = meadow().build();
  const auto mean = [&](double depth) {
    const Picture p =
        draw(scene, frameWithCover(*scene, [=](int, int) { return depth; }), kAbove, sized(96, 96));
    double sum = 0.0;
    for (const std::uint8_t v : p.rgb) sum += v;
    return sum / static_cast<double>(p.rgb.size());
  };
  const double none = mean(0.0), thin = mean(0.010), some = mean(0.022), deep = mean(0.3);
  EXPECT_GT(thin, none + 5.0);
  EXPECT_GT(some, thin + 5.0);
  EXPECT_GT(deep, some + 5.0);
}

TEST_F(SnowDraw, HidingTheSnowShowsTheGround) {
  const SnapshotPointer scene = meadow().build();
  const Picture bare = draw(scene, nullptr, kAbove, sized(64, 64));
  RenderOptions options = sized(64, 64);
  options.showSnow = false;
  EXPECT_EQ(
      difference(bare, draw(scene, frameWithCover(*scene, [](int, int) { return 0.3; }), kAbove, options)),
      0.0);
}

TEST_F(SnowDraw, AFineGridReplacesTheCoarseCoverWithoutAGap) {
  SceneBuilder builder;
  addWeather(builder);
  addGround(builder, 1);  // sand: redder than blue
  addTerrain(builder, 65, 65, [](int i, int j) { return 0.5 * ((i * 3 + j * 5) % 7); });
  const SnapshotPointer scene = builder.build();
  auto frame = frameWithCover(*scene, [](int, int) { return 0.0; });
  // Fine cells over the coarse quads 28..36: bare surface by the terrain's own triangles.
  CoverGrid fine{"terrain/fine0", "terrain", Raster<float>(160, 160, 140.125, 140.125, 0.25), {}};
  const TerrainSurface surface(scene->terrain->heights);
  for (int j = 0; j < 160; ++j)
    for (int i = 0; i < 160; ++i)
      fine.base.at(i, j) = static_cast<float>(surface.heightAt(fine.base.x(i), fine.base.y(j)).value());
  fine.area = fine.base.sameShape<float>(0.0625f);
  addGrid(*frame, fine, std::vector<float>(fine.base.size(), 0.4f));
  const Picture picture = draw(scene, frame, kAbove, sized(192, 192));
  EXPECT_GT(picture.bright(96, 96), 190) << "deep in the middle of the fine grid";
  EXPECT_LT(picture.bright(20, 96), 170) << "bare outside";
  EXPECT_LT(picture.blue(20, 96), picture.red(20, 96));
  // Along its whole border there is ground or snow, never the dark void below.
  const Picture without =
      draw(scene, frameWithCover(*scene, [](int, int) { return 0.0; }), kAbove, sized(192, 192));
  for (int y = 0; y < 192; ++y)
    for (int x = 0; x < 192; ++x) EXPECT_GT(picture.bright(x, y), without.bright(x, y) - 40) << x << ' ' << y;
}

class PatchDraw : public SnowDraw {
 protected:
  /// A box of 8 x 8 x 4 m in the meadow with a patch on its top.
  static Picture drawBox(PatchDraw& test, double depth, bool withPatch) {
    SceneBuilder builder = meadow();
    addModel(builder, "box", boxModel({8, 8, 4}), {160, 160, 0});
    const SnapshotPointer scene = builder.build();
    auto frame = frameWithCover(*scene, [](int, int) { return 0.0; });
    if (withPatch) {
      CoverGrid patch{"box/0", "box", Raster<float>(40, 40, -3.9, -3.9, 0.2, 4.0f), {}};
      patch.area = patch.base.sameShape<float>(0.04f);
      addGrid(*frame, patch, std::vector<float>(patch.base.size(), static_cast<float>(depth)));
    }
    return test.draw(scene, frame, {{160, 140, 10}, {160, 160, 3}, 40}, sized(128, 128));
  }
};

TEST_F(PatchDraw, SnowLiesOnTheModelAndStandsAboveItsEdge) {
  const Picture bare = drawBox(*this, 0.0, false), deep = drawBox(*this, 0.8, true);
  // The top face lies somewhat above the middle of the picture; the wall below it.
  int top = 0, wall = 0, above = 0;
  for (int y = 0; y < 128; ++y) {
    const bool roof = bare.blue(64, y) > 1.4 * bare.red(64, y);
    if (roof && deep.bright(64, y) > 180) ++top;
    if (roof && std::abs(deep.bright(64, y) - bare.bright(64, y)) < 20) ++wall;
    if (!roof && deep.bright(64, y) > bare.bright(64, y) + 40) ++above;
  }
  EXPECT_GT(top, 8) << "snow on the roof";
  EXPECT_GT(wall, 8) << "none on the wall";
  EXPECT_GT(above, 1) << "snow rises above the roof's far edge";
}

/// A roof of which two patches cover a half each looks as one that a single patch covers: no groove between.
TEST_F(PatchDraw, PatchesThatMeetLeaveNoGroove) {
  const auto roof = [&](int patches) {
    SceneBuilder builder = meadow();
    addModel(builder, "box", boxModel({8, 8, 4}), {160, 160, 0});
    const SnapshotPointer scene = builder.build();
    auto frame = frameWithCover(*scene, [](int, int) { return 0.0; });
    for (int p = 0; p < patches; ++p) {
      const int columns = 40 / patches;
      CoverGrid grid{"box/" + std::to_string(p),
                     "box",
                     Raster<float>(columns, 40, -3.9 + 0.2 * columns * p, -3.9, 0.2, 4.0f),
                     {}};
      grid.area = grid.base.sameShape<float>(0.04f);
      addGrid(*frame, grid, std::vector<float>(grid.base.size(), 0.6f));
    }
    return draw(scene, frame, {{160, 150, 9}, {160, 160, 4}, 40}, sized(128, 128));
  };
  const Picture one = roof(1), two = roof(2);
  int most = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 56; x < 72; ++x) most = std::max(most, std::abs(one.bright(x, y) - two.bright(x, y)));
  EXPECT_LT(most, 12) << "along the middle";
  EXPECT_LT(difference(one, two), 0.5);
}

/// A picture of values: their hues do not depend on the light.
class ValueDraw : public SnowDraw {
 protected:
  static void show(SceneBuilder& scene, SnowDisplay shows, double low, double high) {
    scene.add<RenderNode>(kRenderType, "render", [=](RenderNode& r) {
      r.snowDisplay = shows;
      r.snowRangeAuto = false;
      r.snowRangeLow = low;
      r.snowRangeHigh = high;
    });
  }
  static bool yellow(const Picture& p, int x, int y) {
    return p.red(x, y) > 1.5 * p.blue(x, y) && p.green(x, y) > 1.5 * p.blue(x, y);
  }
  static bool violet(const Picture& p, int x, int y) {
    return p.blue(x, y) > 1.4 * p.green(x, y) && p.red(x, y) > 1.2 * p.green(x, y);
  }
  static bool grey(const Picture& p, int x, int y) {
    return std::abs(p.red(x, y) - p.blue(x, y)) < 12 && p.bright(x, y) < 150;
  }
};

TEST_F(ValueDraw, DepthIsReadAsColourOnTheGround) {
  SceneBuilder builder = meadow();
  show(builder, SnowDisplay::Depth, 0.0, 2.0);
  const SnapshotPointer scene = builder.build();
  const auto depth = [](int i, int j) { return j < 32 ? 0.0 : i < 32 ? 0.02 : 2.0; };
  const Picture picture = draw(scene, frameWithCover(*scene, depth), kAbove, sized(96, 96));
  EXPECT_TRUE(violet(picture, 20, 20)) << "thin";
  EXPECT_TRUE(yellow(picture, 76, 20)) << "deep";
  EXPECT_TRUE(grey(picture, 48, 76)) << "none";
}

TEST_F(ValueDraw, AFineGridAndAPatchShowTheirOwnValues) {
  SceneBuilder builder = meadow();
  show(builder, SnowDisplay::Depth, 0.0, 2.0);
  addModel(builder, "box", boxModel({8, 8, 4}), {160, 160, 0});
  const SnapshotPointer scene = builder.build();
  auto frame = frameWithCover(*scene, [](int, int) { return 0.02; });
  CoverGrid fine{"terrain/fine0", "terrain", Raster<float>(80, 80, 140.25, 140.25, 0.5, 0.0f), {}};
  fine.area = fine.base.sameShape<float>(0.25f);
  addGrid(*frame, fine, std::vector<float>(fine.base.size(), 2.0f));
  CoverGrid patch{"box/0", "box", Raster<float>(40, 40, -3.9, -3.9, 0.2, 4.0f), {}};
  patch.area = patch.base.sameShape<float>(0.04f);
  addGrid(*frame, patch, std::vector<float>(patch.base.size(), 0.02f));
  const Picture picture = draw(scene, frame, {{160, 159, 60}, {160, 160, 0}, 45}, sized(128, 128));
  EXPECT_TRUE(violet(picture, 64, 64)) << "thin on the box";
  EXPECT_TRUE(yellow(picture, 40, 64)) << "deep in the fine grid";
  EXPECT_TRUE(violet(picture, 4, 64)) << "thin outside it";
}

TEST_F(ValueDraw, TemperatureIsShownOnBareModelsAndGroundAsWell) {
  SceneBuilder builder = meadow();
  show(builder, SnowDisplay::Temperature, -10.0, 0.0);
  addModel(builder, "box", boxModel({80, 80, 4}), {160, 160, 0});
  const SnapshotPointer scene = builder.build();
  auto frame = frameWithCover(*scene, [](int, int) { return 0.0; });
  CoverGrid patch{"box/0", "box", Raster<float>(40, 40, -39, -39, 2.0, 4.0f), {}};
  patch.area = patch.base.sameShape<float>(4.0f);
  addGrid(*frame, patch, std::vector<float>(patch.base.size(), 0.0f));
  auto cover = std::make_shared<CoverPart>(*frame->part<CoverPart>("cover"));
  cover->values[0].temperature.assign(cover->values[0].depth.size(), 263.15f);
  cover->values[1].temperature.assign(cover->values[1].depth.size(), 273.15f);
  frame->parts["cover"] = cover;
  const Picture picture = draw(scene, frame, kAbove, sized(96, 96));
  EXPECT_TRUE(yellow(picture, 48, 48)) << "0 degC on the box";
  EXPECT_TRUE(violet(picture, 10, 48)) << "-10 degC on the ground";
}

TEST_F(ValueDraw, NaturalColoursComeBack) {
  SceneBuilder natural = meadow(), values = meadow();
  show(natural, SnowDisplay::Natural, 0.0, 2.0);
  show(values, SnowDisplay::Swe, 0.0, 2.0);
  const SnapshotPointer one = natural.build(), other = values.build();
  const auto frame = frameWithCover(*one, [](int i, int) { return 0.01 * i; });
  const Picture before = draw(one, frame, kAbove, sized(64, 64));
  EXPECT_GT(difference(before, draw(other, frame, kAbove, sized(64, 64))), 20.0);
  EXPECT_EQ(difference(before, draw(one, frame, kAbove, sized(64, 64))), 0.0);
}

TEST_F(SnowDraw, PublishedShadingFollowsItsConstants) {
  const auto picture = [&](double ambient, double diffuse, double specular, double exposed) {
    SceneBuilder builder = meadow();
    builder.add<RenderNode>(kRenderType, "render", [=](RenderNode& r) {
      r.snowShading = SnowShading::BlinnPhong;
      r.snowAmbient = ambient;
      r.snowDiffuse = diffuse;
      r.snowSpecular = specular;
      r.snowShininess = 8.0;
    });
    const SnapshotPointer scene = builder.build();
    auto frame = frameWithCover(*scene, [](int, int) { return 0.3; });
    auto cover = std::make_shared<CoverPart>(*frame->part<CoverPart>("cover"));
    auto exposure = std::make_shared<CoverExposure>();
    exposure->grids = {std::vector<float>(cover->values[0].depth.size(), static_cast<float>(exposed))};
    cover->exposure = exposure;
    frame->parts["cover"] = cover;
    return draw(scene, frame, kAbove, sized(64, 64));
  };
  const auto mean = [](const Picture& p) {
    double sum = 0.0;
    for (const std::uint8_t v : p.rgb) sum += v;
    return sum / static_cast<double>(p.rgb.size());
  };
  EXPECT_LT(mean(picture(0.0, 0.0, 0.0, 1.0)), 25.0) << "only haze before it";
  const double ambient = mean(picture(0.4, 0.0, 0.0, 1.0));
  EXPECT_GT(ambient, 40.0);
  EXPECT_GT(mean(picture(0.8, 0.0, 0.0, 1.0)), ambient + 20.0);
  EXPECT_GT(mean(picture(0.4, 0.5, 0.0, 1.0)), ambient + 5.0);
  EXPECT_GT(mean(picture(0.4, 0.0, 1.0, 1.0)), ambient + 1.0);
  // C = f_p C_snow + (1 - f_p) C_object: black snow over the meadow, in linear light.
  SceneBuilder bare = meadow();
  const SnapshotPointer meadowOnly = bare.build();
  const double ground = mean(draw(meadowOnly, nullptr, kAbove, sized(64, 64)));
  const double half = mean(picture(0.0, 0.0, 0.0, 0.5));
  EXPECT_LT(half, 0.9 * ground);
  EXPECT_GT(half, 0.5 * ground);
}

/// A camera that walks towards a snowed box in small steps: on the way the patch turns from colour into
/// raised geometry, and no step changes the picture much.
TEST_F(SnowDraw, NothingPopsAsTheCameraComesNear) {
  SceneBuilder builder = meadow();
  addModel(builder, "box", boxModel({8, 8, 4}), {160, 160, 0});
  const SnapshotPointer scene = builder.build();
  auto frame = frameWithCover(*scene, [](int, int) { return 0.3; });
  CoverGrid patch{"box/0", "box", Raster<float>(32, 32, -3.875, -3.875, 0.25, 4.0f), {}};
  patch.area = patch.base.sameShape<float>(0.0625f);
  addGrid(*frame, patch, std::vector<float>(patch.base.size(), 0.6f));
  RenderOptions options = sized(128, 96);
  options.samples = 4;
  std::vector<double> steps;
  Picture before;
  for (int k = 0; k <= 80; ++k) {
    const double distance = 85.0 * std::pow(0.985, k);
    const Vec3d eye{160.0, 160.0 - distance * 0.94, 3.0 + distance * 0.34};
    const Picture now = draw(scene, frame, {eye, {160, 160, 4}, 30}, options);
    // Only about the box: the grain of the ground also changes with every step.
    double sum = 0.0;
    for (int y = 32; k > 0 && y < 56; ++y)
      for (int x = 48; x < 80; ++x) sum += std::abs(now.bright(x, y) - before.bright(x, y));
    if (k > 0) steps.push_back(sum / (24.0 * 32.0));
    before = now;
  }
  // A patch that is there from one step to the next changes this part by 16.
  for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_LT(steps[k], 6.0) << "step " << k;
  EXPECT_GT(std::accumulate(steps.begin(), steps.end(), 0.0), 20.0) << "the box is in the picture";
}

/// The same over a fine grid on the ground, of which fewer vertices are drawn with distance.
TEST_F(SnowDraw, NothingPopsOnFineGridsAsTheCameraComesNear) {
  const SnapshotPointer scene = meadow().build();
  auto frame = frameWithCover(*scene, [](int, int) { return 0.3; });
  CoverGrid fine{"terrain/fine0", "terrain", Raster<float>(96, 96, 148.125, 148.125, 0.25, 0.0f), {}};
  fine.area = fine.base.sameShape<float>(0.0625f);
  std::vector<float> depth;
  for (int j = 0; j < 96; ++j)
    for (int i = 0; i < 96; ++i) depth.push_back((i * 7 + j * 3) % 11 < 2 ? 0.1f : 0.4f);
  addGrid(*frame, fine, depth);
  RenderOptions options = sized(128, 96);
  options.samples = 4;
  std::vector<double> steps;
  Picture before;
  for (int k = 0; k <= 100; ++k) {
    const double distance = 50.0 * std::pow(0.985, k);
    const Vec3d eye{160.0, 148.0 - distance * 0.94, 1.0 + distance * 0.34};
    const Picture now = draw(scene, frame, {eye, {160, 160, 0}, 30}, options);
    double sum = 0.0;
    for (int y = 40; k > 0 && y < 70; ++y)
      for (int x = 48; x < 80; ++x) sum += std::abs(now.bright(x, y) - before.bright(x, y));
    if (k > 0) steps.push_back(sum / (30.0 * 32.0));
    before = now;
  }
  // A level that takes over from one step to the next changes this part by 10 to 12.
  for (std::size_t k = 0; k < steps.size(); ++k) EXPECT_LT(steps[k], 5.0) << "step " << k;
  EXPECT_GT(std::accumulate(steps.begin(), steps.end(), 0.0), 50.0) << "the drifts are in the picture";
}

TEST_F(PatchDraw, NoDepthNoDifference) {
  EXPECT_EQ(difference(drawBox(*this, 0.0, true), drawBox(*this, 0.0, false)), 0.0);
}

}  // namespace
}  // namespace spin::test
