// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "editor/render/cover_geometry.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"
#include "editor/render/model_pass.h"

namespace spin {

/// Draws the snow cover: depth of the coarse grid as a texture for the terrain, fine grids as meshes in its
/// place, patches on models blended over them.
class CoverPass {
 public:
  Status initialise();
  /// Takes a frame's cover; null = no snow. Meshes are made again only for a new layout.
  void setCover(std::shared_ptr<const CoverPart> cover, const SceneSnapshot* scene);
  bool hasSnow() const { return m_cover != nullptr && m_depth; }
  /// Mean share of the terrain that is white, 0..1.
  double snowShare() const { return m_snowShare; }
  /// Rectangles that fine grids draw instead of the terrain.
  std::vector<Vec4f> cuts() const;
  void bindTextures() const { glBindTextureUnit(6, m_depth.id()); }
  void drawFine(const DrawContext& context) const;
  void drawPatches(const DrawContext& context, const std::vector<PlacedModel>& placed) const;

 private:
  struct Fine {
    FineCover geometry;
    std::size_t grid = 0;
    GlBuffer positions, snow, indices;
    std::vector<std::array<std::size_t, FineCover::kStrides>> first;  ///< by block
  };
  struct Patches {
    std::string node;
    std::vector<std::pair<std::size_t, PatchCover>> parts;  ///< grid and mesh
    GlBuffer positions, snow, indices;
    std::size_t vertices = 0, count = 0;
    double reach = 0.0;  ///< m from the node's position
  };
  void makeMeshes(const SceneSnapshot& scene);
  void addFine(std::size_t grid);
  void addPatch(std::size_t grid);
  void uploadPatchMeshes(Patches& patches) const;
  void updateCoarse(const SceneSnapshot& scene);
  void updateFine();
  void updatePatches();

  std::shared_ptr<const CoverPart> m_cover;
  std::shared_ptr<const CoverLayout> m_layout;
  std::shared_ptr<const TerrainData> m_terrain;
  int m_coarse = -1;  ///< index of the grid that has the terrain's shape
  Raster<float> m_coarseDepth;
  GlTexture m_depth;
  std::vector<Fine> m_fine;
  std::vector<Patches> m_patches;
  double m_snowShare = 0.0;
  GlProgram m_fineProgram, m_patchProgram;
  GlVertexArray m_fineArray, m_patchArray;
};

}  // namespace spin
