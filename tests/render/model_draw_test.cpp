// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/terrain_node.h"
#include "core/nodes/weather_nodes.h"
#include "editor/render/gl_program.h"
#include "editor/render/model_pass.h"
#include "editor/render/shadow_pass.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class ModelDraw : public GlTest {
 protected:
  static constexpr RenderCamera kFront{{0, -6, 1}, {0, 0, 1}, 30};
};

TEST_F(ModelDraw, TextureIsTheRightWayRound) {
  SceneBuilder scene;
  addWeather(scene);
  addModel(scene, "square", texturedSquare(), {0, 0, 0});
  const Picture p = draw(scene.build(), nullptr, kFront, sized(128, 128));
  // Corners of the square: top left red, top right green, bottom left blue, bottom right yellow.
  EXPECT_GT(p.red(44, 44), 2 * p.green(44, 44));
  EXPECT_GT(p.green(84, 44), 2 * p.red(84, 44));
  EXPECT_GT(p.blue(44, 84), 2 * p.red(44, 84));
  EXPECT_GT(p.red(84, 84), 2 * p.blue(84, 84));
  EXPECT_GT(p.green(84, 84), 2 * p.blue(84, 84));
}

TEST_F(ModelDraw, CutOutTexelsAreClear) {
  SceneBuilder scene;
  addWeather(scene);
  auto model = texturedSquare();
  model->materials[0].alphaCutout = true;
  model->textures[0].rgba[3] = 0;  // top left
  addModel(scene, "square", model, {0, 0, 0});
  const Picture sky =
      draw(SceneBuilder(scene).build(), nullptr, {{0, -6, 1}, {0, -12, 1}, 30}, sized(128, 128));
  const Picture p = draw(scene.build(), nullptr, kFront, sized(128, 128));
  EXPECT_GE(p.blue(36, 36), p.red(36, 36)) << "sky through the cut";
  EXPECT_GT(p.green(84, 44), 2 * p.red(84, 44));
  EXPECT_GT(sky.blue(36, 36), 60);
}

TEST_F(ModelDraw, SelectionIsMarked) {
  SceneBuilder scene;
  addWeather(scene);
  addModel(scene, "square", texturedSquare(), {0, 0, 0});
  const SnapshotPointer snapshot = scene.build();
  RenderOptions options = sized(64, 64);
  const Picture plain = draw(snapshot, nullptr, kFront, options);
  options.selectedNode = "square";
  EXPECT_GT(difference(plain, draw(snapshot, nullptr, kFront, options)), 3.0);
  options.selectedNode = "another";
  EXPECT_EQ(difference(plain, draw(snapshot, nullptr, kFront, options)), 0.0);
}

TEST_F(ModelDraw, ModelsCastShadowsOnTheGround) {
  SceneBuilder with, without;
  for (SceneBuilder* scene : {&with, &without}) {
    scene->add<WeatherNode>(kWeatherType, "weather", [](WeatherNode& w) {
      w.cloudCover = 0.1;
      w.sunElevationDegrees = 30.0;
      w.sunAzimuthDegrees = 180.0;
    });
    addGround(*scene, 1);
    addTerrain(*scene, 33, 33, [](int, int) { return 0.0; });
  }
  addModel(with, "box", boxModel({6, 6, 10}), {80, 80, 0});
  const RenderCamera camera{{80, 60, 40}, {80, 85, 0}, 45};
  const Picture a = draw(with.build(), nullptr, camera, sized(128, 128));
  const Picture b = draw(without.build(), nullptr, camera, sized(128, 128));
  // The sun stands in the south, the camera too: the shadow falls beyond the box, up to 17 m north of it.
  int darker = 0, same = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      darker += a.red(x, y) > a.blue(x, y) && 10 * a.bright(x, y) < 8 * b.bright(x, y) && y < 50;
      same += std::abs(a.bright(x, y) - b.bright(x, y)) < 3;
    }
  EXPECT_GT(darker, 60);
  EXPECT_GT(same, 128 * 64) << "the sunny ground is unchanged";
}

TEST_F(ModelDraw, SharedDataIsHeldOnceAndShadowsAreDrawnOnlyWhenNeeded) {
  SceneBuilder scene;
  addWeather(scene);
  const auto data = boxModel({1, 1, 1});
  addModel(scene, "one", data, {0, 0, 0});
  addModel(scene, "two", data, {5, 0, 0});
  const SnapshotPointer snapshot = scene.build();
  ModelPass models;
  ASSERT_TRUE(models.initialise().ok());
  models.setScene(*snapshot);
  EXPECT_EQ(models.modelsHeld(), 1u);
  ShadowPass shadows;
  const FlowPass flow;
  ASSERT_TRUE(shadows.initialise().ok());
  FrameBlock block;
  const Vec3d sun = normalized(Vec3d{1, 1, 1});
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  const auto update = [&](const SceneSnapshot& s, Vec3d eye) {
    shadows.update(models, models.place(s, 0.0, nullptr), flow, {eye, eye + Vec3d{0, 10, 0}, 45}, sun, block);
    return shadows.timesDrawn();
  };
  EXPECT_EQ(update(*snapshot, {0, -10, 2}), 2u) << "sun and zenith";
  EXPECT_EQ(update(*snapshot, {0, -10.2, 2}), 2u) << "a small step of the camera";
  scene.snapshot.nodes.back().data = [] {
    auto moved = std::make_shared<ModelNode>();
    moved->position = {6, 1, 0};
    moved->onGround = false;
    return moved;
  }();
  EXPECT_EQ(update(*scene.build(), {0, -10.2, 2}), 4u) << "a model moved";
  glDisable(GL_DEPTH_TEST);
  glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  models.setScene(SceneSnapshot{});
  EXPECT_EQ(models.modelsHeld(), 0u);
}

TEST_F(ModelDraw, HostileMeshesAreLeftOut) {
  SceneBuilder scene;
  addWeather(scene);
  auto model = texturedSquare();
  model->meshes[0].indices[4] = 1000000;
  model->textures[0].width = 4096;  // does not fit its data
  addModel(scene, "square", model, {0, 0, 0});
  const Picture with = draw(scene.build(), nullptr, kFront, sized(64, 64));
  SceneBuilder empty;
  addWeather(empty);
  EXPECT_EQ(difference(with, draw(empty.build(), nullptr, kFront, sized(64, 64))), 0.0);
}

TEST_F(ModelDraw, ShaderProblemsAreErrorsWithTheDriversWords) {
  const auto missing = GlProgram::build("absent.vert", "model.frag");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().where, "absent.vert");
  const auto broken = GlProgram::build("model.vert", "model.frag", "#define main 7");
  ASSERT_FALSE(broken.ok());
  EXPECT_FALSE(broken.error().why.empty());
}

}  // namespace
}  // namespace spin::test
