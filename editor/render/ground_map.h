// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sim/snapshot.h"
#include "editor/render/gl_objects.h"
#include "editor/render/renderer.h"

namespace spin {

/// The ground's colour per terrain cell as a texture: type colours with their roughness in alpha, or false
/// colours of a painted layer (GroundScale). After a brush stroke only the tiles it touched are uploaded.
class GroundMap {
 public:
  /// `node` names the layer to show where there are several of a kind.
  void update(const SceneSnapshot& scene, double filmTime, GroundDisplay display,
              const std::string& node = {});
  /// 0 until there is a terrain.
  GLuint texture() const { return m_texture.id(); }
  /// Tiles written by the last update that wrote any; for tests.
  std::size_t uploadedTiles() const { return m_uploaded; }

 private:
  struct Source;
  Source sourceOf(const SceneSnapshot& scene, double filmTime, GroundDisplay display) const;
  void uploadTile(const Source& source, int tileX, int tileY);

  GlTexture m_texture;
  int m_width = 0, m_height = 0;
  std::vector<std::shared_ptr<const void>> m_tiles;  ///< what is on the card, held so that addresses stay
  GroundDisplay m_display = GroundDisplay::Natural;
  std::string m_node;
  double m_base = -1.0;
  std::size_t m_uploaded = 0;
};

}  // namespace spin
