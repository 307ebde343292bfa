// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/sim/frame.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// What is drawn of one parcel of drops.
struct SprayPuff {
  Vec3f position;  ///< local m
  float area;      ///< m2 that its drops hide together, seen one by one
  Vec3f velocity;  ///< m/s
  float radius;    ///< m
};

/// A parcel of mass m in drops of a diameter d hides 1.5 m / (rho d). It spreads over a ball that begins at
/// twice the radius of its water and grows with its age; since it falls faster than it left, it is drawn out
/// along its way as well. It is shown in several pieces, fewer where there are many parcels. Parcels with
/// numbers that cannot be are left out.
std::vector<SprayPuff> sprayPuffs(const ParticleSet& set);

/// Particles of a flow of water that hardly any other is near (looseWater()), as parcels: torn to drops of
/// some millimetres. `spacing` of particles at rest, m.
std::vector<SprayPuff> loosePuffs(const ParticleSet& flow, double spacing);

/// Draws spray: parcels as soft streaks of what they move while the shutter is open, in any order, with
/// weighted blended transparency (M. McGuire, L. Bavoil 2013).
class SprayPass {
 public:
  Status initialise();
  /// Takes a frame's parts "spray" and "flow"; null = none. Of the flow it draws what is loose, where the
  /// flow is drawn as what it is.
  void setSpray(std::shared_ptr<const ParticlePart> spray, std::shared_ptr<const ParticlePart> flow,
                double spacing);
  bool empty() const { return m_count + m_looseCount == 0; }
  /// Adds it to the picture in `framebuffer`, whose depth the texture `depth` repeats. The cloud in the air
  /// hides it as airKept() says. Leaves the framebuffer bound, blending changed.
  void draw(GLuint framebuffer, GLuint depth, const DrawContext& context);

 private:
  Status prepareTargets(int width, int height);

  std::shared_ptr<const ParticlePart> m_spray, m_flow;
  std::size_t m_count = 0, m_looseCount = 0;  ///< parcels; loose ones, after them
  Box3d m_bounds;
  int m_width = 0, m_height = 0;
  GlBuffer m_puffs;
  GlTexture m_sum, m_through;  ///< weighted colour and cover; share of what is behind that is still seen
  GlFramebuffer m_framebuffer;
  GlVertexArray m_vertexArray;
  GlProgram m_program, m_blend;
};

}  // namespace spin
