// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

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

constexpr EGLint kMaxDevices = 16;

Error eglError(const char* step) {
  return {ErrorKind::Failed, "No OpenGL context could be made", "EGL",
          fmt::format("{} failed with error 0x{:04x}", step, eglGetError()),
          "Install Mesa's libegl-mesa0 and libgl1-mesa-dri; OpenGL 4.5 is needed"};
}

bool has(const char* list, const char* extension) {
  return list && std::strstr(list, extension) != nullptr;
}

bool softwareWanted() {
  const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  return value && (std::strcmp(value, "1") == 0 || std::strcmp(value, "true") == 0);
}

/// Displays of the graphics cards, then the one without a device, where Mesa chooses. The first alone would
/// miss machines without a card, the last alone cards whose driver is not Mesa's.
std::vector<EGLDisplay> displays() {
  std::vector<EGLDisplay> found;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!softwareWanted() && has(client, "EGL_EXT_device_enumeration") &&
      has(client, "EGL_EXT_platform_device")) {
    EGLDeviceEXT devices[kMaxDevices] = {};
    EGLint count = 0;
    if (eglQueryDevicesEXT(kMaxDevices, devices, &count) == EGL_FALSE) count = 0;
    for (EGLint k = 0; k < count; ++k) {
      if (has(eglQueryDeviceStringEXT(devices[k], EGL_EXTENSIONS), "EGL_MESA_device_software")) continue;
      found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[k], nullptr));
    }
  }
  found.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return found;
}

Status makeCurrentOn(EGLDisplay display, EGLContext& context) {
  if (display == EGL_NO_DISPLAY) return eglError("eglGetPlatformDisplay");
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return eglError("eglInitialize");
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
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextWish);
  if (context == EGL_NO_CONTEXT) return eglError("eglCreateContext");
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_TRUE) return {};
  const Error error = eglError("eglMakeCurrent");
  eglDestroyContext(display, std::exchange(context, EGL_NO_CONTEXT));
  return error;
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::create() {
  std::unique_ptr<EglContext> made(new EglContext);
  made->m_state = std::make_unique<State>();
  Status status;
  for (const EGLDisplay display : displays()) {
    status = makeCurrentOn(display, made->m_state->context);
    if (!status) continue;
    made->m_state->display = display;
    return made;
  }
  return status.error();
}

EglContext::~EglContext() = default;

std::string EglContext::rendererName() const {
  const auto* name = glGetString(GL_RENDERER);
  return name ? reinterpret_cast<const char*>(name) : "";
}

}  // namespace spin
