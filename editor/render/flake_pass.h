// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/frame.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Draws falling flakes as sprites of their true size, drawn out by their motion.
class FlakePass {
 public:
  Status initialise();
  /// Takes a frame's flakes (attributes "diameter" in m and "velocity" in m/s); null = none.
  void setFlakes(std::shared_ptr<const ParticlePart> flakes);
  void draw(const DrawContext& context) const;

 private:
  void growIndices(std::size_t flakes);

  std::shared_ptr<const ParticlePart> m_flakes;
  bool m_hasDiameters = false, m_hasVelocities = false;
  std::size_t m_indexedFlakes = 0;
  GlBuffer m_positions, m_diameters, m_velocities, m_indices;
  GlTexture m_shapes;
  GlVertexArray m_vertexArray;
  GlProgram m_program;
};

}  // namespace spin
