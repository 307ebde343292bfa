// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

namespace spin {

struct EglContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  ~State() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    // The display is shared by all contexts of the process and stays initialised.
  }
};

namespace {

Error eglError(const char* step) {
  return {ErrorKind::Failed, "No OpenGL context could be made", "EGL",
          fmt::format("{} failed with error 0x{:04x}", step, eglGetError()),
          "Install Mesa's libegl-mesa0 and libgl1-mesa-dri; OpenGL 4.5 is needed"};
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::create() {
  std::unique_ptr<EglContext> made(new EglContext);
  made->m_state = std::make_unique<State>();
  State& state = *made->m_state;
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) return eglError("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return eglError("eglInitialize");
  state.display = display;
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return eglError("eglBindAPI");
  const EGLint configWish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, configWish, &config, 1, &count) == EGL_FALSE || count == 0)
    return eglError("eglChooseConfig");
  const EGLint contextWish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                4,
                                EGL_CONTEXT_MINOR_VERSION,
                                5,
                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                EGL_NONE};
  state.context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextWish);
  if (state.context == EGL_NO_CONTEXT) return eglError("eglCreateContext");
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, state.context) == EGL_FALSE)
    return eglError("eglMakeCurrent");
  return made;
}

EglContext::~EglContext() = default;

std::string EglContext::rendererName() const {
  const auto* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace spin
