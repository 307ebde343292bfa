# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
# Writes OUTPUT: a C++ file with the text of all SHADERS, see spin_shaders.cmake.
set(text "// Generated from resources/shaders.\n#include \"editor/render/shader_source.h\"\n\nnamespace spin {\n\nstd::string_view shaderSource(std::string_view name) {\n")
foreach(shader ${SHADERS})
  get_filename_component(name "${shader}" NAME)
  file(READ "${shader}" body)
  string(APPEND text "  if (name == \"${name}\") return R\"SPIN_GLSL(${body})SPIN_GLSL\";\n")
endforeach()
string(APPEND text "  return {};\n}\n\n}  // namespace spin\n")
file(WRITE "${OUTPUT}" "${text}")
