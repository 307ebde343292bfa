// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/fields/terrain_surface.h"
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

TEST_F(PatchDraw, NoDepthNoDifference) {
  EXPECT_EQ(difference(drawBox(*this, 0.0, true), drawBox(*this, 0.0, false)), 0.0);
}

}  // namespace
}  // namespace spin::test
