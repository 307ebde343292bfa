// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace spin {

/// Owner of one OpenGL object; frees it with the context current. Traits give create and destroy.
template <class Traits>
class GlHandle {
 public:
  GlHandle() = default;
  template <class... Args>
  static GlHandle make(Args... args) {
    GlHandle handle;
    handle.m_id = Traits::create(args...);
    return handle;
  }
  ~GlHandle() { reset(); }
  GlHandle(GlHandle&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    if (this != &other) {
      reset();
      m_id = std::exchange(other.m_id, 0);
    }
    return *this;
  }
  GLuint id() const { return m_id; }
  explicit operator bool() const { return m_id != 0; }
  void reset() {
    if (m_id != 0) Traits::destroy(m_id);
    m_id = 0;
  }

 private:
  GLuint m_id = 0;
};

struct GlBufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glCreateBuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct GlVertexArrayTraits {
  static GLuint create() {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};
struct GlTextureTraits {
  static GLuint create(GLenum target) {
    GLuint id = 0;
    glCreateTextures(target, 1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct GlFramebufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct GlRenderbufferTraits {
  static GLuint create() {
    GLuint id = 0;
    glCreateRenderbuffers(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteRenderbuffers(1, &id); }
};

using GlBuffer = GlHandle<GlBufferTraits>;
using GlVertexArray = GlHandle<GlVertexArrayTraits>;
using GlTexture = GlHandle<GlTextureTraits>;
using GlFramebuffer = GlHandle<GlFramebufferTraits>;
using GlRenderbuffer = GlHandle<GlRenderbufferTraits>;

/// Sampling of a texture: minification, magnification, wrap on both axes.
inline void setSampling(const GlTexture& texture, GLint minify, GLint magnify, GLint wrap) {
  glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, minify);
  glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, magnify);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_S, wrap);
  glTextureParameteri(texture.id(), GL_TEXTURE_WRAP_T, wrap);
}

}  // namespace spin
