// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/ground_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/nodes/ground_nodes.h"
#include "core/nodes/painted_kinds.h"
#include "editor/render/ground_scale.h"
#include "editor/render/texel_code.h"

namespace spin {
namespace {

using Texel = std::array<std::uint8_t, 4>;
constexpr int kTile = TiledRaster<float>::kTile;

/// How far stems or stones of a ground type stand out, m; thin snow sinks between them.
float roughnessOf(GroundType type) {
  static constexpr std::array<float, kGroundTypeCount> kRoughness{0.020f, 0.010f, 0.025f, 0.070f,
                                                                  0.040f, 0.004f, 0.005f, 0.004f};
  return kRoughness[static_cast<std::size_t>(type)];
}

Texel texelOf(Vec3d colour, float roughness) {
  return {encodeRoot(colour.x), encodeRoot(colour.y), encodeRoot(colour.z),
          static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(roughness / 0.1f, 0.0f, 1.0f)))};
}

}  // namespace

/// What is shown, read per cell.
struct GroundMap::Source {
  const TiledRaster<std::uint8_t>* numbers = nullptr;
  const TiledRaster<float>* reals = nullptr;
  const GroundScale* scale = nullptr;  ///< of measures
  double base = 0.0;                   ///< what holds where nothing is painted; NaN = nothing
  std::array<Texel, kGroundTypeCount> table{};

  Texel at(int i, int j) const {
    if (!scale) {
      const int painted = numbers ? numbers->at(i, j) : kUnpaintedGround;
      return table[static_cast<std::size_t>(painted < kGroundTypeCount ? painted : static_cast<int>(base))];
    }
    const float painted = reals ? reals->at(i, j) : std::numeric_limits<float>::quiet_NaN();
    const double value = std::isnan(painted) ? base : static_cast<double>(painted);
    return texelOf(std::isnan(value) ? scale->unpainted : scale->colour(value), 0.0f);
  }
  std::shared_ptr<const void> tile(int tileX, int tileY) const {
    const auto of = [&](const auto& layer) -> std::shared_ptr<const void> {
      return layer.tile(layer.tileIndex(tileX * kTile, tileY * kTile));
    };
    if (numbers) return of(*numbers);
    return reals ? of(*reals) : nullptr;
  }
};

GroundMap::Source GroundMap::sourceOf(const SceneSnapshot& scene, double filmTime,
                                      GroundDisplay display) const {
  Source source;
  const bool types = display == GroundDisplay::Natural || display == GroundDisplay::GroundType;
  const NodeType& type = types ? kGroundTypeLayerType : *groundScale(display)->kind->type;
  if (!types) source.scale = groundScale(display);
  source.base = std::numeric_limits<double>::quiet_NaN();
  if (types) source.base = static_cast<double>(scene.settings<GroundTypeLayerNode>(filmTime).base);
  if (display == GroundDisplay::GroundTemperature)
    source.base = scene.settings<GroundTemperatureLayerNode>(filmTime).base;
  const auto fits = [&](const auto* layer) {
    const Raster<float>& heights = scene.terrain->heights;
    return layer && layer->width() == heights.width && layer->height() == heights.height;
  };
  for (const SceneNode& node : scene.nodes) {
    const auto* numbers = std::get_if<TiledRaster<std::uint8_t>>(&node.painted);
    const auto* reals = std::get_if<TiledRaster<float>>(&node.painted);
    if (!node.enabled || node.type != &type || !(fits(numbers) || fits(reals))) continue;
    // Of several nodes of a type the wanted one is shown, else the first.
    const bool wanted = node.id == m_node || !(source.numbers || source.reals);
    if (wanted) source.numbers = numbers, source.reals = reals;
  }
  for (int t = 0; t < kGroundTypeCount; ++t) {
    const auto ground = static_cast<GroundType>(t);
    const Vec3d c = display == GroundDisplay::GroundType ? falseTypeColour(t) : groundTypeColour(ground);
    source.table[static_cast<std::size_t>(t)] = texelOf(c, roughnessOf(ground));
  }
  return source;
}

void GroundMap::update(const SceneSnapshot& scene, double filmTime, GroundDisplay display,
                       const std::string& node) {
  if (!scene.terrain) {
    m_texture.reset();
    m_tiles.clear();
    return;
  }
  m_node = node;
  const Source source = sourceOf(scene, filmTime, display);
  const int width = scene.terrain->heights.width, height = scene.terrain->heights.height;
  const int tilesX = (width + kTile - 1) / kTile, tilesY = (height + kTile - 1) / kTile;
  // Two NaN are the same base.
  const bool sameBase = source.base == m_base || (std::isnan(source.base) && std::isnan(m_base));
  bool all = display != m_display || !sameBase;
  if (!m_texture || width != m_width || height != m_height) {
    m_texture = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(m_texture.id(), 1, GL_RGBA8, width, height);
    setSampling(m_texture, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
    all = true;
  }
  m_width = width;
  m_height = height;
  m_display = display;
  m_base = source.base;
  m_tiles.resize(static_cast<std::size_t>(tilesX) * static_cast<std::size_t>(tilesY));
  std::size_t uploaded = 0;
  for (int ty = 0; ty < tilesY; ++ty)
    for (int tx = 0; tx < tilesX; ++tx) {
      auto& known = m_tiles[static_cast<std::size_t>(ty * tilesX + tx)];
      auto tile = source.tile(tx, ty);
      if (!all && tile == known) continue;
      known = std::move(tile);
      uploadTile(source, tx, ty);
      ++uploaded;
    }
  if (uploaded > 0) m_uploaded = uploaded;
}

void GroundMap::uploadTile(const Source& source, int tileX, int tileY) {
  const int i0 = tileX * kTile, j0 = tileY * kTile;
  const int w = std::min(kTile, m_width - i0), h = std::min(kTile, m_height - j0);
  std::vector<Texel> texels;
  texels.reserve(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  for (int j = j0; j < j0 + h; ++j)
    for (int i = i0; i < i0 + w; ++i) texels.push_back(source.at(i, j));
  glTextureSubImage2D(m_texture.id(), 0, i0, j0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

}  // namespace spin
