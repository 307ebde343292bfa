// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/flow_nodes.h"
#include "editor/render/area_pass.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class AreaDraw : public GlTest {
 protected:
  static SceneBuilder meadow(const PlanPoints& outline, double hill = 0.0) {
    SceneBuilder scene;
    addWeather(scene);
    addGround(scene, 2);
    addTerrain(scene, 33, 33, [hill](int, int j) { return j == 8 ? hill : 0.0; });
    scene.add<AvalancheReleaseNode>(kAvalancheReleaseType, "slab",
                                    [&](AvalancheReleaseNode& r) { r.outline = outline; });
    return scene;
  }
  Picture drawn(const SnapshotPointer& scene, const RenderCamera& camera, const char* selected) {
    RenderOptions options = sized(128, 128);
    options.selectedNode = selected;
    return draw(scene, nullptr, camera, options);
  }
  static constexpr RenderCamera kAbove{{80, 79, 200}, {80, 80, 0}, 45};
};

TEST_F(AreaDraw, TheSelectedReleaseIsTintedWhereItLies) {
  const SnapshotPointer scene = meadow({{50, 50}, {80, 50}, {80, 110}, {50, 110}}).build();
  const Picture plain = drawn(scene, kAbove, "");
  const Picture tinted = drawn(scene, kAbove, "slab");
  // 160 m are 128 pixels wide, seen from above: the area covers columns 40 to 64.
  EXPECT_GT(tinted.red(52, 64), plain.red(52, 64) + 40);
  EXPECT_LT(std::abs(tinted.red(90, 64) - plain.red(90, 64)), 3);
  EXPECT_LT(std::abs(tinted.red(20, 64) - plain.red(20, 64)), 3);
}

TEST_F(AreaDraw, PaintedCellsCountToo) {
  SceneBuilder builder = meadow({});
  TiledRaster<std::uint8_t> layer(33, 33, kReleaseUnpainted);
  for (int j = 10; j < 20; ++j)
    for (int i = 20; i < 28; ++i) layer.set(i, j, kReleasePainted);
  builder.snapshot.nodes.back().painted = layer;
  const SnapshotPointer scene = builder.build();
  EXPECT_EQ(releaseMask(*scene, scene->nodes.back())[15 * 33 + 24], 1);
  EXPECT_EQ(releaseMask(*scene, scene->nodes.back())[15 * 33 + 10], 0);
  EXPECT_GT(difference(drawn(scene, kAbove, ""), drawn(scene, kAbove, "slab")), 0.5);
}

TEST_F(AreaDraw, GroundBeforeItHidesTheTint) {
  const PlanPoints outline{{50, 60}, {110, 60}, {110, 90}, {50, 90}};
  const RenderCamera low{{80, 5, 8}, {80, 80, 0}, 45};
  const SnapshotPointer open = meadow(outline).build(), hidden = meadow(outline, 30.0).build();
  EXPECT_GT(difference(drawn(open, low, ""), drawn(open, low, "slab")), 1.0);
  EXPECT_EQ(difference(drawn(hidden, low, ""), drawn(hidden, low, "slab")), 0.0);
}

TEST_F(AreaDraw, OutlinesHoldWhatLiesWithin) {
  const PlanPoints arrow{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  EXPECT_TRUE(withinOutline(arrow, {0.5, 1.0}));
  EXPECT_TRUE(withinOutline(arrow, {3.5, 1.0}));
  EXPECT_FALSE(withinOutline(arrow, {2.0, 2.0})) << "the notch";
  EXPECT_FALSE(withinOutline(arrow, {5.0, 1.0}));
  EXPECT_FALSE(withinOutline({{0, 0}, {1, 1}}, {0.5, 0.5}));
  EXPECT_TRUE(releaseMask(SceneSnapshot{}, makeNode(kAvalancheReleaseType, "a", "A")).empty());
}

}  // namespace
}  // namespace spin::test
