// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/renderer.h"
#include "core/sim/flakes_part.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/nodes/camera_node.h"
#include "editor/render/gl_objects.h"
#include "tests/render/gl_fixture.h"

namespace spin::test {
namespace {

class RendererTest : public GlTest {
 protected:
  /// A small winter scene with everything in it.
  static std::pair<SnapshotPointer, FramePointer> winter() {
    SceneBuilder builder;
    addWeather(builder);
    addGround(builder, 3);
    addTerrain(builder, 65, 65,
               [](int i, int j) { return 6.0 * std::sin(i * 0.2) + 0.02 * (j - 20) * std::max(0, j - 20); });
    addModel(builder, "box", boxModel({8, 6, 5}), {160, 120, 4});
    const SnapshotPointer scene = builder.build();
    auto frame = frameWithCover(*scene, [](int i, int j) { return 0.3 * ((i / 8 + j / 8) % 2); });
    CoverGrid patch{"box/0", "box", Raster<float>(40, 30, -3.9, -2.9, 0.2, 5.0f), {}};
    patch.area = patch.base.sameShape<float>(0.04f);
    addGrid(*frame, patch, std::vector<float>(patch.base.size(), 0.35f));
    auto flakes = std::make_shared<FlakesPart>();
    FlakeClass one;
    one.diameter = 0.004;
    flakes->flakes.classes.assign(kFlakeClasses, one);
    flakes->flakes.numberDensity = 150.0;
    flakes->flakes.cover = 0.4;
    frame->parts["flakes"] = flakes;
    return {scene, frame};
  }
  static constexpr RenderCamera kCamera{{145, 92, 12}, {162, 130, 8}, 50};
};

TEST_F(RendererTest, SameInputGivesTheSameBytes) {
  const auto [scene, frame] = winter();
  const Picture first = draw(scene, frame, kCamera, sized(160, 90));
  draw(nullptr, nullptr, kCamera, sized(32, 18));
  Renderer another;
  ASSERT_TRUE(another.initialise().ok());
  another.setScene(scene);
  another.setFrame(frame);
  EXPECT_EQ(drawPicture(another, kCamera, sized(160, 90)).rgb, first.rgb);
  EXPECT_EQ(draw(scene, frame, kCamera, sized(160, 90)).rgb, first.rgb);
  const auto a = s_renderer->drawLinear(kCamera, 0.0, sized(160, 90), 4),
             b = another.drawLinear(kCamera, 0.0, sized(160, 90), 4);
  ASSERT_TRUE(a.ok() && b.ok());
  EXPECT_EQ(*a, *b);
}

/// Bands of uneven height, drawn one after the other, give the picture that one draw gives.
TEST_F(RendererTest, BandsMakeUpTheWholePicture) {
  const auto [scene, frame] = winter();
  const Picture whole = draw(scene, frame, kCamera, sized(160, 90));
  draw(scene, frame, {{100, 92, 12}, {162, 130, 8}, 50}, sized(160, 90));
  const std::vector<Vec2d> bands{{0.0, 0.211}, {0.211, 0.5}, {0.5, 0.977}, {0.977, 1.0}};
  EXPECT_NE(drawPicture(*s_renderer, kCamera, sized(160, 90), {bands[0], bands[2]}).rgb, whole.rgb);
  EXPECT_EQ(drawPicture(*s_renderer, kCamera, sized(160, 90), bands).rgb, whole.rgb);
}

TEST_F(RendererTest, LinearValuesEncodeToWhatTheViewportShows) {
  const auto [scene, frame] = winter();
  const Picture shown = draw(scene, frame, kCamera, sized(160, 90));
  const auto linear = s_renderer->drawLinear(kCamera, 0.0, sized(160, 90), 1);
  ASSERT_TRUE(linear.ok());
  ASSERT_EQ(linear->size(), 160u * 90u * 4u);
  Picture encoded{160, 90, {}};
  for (std::size_t k = 0; k < linear->size(); k += 4)
    for (std::size_t c = 0; c < 3; ++c) {
      const double v = std::clamp(static_cast<double>((*linear)[k + c]), 0.0, 1.0);
      const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
      encoded.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0 * s)));
    }
  EXPECT_LT(difference(shown, encoded), 1.0);
}

