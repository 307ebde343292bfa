// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/nodes/settings_nodes.h"
#include "core/sim/frame.h"
#include "editor/render/draw_context.h"
#include "editor/render/flow_scale.h"
#include "editor/render/flow_targets.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Draws flowing particles as the surface they make together: the depth of their spheres is smoothed in the
/// picture (after the idea of screen-space fluids, W. van der Laan et al. 2009; the filter keeps to a narrow
/// range, N. Truong and C. Yuksel 2018), and the smooth surface is lit as snow or water, or coloured by a
/// value.
class FlowPass {
 public:
  Status initialise();
  /// Takes a frame's parts "flow" and "flow_boundary"; null = none. Spacing of particles at rest in m; 0 = as
  /// the positions show it.
  void setFlow(std::shared_ptr<const ParticlePart> flow, std::shared_ptr<const ParticlePart> boundary,
               double spacing);
  /// Whether fast snow raises dust in the natural look: not where the air itself tells of it.
  void showDust(bool on) { m_dustShown = on; }
  bool empty() const { return m_count == 0; }
  double spacing() const { return m_spacing; }
  /// Box round all particles, local m.
  const Box3d& bounds() const { return m_bounds; }
  /// What the drawn depth depends on: another number after every setFlow() that changed something.
  double revision() const { return m_revision; }

  /// Draws the surface's depth and normals into targets of its own, where the last ones do not fit. Changes
  /// framebuffer, viewport and depth function.
  void prepare(const DrawContext& context);
  /// Puts the prepared surface into the bound framebuffer, behind what is nearer there. Changes blending.
  void draw(const DrawContext& context) const;
  /// Depth only, for a shadow map with `texelsPerMetre`.
  void drawDepth(const Matrix4& light, double texelsPerMetre) const;

 private:
  void uploadLooks(const RenderNode& settings);
  /// Which particles are drawn: one of `stride`, with the spacing that they have then.
  struct Points {
    std::size_t count, stride;
    double spacing;
  };
  Points drawnPoints(double quality) const;
  void drawParticles(const GlProgram& program, int width, int height, const Points& points,
                     const DrawContext& context) const;
  void gather(const GlProgram& program, const GlFramebuffer& target, const Points& points,
              const DrawContext& context) const;
  void drawDust() const;
  void smooth(const DrawContext& context);
  void drawSurface(const DrawContext& context);

  std::shared_ptr<const ParticlePart> m_flow, m_boundary;
  std::size_t m_count = 0;          ///< particles in the buffers
  std::size_t m_boundaryCount = 0;  ///< of these, boundary particles, at the end
  double m_spacing = 0.1;           ///< m
  double m_revision = 0.0, m_looksRevision = 0.0;
  Box3d m_bounds, m_allBounds;  ///< of the flow; with the boundary
  FlowScale m_scale;
  std::vector<double> m_looksKey, m_preparedKey;
  bool m_boundaryShown = false;
  bool m_dustShown = true;
  bool m_dusty = false;           ///< some snow is fast enough to raise dust
  std::array<int, 4> m_pixels{};  ///< of the picture, in which something flows
  FlowTargets m_targets;
  GlBuffer m_positions, m_looks;
  GlVertexArray m_vertexArray;
  GlProgram m_distanceProgram, m_thicknessProgram, m_smoothProgram, m_normalProgram, m_materialProgram,
      m_valueProgram, m_depthProgram, m_dustProgram, m_cloudProgram;
};

/// Which particles are water that hardly any other is near: drawn as spray, not as part of the surface. Empty
/// where the set tells no neighbours or no density.
std::vector<bool> looseWater(const ParticleSet& set);

/// Distance of neighbours at rest as the positions show it: the median distance to the nearest one, of a
/// sample. 0 for less than two particles.
double estimateSpacing(const std::vector<Vec3f>& positions);

}  // namespace spin
