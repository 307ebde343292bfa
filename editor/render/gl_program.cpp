// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/gl_program.h"

#include <fmt/format.h>

#include "editor/render/shader_source.h"

namespace spin {
namespace {

struct ShaderObject {
  explicit ShaderObject(GLenum stage) : id(glCreateShader(stage)) {}
  ~ShaderObject() { glDeleteShader(id); }
  ShaderObject(const ShaderObject&) = delete;
  ShaderObject& operator=(const ShaderObject&) = delete;
  GLuint id;
};

Error shaderError(std::string_view where, std::string why) {
  return {ErrorKind::Failed, "A shader could not be built", std::string(where), std::move(why),
          "Update the graphics driver; OpenGL 4.5 is needed"};
}

Status compile(const ShaderObject& shader, std::string_view name, std::string_view defines) {
  const std::string_view body = shaderSource(name);
  if (body.empty()) return shaderError(name, "the program holds no text of this name");
  const std::string text =
      fmt::format("#version 450 core\n{}\n#line 1\n{}\n#line 1\n{}\n#line 1\n{}", defines,
                  shaderSource("common.glsl"), shaderSource("lighting.glsl"), body);
  const char* data = text.c_str();
  glShaderSource(shader.id, 1, &data, nullptr);
  glCompileShader(shader.id);
  GLint ok = 0;
  glGetShaderiv(shader.id, GL_COMPILE_STATUS, &ok);
  if (ok != 0) return {};
  char message[2048] = {};
  glGetShaderInfoLog(shader.id, sizeof message, nullptr, message);
  return shaderError(name, message);
}

}  // namespace

GlProgram::~GlProgram() {
  if (m_id != 0) glDeleteProgram(m_id);
}
GlProgram::GlProgram(GlProgram&& other) noexcept
    : m_id(std::exchange(other.m_id, 0)), m_locations(std::move(other.m_locations)) {}
GlProgram& GlProgram::operator=(GlProgram&& other) noexcept {
  std::swap(m_id, other.m_id);
  std::swap(m_locations, other.m_locations);
  return *this;
}

Result<GlProgram> GlProgram::build(std::string_view vertexName, std::string_view fragmentName,
                                   std::string_view defines) {
  const ShaderObject vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
  if (Status s = compile(vertex, vertexName, defines); !s) return s.error();
  if (Status s = compile(fragment, fragmentName, defines); !s) return s.error();
  GlProgram program;
  program.m_id = glCreateProgram();
  glAttachShader(program.m_id, vertex.id);
  glAttachShader(program.m_id, fragment.id);
  glLinkProgram(program.m_id);
  glDetachShader(program.m_id, vertex.id);
  glDetachShader(program.m_id, fragment.id);
  GLint ok = 0;
  glGetProgramiv(program.m_id, GL_LINK_STATUS, &ok);
  if (ok != 0) return program;
  char message[2048] = {};
  glGetProgramInfoLog(program.m_id, sizeof message, nullptr, message);
  return shaderError(fmt::format("{} + {}", vertexName, fragmentName), message);
}

GLint GlProgram::location(const char* name) const {
  for (const auto& [known, place] : m_locations)
    if (known == name) return place;
  const GLint place = glGetUniformLocation(m_id, name);
  m_locations.emplace_back(name, place);
  return place;
}

}  // namespace spin
