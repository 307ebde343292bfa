// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "core/flake/flake_atlas.h"
#include "core/snow/flake_field.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// Draws falling flakes as sprites that play the frames of grown shapes, blurred along their motion. Where
/// they are is found anew for each picture (FlakeField); what each hides is what the precipitation says,
/// whatever the number that is drawn.
class FlakePass {
 public:
  Status initialise();
  /// Takes a frame's flakes; null = none.
  void setFlakes(std::shared_ptr<const FlakesPart> flakes) { m_flakes = std::move(flakes); }
  /// Takes the shapes; null = soft discs.
  void setAtlas(std::shared_ptr<const FlakeAtlas> atlas);
  /// `inCloud`: what hangs in the air hides them, as airKept() says.
  void draw(const DrawContext& context, bool inCloud);

 private:
  bool look(const DrawContext& context, const SnowfallNode& snowfall);
  void uploadSeen();
  void growIndices(std::size_t flakes);

  std::shared_ptr<const FlakesPart> m_flakes;
  std::shared_ptr<const FlakeAtlas> m_atlas;
  double m_atlasCover = 0.5;  ///< share of the circle round a flake that its pictures cover
  CpuBackend m_backend;
  std::unique_ptr<FlakeField> m_field;
  std::shared_ptr<const FallWind> m_wind;  ///< round land and models; null = none
  FlakeRecords m_seen;
  /// What was looked at last: a picture that is drawn in bands looks once.
  std::shared_ptr<const FlakesPart> m_looked;
  std::vector<FlakeGroup> m_groups;
  FlakeView m_view;
  std::size_t m_indexedFlakes = 0, m_room = 0;
  GlBuffer m_records, m_indices;
  GlTexture m_shapes;
  GlVertexArray m_vertexArray;
  GlProgram m_program, m_cloudProgram;
};

}  // namespace spin