TEST_F(RendererTest, MultisamplingSmoothsEdgesOnly) {
  const auto [scene, frame] = winter();
  draw(scene, frame, kCamera, sized(16, 16));
  const auto one = s_renderer->drawLinear(kCamera, 0.0, sized(160, 90), 1),
             four = s_renderer->drawLinear(kCamera, 0.0, sized(160, 90), 4);
  ASSERT_TRUE(one.ok() && four.ok());
  double change = 0.0;
  for (std::size_t k = 0; k < one->size(); ++k)
    change += std::abs(static_cast<double>((*one)[k] - (*four)[k]));
  change /= static_cast<double>(one->size());
  EXPECT_GT(change, 1e-5);
  EXPECT_LT(change, 0.03);
}

TEST_F(RendererTest, ImpossibleSizesAreErrors) {
  EXPECT_FALSE(s_renderer->drawLinear(kCamera, 0.0, sized(0, 90), 1).ok());
  EXPECT_FALSE(s_renderer->drawLinear(kCamera, 0.0, sized(1000000, 4), 1).ok());
}

TEST_F(RendererTest, TimingsNameThePassesWhenAskedFor) {
  const auto [scene, frame] = winter();
  draw(scene, frame, kCamera, sized(64, 36));
  EXPECT_TRUE(s_renderer->timings().table().empty());
  s_renderer->setMeasuring(true);
  draw(scene, frame, kCamera, sized(64, 36));
  s_renderer->setMeasuring(false);
  for (const char* pass : {"terrain", "models", "cover", "flakes", "sky"})
    EXPECT_GT(s_renderer->timings().seconds(pass), 0.0) << pass;
}

TEST_F(RendererTest, TheContextIsLeftAsOthersExpectIt) {
  const auto [scene, frame] = winter();
  glViewport(1, 2, 30, 40);
  draw(scene, frame, kCamera, sized(64, 36));
  GLint viewport[4] = {}, origin = 0, depthMode = 0, program = -1;
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_CLIP_DEPTH_MODE, &depthMode);
  glGetIntegerv(GL_CLIP_ORIGIN, &origin);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  EXPECT_EQ(viewport[2], 30);
  EXPECT_EQ(depthMode, GL_NEGATIVE_ONE_TO_ONE);
  EXPECT_EQ(origin, GL_LOWER_LEFT);
  EXPECT_EQ(program, 0);
  EXPECT_EQ(glIsEnabled(GL_DEPTH_TEST), GL_FALSE);
  EXPECT_EQ(glIsEnabled(GL_FRAMEBUFFER_SRGB), GL_FALSE);
}

TEST_F(RendererTest, CameraOfTheSceneFollowsItsKeys) {
  SceneBuilder builder;
  builder.add<CameraNode>(kCameraType, "camera", [](CameraNode& c) { c.fovDegrees = 33.0; });
  AnimationCurve curve;
  curve.setKey({0.0, Vec3d{0, 0, 0}, Interpolation::Linear});
  curve.setKey({2.0, Vec3d{10, 0, 4}, Interpolation::Linear});
  builder.snapshot.nodes.back().curves["position_m"] = curve;
  const RenderCamera camera = cameraOf(*builder.build(), 1.0);
  EXPECT_NEAR(camera.position.x, 5.0, 1e-9);
  EXPECT_NEAR(camera.position.z, 2.0, 1e-9);
  EXPECT_EQ(camera.fovDegrees, 33.0);
}

/// Run with SPIN_UPDATE_BASELINES=1 to write the picture anew after a wanted change of looks.
TEST_F(RendererTest, WinterLooksAsItDid) {
  const auto [scene, frame] = winter();
  const Picture now = draw(scene, frame, kCamera, sized(160, 90));
  const std::filesystem::path path = std::filesystem::path(SPIN_BASELINE_DIR) / "winter.ppm";
  if (std::getenv("SPIN_UPDATE_BASELINES")) {
    std::filesystem::create_directories(path.parent_path());
    ASSERT_TRUE(writePpm(now, path.string()));
  }
  const Picture before = readPpm(path.string());
  ASSERT_EQ(before.rgb.size(), now.rgb.size()) << "no baseline at " << path;
  const double change = difference(before, now);
  if (change > 2.0) writePpm(now, "winter_now.ppm");
  EXPECT_LT(change, 2.0) << "mean difference in 8-bit steps; the new picture is winter_now.ppm";
}

}  // namespace
}  // namespace spin::test
