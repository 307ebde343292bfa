// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/render/cover_geometry.h"
#include "editor/render/cover_values.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"
#include "editor/render/model_pass.h"

namespace spin {

/// What the colours of the cover follow besides its depth; nothing of it changes with the camera.
struct CoverLook {
  SnowLook look = SnowLook::Physical;
  RenderNode settings;
  SlopeHold hold;  ///< of the published blend

  bool sameAs(const CoverLook& other) const;
};
CoverLook coverLookOf(const SceneSnapshot& scene, double filmTime);

/// Draws the snow cover: depth of the coarse grid as a texture for the terrain, fine grids as meshes in its
/// place, patches on models blended over them. Near by a patch is raised geometry; with distance it
/// sinks to the model's surface, where it is a colour blended over the model's.
class CoverPass {
 public:
  Status initialise();
  /// Takes a frame's cover and its film time; null = no snow. Meshes are made again only for a new layout.
  void setCover(std::shared_ptr<const CoverPart> cover, const SceneSnapshot* scene, double filmTime);
  /// Brings the cells' colours up to date, where the look has any.
  void setLook(const CoverLook& look);
  bool hasSnow() const { return m_cover != nullptr && m_depth; }
  /// Mean share of the terrain that is white, 0..1.
  double snowShare() const { return m_snowShare; }
  /// Rectangles that fine grids draw instead of the terrain.
  std::vector<Vec4f> cuts() const;
  void bindTextures() const;
  void drawFine(const DrawContext& context) const;
  void drawPatches(const DrawContext& context, const std::vector<PlacedModel>& placed) const;

 private:
  struct Fine {
    FineCover geometry;
    std::size_t grid = 0;
    GlBuffer positions, snow, looks, indices;
    std::vector<std::array<std::size_t, FineCover::kStrides>> first;  ///< by block
  };
  /// A grid on a model: its mesh, and what of the node's indices draws it.
  struct PatchPart {
    std::size_t grid = 0;
    PatchCover mesh;
    std::vector<RimContact> contacts;
    std::vector<Vec4f> drawn;  ///< patchCoverSnow()
    Box3d bounds;              ///< relative to the node's position, bare
    std::size_t first = 0, count = 0;
  };
  struct Patches {
    std::string node;
    std::vector<PatchPart> parts;
    GlBuffer positions, snow, looks, indices;
    std::size_t vertices = 0, count = 0;
    double cellSize = 0.0;  ///< m, of the coarsest
  };
  void makeMeshes(const SceneSnapshot& scene);
  void addFine(std::size_t grid);
  void addPatch(std::size_t grid);
  void uploadPatchMeshes(Patches& patches) const;
  void updateCoarse(const SceneSnapshot& scene);
  void updateFine();
  std::vector<float> snowBeside(const PatchPart& part, Vec3d offset) const;
  void updatePatches(const SceneSnapshot& scene, double filmTime);
  void updateIndices();
  void updateLooks();
  /// Height of the drawn snow surface of the terrain, local m; nothing beside it.
  std::optional<double> snowSurfaceAt(double x, double y) const;

  std::shared_ptr<const CoverPart> m_cover;
  std::shared_ptr<const CoverLayout> m_layout;
  std::shared_ptr<const TerrainData> m_terrain;
  int m_coarse = -1;  ///< index of the grid that has the terrain's shape
  Raster<float> m_coarseDepth;
  GlTexture m_depth, m_looks;
  CoverLook m_look;
  bool m_looksStale = true, m_indicesStale = true;
  bool m_bareDrawn = false;  ///< bare cells of patches, too
  std::vector<Fine> m_fine;
  std::vector<Patches> m_patches;
  double m_snowShare = 0.0;
  LookPrograms m_finePrograms, m_patchPrograms;
  GlVertexArray m_fineArray, m_patchArray;
};

}  // namespace spin
