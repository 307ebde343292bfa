// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "editor/render/flow_pass.h"
#include "editor/render/model_pass.h"

namespace spin {

/// Depth maps of the models near the camera as the sun and the zenith see them; the sun's shows the flow too.
/// Drawn again only when the light, a model, the flow or the covered place changes.
class ShadowPass {
 public:
  static constexpr int kSunTexels = 1024;
  static constexpr int kZenithTexels = 512;

  Status initialise();
  /// Draws the maps where needed and fills the block's matrices. Changes framebuffer and viewport.
  void update(const ModelPass& models, const std::vector<PlacedModel>& placed, const FlowPass& flow,
              const RenderCamera& camera, Vec3d toSun, FrameBlock& block);
  void bindTextures() const;
  std::size_t timesDrawn() const { return m_timesDrawn; }

 private:
  struct Map {
    GlTexture depth;
    GlFramebuffer framebuffer;
    int texels = 0;
    std::vector<double> key;  ///< matrix and placements it was drawn with
  };
  void drawMap(Map& map, const Matrix4& light, double halfSize, const ModelPass& models,
               const std::vector<PlacedModel>& placed, const FlowPass* flow);

  Map m_sun, m_zenith;
  std::size_t m_timesDrawn = 0;
};

}  // namespace spin
