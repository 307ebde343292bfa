// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/terrain_pass.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "editor/render/terrain_light.h"

namespace spin {
namespace {

/// Largest size on screen of a quad's side, px. Shading comes from full-resolution maps, so only outlines
/// depend on it.
constexpr double kQuadPixels = 12.0;
constexpr std::size_t kMostCuts = 16;
/// Tiles nearer than this, m, show the grain of the ground and the shadows of models.
constexpr double kNearShading = 60.0;

bool overlaps(const Box3d& box, const Vec4f& r) {
  return box.min.x < static_cast<double>(r.z) && box.max.x > static_cast<double>(r.x) &&
         box.min.y < static_cast<double>(r.w) && box.max.y > static_cast<double>(r.y);
}

/// Whether what fills a box may throw a shadow on ground in another, up to three of its heights away.
bool shadedBy(const Box3d& ground, const Box3d& caster) {
  if (caster.empty()) return false;
  const double reach = 3.0 * std::min(caster.size().z, 20.0);
  return ground.min.x < caster.max.x + reach && ground.max.x > caster.min.x - reach &&
         ground.min.y < caster.max.y + reach && ground.max.y > caster.min.y - reach;
}

}  // namespace

int terrainLevel(double distance, double cellSize, double pixelsPerUnit, double pixels) {
  const double stride = pixels * distance / (cellSize * pixelsPerUnit);
  return stride <= 1.0 ? 0 : std::min(kTerrainLevels - 1, static_cast<int>(std::log2(stride)));
}

Status TerrainPass::initialise() {
  const std::string published = definesOf(SnowLook::Published);
  const std::pair<GlProgram*, std::string> variants[] = {
      {&m_farProgram, ""},
      {&m_nearProgram, "#define NEAR 1"},
      {&m_publishedFarProgram, published},
      {&m_publishedNearProgram, published + "#define NEAR 1"},
      {&m_valuesProgram, definesOf(SnowLook::Values)},
      {&m_falseProgram, "#define FALSE_COLOURS 1"}};
  for (const auto& [program, defines] : variants) {
    auto built = GlProgram::build("terrain.vert", "terrain.frag", defines);
    if (!built) return built.error();
    *program = std::move(*built);
  }
  m_vertexArray = GlVertexArray::make();
  glEnableVertexArrayAttrib(m_vertexArray.id(), 0);
  glVertexArrayAttribFormat(m_vertexArray.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(m_vertexArray.id(), 0, 0);
  return {};
}

void TerrainPass::setTerrain(std::shared_ptr<const TerrainData> terrain) {
  if (terrain == m_terrain) return;
  m_terrain = std::move(terrain);
  m_tiles.clear();
  m_light.reset();
  m_toSun = {};
  m_shadowHeights.clear();
  m_shadowRevision += 1.0;
  if (!m_terrain || m_terrain->heights.width < 2 || m_terrain->heights.height < 2) {
    m_terrain.reset();
    return;
  }
  makeTiles();
  const Raster<float>& h = m_terrain->heights;
  m_normalsAndSky = terrainNormalsAndSky(h);
  m_light = GlTexture::make(GLenum{GL_TEXTURE_2D});
  const int levels = 1 + static_cast<int>(std::log2(std::max(h.width, h.height)));
  glTextureStorage2D(m_light.id(), std::min(levels, 4), GL_RGBA8, h.width, h.height);
  setSampling(m_light, GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_CLAMP_TO_EDGE);
}

void TerrainPass::makeTiles() {
  const Raster<float>& h = m_terrain->heights;
  const TileCount count = terrainTiles(h);
  for (int y = 0; y < count.y; ++y)
    for (int x = 0; x < count.x; ++x) {
      Tile tile;
      tile.x = x;
      tile.y = y;
      for (int j = y * kTileQuads; j <= std::min((y + 1) * kTileQuads, h.height - 1); ++j)
        for (int i = x * kTileQuads; i <= std::min((x + 1) * kTileQuads, h.width - 1); ++i)
          if (const float z = h.at(i, j); !std::isnan(z))
            tile.bounds.extend(Vec3d{h.x(i), h.y(j), static_cast<double>(z)});
      if (!tile.bounds.empty()) m_tiles.push_back(std::move(tile));
    }
}

void TerrainPass::update(const SceneSnapshot& scene, double filmTime, GroundDisplay display,
                         const std::string& layer, Vec3d toSun) {
  m_ground.update(scene, filmTime, display, layer);
  if (!m_terrain || toSun == m_toSun) return;
  m_toSun = toSun;
  const Raster<float>& h = m_terrain->heights;
  const double climb = h.cellSize * std::max(toSun.z, 0.0) / std::max(std::hypot(toSun.x, toSun.y), 1e-3);
  m_shadowHeights = terrainShadowHeights(h, toSun);
  m_shadowEdge = std::max(0.5 * climb, 0.01);
  m_shadowRevision += 1.0;
  const std::vector<std::uint8_t> light =
      packTerrainLight(h, m_normalsAndSky, m_shadowHeights, static_cast<float>(m_shadowEdge));
  glTextureSubImage2D(m_light.id(), 0, 0, 0, h.width, h.height, GL_RGBA, GL_UNSIGNED_BYTE, light.data());
  glGenerateTextureMipmap(m_light.id());
}

double TerrainPass::sunShare(Vec3d place) const {
  if (!m_terrain || m_shadowHeights.empty()) return 1.0;
  const Raster<float>& h = m_terrain->heights;
  const double x = (place.x - h.originX) / h.cellSize, y = (place.y - h.originY) / h.cellSize;
  if (!(x >= 0.0 && y >= 0.0 && x <= h.width - 1 && y <= h.height - 1)) return 1.0;
  const int i = std::min(static_cast<int>(x), h.width - 2), j = std::min(static_cast<int>(y), h.height - 2);
  if (i < 0 || j < 0) return 1.0;
  const double u = x - i, v = y - j;
  const auto lit = [&](int a, int b) {
    const double above = place.z - static_cast<double>(m_shadowHeights[h.index(i + a, j + b)]);
    return std::clamp(above / m_shadowEdge, 0.0, 1.0);
  };
  return (1.0 - v) * ((1.0 - u) * lit(0, 0) + u * lit(1, 0)) + v * ((1.0 - u) * lit(0, 1) + u * lit(1, 1));
}

void TerrainPass::bindTextures() const {
  glBindTextureUnit(3, m_light.id());
  glBindTextureUnit(5, m_ground.texture());
}

void TerrainPass::fill(FrameBlock& block) const {
  if (!m_terrain) return;
  const Raster<float>& h = m_terrain->heights;
  block.terrainGrid = {static_cast<float>(h.originX), static_cast<float>(h.originY),
                       static_cast<float>(1.0 / h.cellSize), 1.0f};
  block.terrainSize.x = static_cast<float>(h.width);
  block.terrainSize.y = static_cast<float>(h.height);
}

const TerrainPass::LevelMesh& TerrainPass::meshOf(Tile& tile, int level) const {
  LevelMesh& mesh = tile.levels[static_cast<std::size_t>(level)];
  if (mesh.made) return mesh;
  mesh.made = true;
  const TerrainTileMesh data = buildTerrainTile(m_terrain->heights, tile.x, tile.y, level);
  mesh.count = static_cast<GLsizei>(data.indices.size());
  if (mesh.count == 0) return mesh;
  mesh.vertices = GlBuffer::make();
  mesh.indices = GlBuffer::make();
  glNamedBufferStorage(mesh.vertices.id(), static_cast<GLsizeiptr>(data.vertices.size() * sizeof(Vec3f)),
                       data.vertices.data(), 0);
  glNamedBufferStorage(mesh.indices.id(),
                       static_cast<GLsizeiptr>(data.indices.size() * sizeof(std::uint32_t)),
                       data.indices.data(), 0);
  return mesh;
}

void TerrainPass::drawTile(const LevelMesh& mesh) const {
  glVertexArrayVertexBuffer(m_vertexArray.id(), 0, mesh.vertices.id(), 0, sizeof(Vec3f));
  glVertexArrayElementBuffer(m_vertexArray.id(), mesh.indices.id());
  glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
}

const GlProgram& TerrainPass::programFor(SnowLook look, bool near) const {
  switch (look) {
    case SnowLook::Values:
      return m_valuesProgram;
    case SnowLook::Published:
      return near ? m_publishedNearProgram : m_publishedFarProgram;
    case SnowLook::Physical:
      break;
  }
  return near ? m_nearProgram : m_farProgram;
}

void TerrainPass::draw(const DrawContext& context, const std::vector<Vec4f>& cuts, const Box3d& shading) {
  m_triangles = 0;
  if (!m_terrain) return;
  glBindVertexArray(m_vertexArray.id());
  // Near tiles first, so that they hide far ones before those are shaded.
  std::vector<std::pair<double, Tile*>> seen;
  for (Tile& tile : m_tiles)
    if (context.frustum.mayShow(tile.bounds))
      seen.emplace_back(distanceTo(tile.bounds, context.camera.position), &tile);
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  const double pixels = kQuadPixels / std::clamp(context.options.quality, 0.1, 4.0);
  const int coarsest = coarsestTerrainLevel(m_terrain->heights);
  for (const auto& [distance, tile] : seen) {
    const int level = std::min(
        coarsest, terrainLevel(distance, m_terrain->heights.cellSize, context.pixelsPerUnit, pixels));
    const LevelMesh& mesh = meshOf(*tile, level);
    if (mesh.count == 0) continue;
    std::vector<Vec4f> here;
    for (const Vec4f& cut : cuts)
      if (overlaps(tile->bounds, cut) && here.size() < kMostCuts) here.push_back(cut);
    const bool natural = context.options.ground == GroundDisplay::Natural;
    const bool near = distance < kNearShading || !here.empty() || shadedBy(tile->bounds, shading);
    const GlProgram& program = !natural ? m_falseProgram : programFor(context.look, near);
    program.use();
    if (natural && (near || context.look == SnowLook::Values)) {
      if (!here.empty()) program.setArray("uCuts", &here.front().x, static_cast<int>(here.size()));
      program.set("uCutCount", static_cast<int>(here.size()));
    }
    drawTile(mesh);
    m_triangles += static_cast<std::size_t>(mesh.count / 3);
  }
}

}  // namespace spin
