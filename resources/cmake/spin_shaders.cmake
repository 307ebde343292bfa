# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
# spin_embed_shaders(TARGET DIR): every file of DIR becomes a string; shaderSource("name.ext") in editor/render/shader_source.h
# finds it. Written at build time, again when a shader changes.
function(spin_embed_shaders target dir)
  file(GLOB shaders CONFIGURE_DEPENDS "${dir}/*.vert" "${dir}/*.frag" "${dir}/*.geom" "${dir}/*.comp" "${dir}/*.glsl")
  set(output "${CMAKE_CURRENT_BINARY_DIR}/embedded_shaders.cpp")
  add_custom_command(
    OUTPUT "${output}"
    COMMAND "${CMAKE_COMMAND}" "-DOUTPUT=${output}" "-DSHADERS=${shaders}" -P "${PROJECT_SOURCE_DIR}/resources/cmake/embed_shaders.cmake"
    DEPENDS ${shaders} "${PROJECT_SOURCE_DIR}/resources/cmake/embed_shaders.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${output}")
endfunction()
