// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/sim/air_part.h"
#include "editor/render/air_blocks.h"
#include "editor/render/air_light.h"
#include "editor/render/air_targets.h"
#include "editor/render/air_values.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Draws mist and powder in the air: rays are marched through the cloud in a picture of half the size, with
/// starts that differ by pixel in a fixed pattern, and the result is laid over the picture where its depth
/// agrees. Extinction is that of the drops' and grains' size; light is AirLight's, and the sun's straight
/// into the eye. Or values in colours, in the whole cloud or on a plane.
class AirPass {
 public:
  /// Rows of the picture beyond a band that draw() reads.
  static constexpr int kMarginRows = 8;

  Status initialise();
  /// Takes a frame's air; null = none.
  void setAir(std::shared_ptr<const AirPart> air);
  bool empty() const { return !m_air; }
  /// Whether the air holds powder.
  bool hasSnow() const;

  /// Brings textures up to date. `sky` is that of the picture, its sunShare that of the land `landRevision`.
  void prepare(const DrawContext& context, const AirSky& sky, double landRevision);
  /// Whether draw() has anything to do for what was prepared last.
  bool shows() const { return m_shownPixels[0] < m_shownPixels[2]; }
  /// Lays the cloud over the picture in `framebuffer`, whose depth `depth` (a texture) repeats, and over the
  /// ground its shadow. Leaves the framebuffer bound, blending changed.
  void draw(GLuint framebuffer, GLuint depth, const DrawContext& context);
  /// Binds what airKept() of air_kept.glsl reads: the cloud drawn last, or none.
  void bindKept() const;

 private:
  void buildNatural(const AirSky& sky);
  void buildValues(const RenderNode& settings);
  void buildSlice(const RenderNode& settings);
  void uploadBlocks(const AirBlocks& blocks);
  void uploadLight(const AirLight& light);
  void findPixels(const DrawContext& context, Vec3d toSun);
  void march(GLuint depth, const DrawContext& context);
  void smooth(const DrawContext& context);
  void blend(GLuint framebuffer, GLuint depth, const DrawContext& context);
  void drawSlice(const DrawContext& context) const;

  std::shared_ptr<const AirPart> m_air;
  double m_revision = 0.0;
  std::vector<double> m_key;  ///< what the textures were made for
  CpuBackend m_backend;
  AirOptics m_optics;
  AirBlocks m_blocks;     ///< without texels: these are on the card
  AirLight m_light;       ///< likewise
  Vec3d m_ambient{};      ///< colour that sky and ground give an open cloud
  AirSliceImage m_slice;  ///< likewise
  ValueScale m_scale;
  double m_valueExtinction = 0.0;
  bool m_values = false, m_sliced = false, m_drawn = false;
  std::array<int, 4> m_pixels{}, m_shownPixels{};  ///< of the cloud; with its shadow
  AirTargets m_targets;
  GlTexture m_index, m_density, m_lightTexture, m_throughTexture, m_sliceTexture, m_clear;
  std::array<int, 4> m_densitySize{};
  GlVertexArray m_vertexArray;
  GlProgram m_march, m_valueMarch, m_smooth, m_blend, m_sliceProgram;
};

}  // namespace spin
