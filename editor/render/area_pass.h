// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Tints the ground that the selected release covers: within its outline and where it is painted. A help for
/// editing; pictures of the command line select nothing.
class AreaPass {
 public:
  Status initialise();
  /// Takes over a scene and the selected node; does nothing where neither changed.
  void setScene(const SnapshotPointer& scene, const std::string& selected);
  void draw() const;
  bool empty() const { return m_count == 0; }

 private:
  SnapshotPointer m_scene;
  std::string m_selected;
  GlProgram m_program;
  GlVertexArray m_vertexArray;
  GlBuffer m_vertices, m_indices;
  GLsizei m_count = 0;
};

/// Whether a point in plan lies within a closed outline (even-odd rule; less than three corners hold
/// nothing).
bool withinOutline(const std::vector<Vec2d>& outline, Vec2d point);

/// Per cell of the terrain 1 where the release covers it, else 0; row by row. Empty where the node is no
/// release or covers nothing.
std::vector<std::uint8_t> releaseMask(const SceneSnapshot& scene, const SceneNode& release);

}  // namespace spin
