// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "core/nodes/ground_nodes.h"
#include "editor/render/ground_map.h"
#include "editor/render/render_target.h"
#include "editor/render/terrain_pass.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

constexpr int kSand = 1;

class TerrainDraw : public GlTest {
 protected:
  /// Sandy hills: redder than blue wherever there is ground, while the sky is bluer than red.
  static SceneBuilder hills(int cells, double height) {
    SceneBuilder scene;
    addWeather(scene);
    addGround(scene, kSand);
    addTerrain(scene, cells, cells, [=](int i, int j) {
      return height * std::sin(i * 0.45) * std::cos(j * 0.31) + 0.2 * height * ((i * 7 + j * 13) % 5);
    });
    return scene;
  }
  static int skyPixels(const Picture& picture) {
    int sky = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) sky += picture.blue(x, y) >= picture.red(x, y);
    return sky;
  }
};

TEST_F(TerrainDraw, EmptySceneIsSky) {
  const Picture picture = draw(nullptr, nullptr, {{0, 0, 2}, {0, 100, 30}, 45}, sized(64, 36));
  EXPECT_EQ(skyPixels(picture), 64 * 36);
  EXPECT_GT(picture.bright(32, 18), 60);
}

TEST_F(TerrainDraw, NoCracksBetweenLevelsOfDetail) {
  const SceneBuilder scene = hills(240, 12.0);
  // From a corner over the whole terrain, so that every level is in view; only ground lies in the frame.
  const RenderCamera camera{{30, 30, 190}, {263, 263, 0}, 30};
  for (const double quality : {1.0, 0.35, 0.12}) {
    RenderOptions options = sized(480, 270);
    options.quality = quality;
    options.ground = GroundDisplay::GroundType;  // hues that do not depend on light
    EXPECT_EQ(skyPixels(draw(scene.build(), nullptr, camera, options)), 0) << "quality " << quality;
  }
}

TEST_F(TerrainDraw, AHoleShowsWhatIsBehind) {
  SceneBuilder scene;
  addWeather(scene);
  addGround(scene, kSand);
  addTerrain(scene, 65, 65, [](int i, int j) {
    return std::abs(i - 32) <= 4 && std::abs(j - 32) <= 4 ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  });
  const Picture picture = draw(scene.build(), nullptr, {{160, 100, 120}, {160, 160, 0}, 40}, sized(96, 96));
  EXPECT_GE(picture.blue(48, 48), picture.red(48, 48)) << "the hole";
  EXPECT_LT(picture.blue(48, 90), picture.red(48, 90)) << "ground before it";
  EXPECT_LT(picture.blue(8, 48), picture.red(8, 48)) << "ground beside it";
}

TEST_F(TerrainDraw, SunnySlopesAreBrighterAndShadowsFall) {
  SceneBuilder scene;
  addWeather(scene);  // sun from south-south-east, 40 degrees
  addGround(scene, kSand);
  // A long ridge from west to east: its north side and the ground behind it lie in shade.
  addTerrain(scene, 101, 101, [](int, int j) { return std::max(0.0, 80.0 - 12.0 * std::abs(j - 50)); });
  const Picture picture =
      draw(scene.build(), nullptr, {{250, 250, 700}, {250, 250.1, 0}, 40}, sized(128, 128));
  // North is up: row 64 is the crest.
  EXPECT_GT(picture.bright(64, 70), 1.3 * picture.bright(64, 58));
  EXPECT_GT(picture.bright(64, 120), 1.15 * picture.bright(64, 55));
}

TEST_F(TerrainDraw, FalseColoursTellTypesAndTemperatures) {
  SceneBuilder scene = hills(65, 0.0);
  scene.add<GroundTemperatureLayerNode>(kGroundTemperatureLayerType, "warmth",
                                        [](GroundTemperatureLayerNode& g) { g.base = 293.15; });
  TiledRaster<float> painted(65, 65, std::numeric_limits<float>::quiet_NaN());
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 32; ++i) painted.set(i, j, 250.0f);
  scene.snapshot.nodes.back().painted = painted;
  RenderOptions options = sized(64, 64);
  options.ground = GroundDisplay::GroundTemperature;
  const Picture picture = draw(scene.build(), nullptr, {{160, 160, 300}, {160, 160.1, 0}, 40}, options);
  EXPECT_GT(picture.blue(10, 32), 2 * picture.red(10, 32)) << "painted cold in the west";
  EXPECT_GT(picture.red(54, 32), 2 * picture.blue(54, 32)) << "warm where nothing is painted";
}

