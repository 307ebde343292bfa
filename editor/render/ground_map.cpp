// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/ground_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nodes/ground_nodes.h"
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

Vec3d temperatureColour(double kelvin) {
  const double t = std::clamp((kelvin - 273.15) / 20.0, -1.0, 1.0);
  const Vec3d end = t < 0.0 ? Vec3d{0.02, 0.10, 0.55} : Vec3d{0.60, 0.03, 0.02};
  return Vec3d{0.85, 0.85, 0.85} * (1.0 - std::abs(t)) + end * std::abs(t);
}

/// What is shown, read per cell; types have a table.
struct GroundMap::Source {
  const TiledRaster<std::uint8_t>* types = nullptr;
  const TiledRaster<float>* temperatures = nullptr;
  double base = 0.0;  ///< type number or K where nothing is painted
  bool temperature = false;
  std::array<Texel, kGroundTypeCount> table{};

  Texel at(int i, int j) const {
    if (temperature) {
      const float painted = temperatures ? temperatures->at(i, j) : std::numeric_limits<float>::quiet_NaN();
      return texelOf(temperatureColour(std::isnan(painted) ? base : static_cast<double>(painted)), 0.0f);
    }
    const int painted = types ? types->at(i, j) : kUnpaintedGround;
    const int type = painted < kGroundTypeCount ? painted : static_cast<int>(base);
    return table[static_cast<std::size_t>(type)];
  }
  std::shared_ptr<const void> tile(int tileX, int tileY) const {
    if (temperature)
      return temperatures ? temperatures->tile(temperatures->tileIndex(tileX * kTile, tileY * kTile))
                          : nullptr;
    return types ? types->tile(types->tileIndex(tileX * kTile, tileY * kTile)) : nullptr;
  }
};

void GroundMap::update(const SceneSnapshot& scene, double filmTime, GroundDisplay display) {
  if (!scene.terrain) {
    m_texture.reset();
    m_tiles.clear();
    return;
  }
  Source source;
  source.temperature = display == GroundDisplay::GroundTemperature;
  const int width = scene.terrain->heights.width, height = scene.terrain->heights.height;
  const SceneNode* node =
      source.temperature ? scene.first<GroundTemperatureLayerNode>() : scene.first<GroundTypeLayerNode>();
  source.base = source.temperature ? scene.settings<GroundTemperatureLayerNode>(filmTime).base
                                   : static_cast<double>(scene.settings<GroundTypeLayerNode>(filmTime).base);
  const auto fits = [&](const auto* layer) {
    return layer && layer->width() == width && layer->height() == height;
  };
  if (node && source.temperature) source.temperatures = std::get_if<TiledRaster<float>>(&node->painted);
  if (node && !source.temperature) source.types = std::get_if<TiledRaster<std::uint8_t>>(&node->painted);
  if (!fits(source.temperatures)) source.temperatures = nullptr;
  if (!fits(source.types)) source.types = nullptr;
  // False colours are lightened: bare ground is too dark to tell types apart.
  const double lift = display == GroundDisplay::GroundType ? 0.5 : 1.0;
  for (int t = 0; t < kGroundTypeCount; ++t) {
    const auto type = static_cast<GroundType>(t);
    const Vec3d c = groundTypeColour(type);
    source.table[static_cast<std::size_t>(t)] =
        texelOf({std::pow(c.x, lift), std::pow(c.y, lift), std::pow(c.z, lift)}, roughnessOf(type));
  }
  const int tilesX = (width + kTile - 1) / kTile, tilesY = (height + kTile - 1) / kTile;
  bool all = display != m_display || source.base != m_base;
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
