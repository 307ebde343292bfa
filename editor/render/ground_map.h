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
/// colours of type or temperature. After a brush stroke only the tiles it touched are uploaded.
class GroundMap {
 public:
  void update(const SceneSnapshot& scene, double filmTime, GroundDisplay display);
  /// 0 until there is a terrain.
  GLuint texture() const { return m_texture.id(); }
  /// Tiles written by the last update that wrote any; for tests.
  std::size_t uploadedTiles() const { return m_uploaded; }

 private:
  struct Source;
  void uploadTile(const Source& source, int tileX, int tileY);

  GlTexture m_texture;
  int m_width = 0, m_height = 0;
  std::vector<std::shared_ptr<const void>> m_tiles;  ///< what is on the card, held so that addresses stay
  GroundDisplay m_display = GroundDisplay::Natural;
  double m_base = -1.0;
  std::size_t m_uploaded = 0;
};

/// Colour ramp for temperatures in K, linear RGB: blue at 253 K over white at 273 K to red at 293 K.
Vec3d temperatureColour(double kelvin);

}  // namespace spin