TEST_F(TerrainDraw, FalseColoursTellDepthsAndWhatIsKeptClear) {
  SceneBuilder scene = hills(65, 0.0);
  scene.add<SnowDepthLayerNode>(kSnowDepthLayerType, "depth", [](SnowDepthLayerNode&) {});
  TiledRaster<float> painted(65, 65, std::numeric_limits<float>::quiet_NaN());
  for (int j = 0; j < 65; ++j)
    for (int i = 0; i < 32; ++i) painted.set(i, j, 1.0f);
  scene.snapshot.nodes.back().painted = painted;
  RenderOptions options = sized(64, 64);
  options.ground = GroundDisplay::SnowDepth;
  const RenderCamera above{{160, 160, 300}, {160, 160.1, 0}, 40};
  Picture picture = draw(scene.build(), nullptr, above, options);
  EXPECT_GT(picture.blue(10, 32), 1.5 * picture.red(10, 32)) << "a metre in the west";
  EXPECT_LT(picture.blue(54, 32), 1.3 * picture.red(54, 32)) << "grey where nothing is painted";

  // Of two masks the selected one is shown.
  for (const char* id : {"road", "yard"}) {
    scene.add<KeepClearLayerNode>(kKeepClearLayerType, id, [](KeepClearLayerNode&) {});
    TiledRaster<float> mask(65, 65, 0.0f);
    for (int j = 0; j < 65; ++j)
      for (int i = 0; i < 65; ++i)
        if ((i < 32) == (id[0] == 'r')) mask.set(i, j, 1.0f);
    scene.snapshot.nodes.back().painted = mask;
  }
  options.ground = GroundDisplay::KeepClear;
  picture = draw(scene.build(), nullptr, above, options);
  EXPECT_GT(picture.red(10, 32), 2 * picture.blue(10, 32)) << "the road's";
  EXPECT_LT(picture.red(54, 32), 1.5 * picture.blue(54, 32));
  options.selectedNode = "yard";
  picture = draw(scene.build(), nullptr, above, options);
  EXPECT_GT(picture.red(54, 32), 2 * picture.blue(54, 32)) << "the yard's";
}

TEST_F(TerrainDraw, AStrokeUploadsOnlyItsTile) {
  SceneBuilder scene = hills(200, 0.0);
  SceneNode& ground = scene.snapshot.nodes[1];
  TiledRaster<std::uint8_t> types(200, 200, kSand);
  ground.painted = types;
  GroundMap map;
  map.update(*scene.build(), 0.0, GroundDisplay::Natural);
  EXPECT_EQ(map.uploadedTiles(), 16u);
  types.set(70, 10, 5);
  scene.snapshot.nodes[1].painted = types;
  map.update(*scene.build(), 0.0, GroundDisplay::Natural);
  EXPECT_EQ(map.uploadedTiles(), 1u);
  std::vector<std::uint8_t> texels(200 * 200 * 4);
  glGetTextureImage(map.texture(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(texels.size()),
                    texels.data());
  const auto blueOf = [&](int i, int j) { return texels[static_cast<std::size_t>((j * 200 + i) * 4 + 2)]; };
  EXPECT_GT(blueOf(70, 10), blueOf(71, 10)) << "ice beside sand";
  map.update(*scene.build(), 0.0, GroundDisplay::GroundType);
  EXPECT_EQ(map.uploadedTiles(), 16u) << "another display shows other colours everywhere";
}

TEST_F(TerrainDraw, LowerQualityDrawsFewerTriangles) {
  const SceneBuilder builder = hills(240, 12.0);
  const SnapshotPointer scene = builder.build();
  TerrainPass pass;
  ASSERT_TRUE(pass.initialise().ok());
  RenderTarget target;
  ASSERT_TRUE(target.prepare(64, 36, GL_RGBA8, 1).ok());
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  pass.setTerrain(scene->terrain);
  const RenderCamera camera{{30, 30, 60}, {600, 600, 0}, 45};
  const auto triangles = [&](double quality) {
    RenderOptions options = sized(1280, 720);
    options.quality = quality;
    FrameBlock block;
    block.viewProjection = viewProjection(camera, 16.0 / 9.0, 0.1);
    const DrawContext context{*scene, camera, 0.0, options, block, Frustum(block.viewProjection), 869.0};
    pass.draw(context, {}, {});
    return pass.trianglesDrawn();
  };
  EXPECT_GT(triangles(1.0), 5000u);
  EXPECT_LT(triangles(1.0), 120000u);
  EXPECT_LT(2 * triangles(0.25), triangles(1.0));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace
}  // namespace spin::test
