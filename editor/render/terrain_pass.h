// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"
#include "editor/render/ground_map.h"
#include "editor/render/terrain_mesh.h"

namespace spin {

/// Draws the terrain by tiles, each at the level of detail that its distance asks for. Tile meshes are made
/// when they are first seen.
class TerrainPass {
 public:
  Status initialise();
  /// Uploads the light map of a new terrain; nothing if it is the one already held.
  void setTerrain(std::shared_ptr<const TerrainData> terrain);
  /// Brings ground colours and the terrain's shadow up to date.
  void update(const SceneSnapshot& scene, double filmTime, GroundDisplay display, const std::string& layer,
              Vec3d toSun);
  /// Binds what every pass that lights something reads: light map and ground colours.
  void bindTextures() const;
  /// `cuts`: rectangles x0, y0, x1, y1 that fine grids draw instead. `shading`: what throws shadows on the
  /// ground however far it is; may be empty.
  void draw(const DrawContext& context, const std::vector<Vec4f>& cuts, const Box3d& shading);
  void fill(FrameBlock& block) const;
  /// Share of the sun that the terrain lets through to a place at any height; as of the last update().
  double sunShare(Vec3d place) const;
  /// Another number after every update() that changed sunShare().
  double shadowRevision() const { return m_shadowRevision; }
  bool empty() const { return !m_terrain; }
  std::size_t trianglesDrawn() const { return m_triangles; }
  const GroundMap& ground() const { return m_ground; }

 private:
  struct LevelMesh {
    GlBuffer vertices, indices;
    GLsizei count = 0;
    bool made = false;
  };
  struct Tile {
    int x = 0, y = 0;
    Box3d bounds;
    std::array<LevelMesh, kTerrainLevels> levels;
  };
  void makeTiles();
  const LevelMesh& meshOf(Tile& tile, int level) const;
  void drawTile(const LevelMesh& mesh) const;
  const GlProgram& programFor(SnowLook look, bool near) const;

  std::shared_ptr<const TerrainData> m_terrain;
  std::vector<Tile> m_tiles;
  GlProgram m_farProgram, m_nearProgram, m_publishedFarProgram, m_publishedNearProgram, m_valuesProgram,
      m_falseProgram;
  GlVertexArray m_vertexArray;
  GlTexture m_light;
  std::vector<Vec4f> m_normalsAndSky;
  std::vector<float> m_shadowHeights;
  double m_shadowEdge = 0.01, m_shadowRevision = 0.0;
  GroundMap m_ground;
  Vec3d m_toSun{};
  std::size_t m_triangles = 0;
};

/// Level of detail for a tile: each quad's side covers at most about `pixels` on screen.
int terrainLevel(double distance, double cellSize, double pixelsPerUnit, double pixels);

}  // namespace spin
