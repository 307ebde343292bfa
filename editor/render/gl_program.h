// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "editor/render/gl_objects.h"

namespace spin {

/// A linked pair of vertex and fragment shader from resources/shaders. Each text is preceded by the version
/// line, the defines, common.glsl and lighting.glsl.
class GlProgram {
 public:
  GlProgram() = default;
  ~GlProgram();
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&& other) noexcept;

  /// `defines` holds lines such as "#define FINE 1". The error carries the driver's message.
  static Result<GlProgram> build(std::string_view vertexName, std::string_view fragmentName,
                                 std::string_view defines = {});
  void use() const { glUseProgram(m_id); }
  GLuint id() const { return m_id; }

  void set(const char* name, int value) const { glProgramUniform1i(m_id, location(name), value); }
  void set(const char* name, int x, int y, int z, int w) const {
    glProgramUniform4i(m_id, location(name), x, y, z, w);
  }
  void set(const char* name, float value) const { glProgramUniform1f(m_id, location(name), value); }
  void set(const char* name, float x, float y, float z, float w) const {
    glProgramUniform4f(m_id, location(name), x, y, z, w);
  }
  void setMatrix(const char* name, const std::array<float, 16>& columnMajor) const {
    glProgramUniformMatrix4fv(m_id, location(name), 1, GL_FALSE, columnMajor.data());
  }
  void setArray(const char* name, const float* vec4s, int count) const {
    glProgramUniform4fv(m_id, location(name), count, vec4s);
  }

 private:
  /// -1 (ignored by OpenGL) where the compiler dropped an unused uniform.
  GLint location(const char* name) const;

  GLuint m_id = 0;
  mutable std::vector<std::pair<std::string, GLint>> m_locations;
};

}  // namespace spin
