// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "editor/render/egl_context.h"
#include "tests/render/render_scene.h"

namespace spin::test {

/// A context for all tests of a suite and a renderer; every test ends without an OpenGL error.
class GlTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = EglContext::create();
    ASSERT_TRUE(made.ok()) << made.error().text();
    s_context = std::move(made).value();
    s_renderer = std::make_unique<Renderer>();
    const Status ready = s_renderer->initialise();
    ASSERT_TRUE(ready.ok()) << ready.error().text();
  }
  static void TearDownTestSuite() {
    s_renderer.reset();
    s_context.reset();
  }
  void SetUp() override { ASSERT_NE(s_renderer, nullptr); }
  void TearDown() override { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }

  static RenderOptions sized(int width, int height) {
    RenderOptions options;
    options.width = width;
    options.height = height;
    return options;
  }
  Picture draw(SnapshotPointer scene, FramePointer frame, const RenderCamera& camera,
               const RenderOptions& options) {
    s_renderer->setScene(std::move(scene));
    s_renderer->setFrame(std::move(frame));
    return drawPicture(*s_renderer, camera, options);
  }

  static inline std::unique_ptr<EglContext> s_context;
  static inline std::unique_ptr<Renderer> s_renderer;
};

}  // namespace spin::test
