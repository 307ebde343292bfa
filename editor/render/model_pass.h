// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/fields/mesh.h"
#include "core/sim/bodies_part.h"
#include "editor/render/draw_context.h"
#include "editor/render/gl_program.h"

namespace spin {

/// A model on the graphics card: one buffer of vertices, parts by mesh.
struct GpuModel {
  struct Part {
    std::size_t firstIndex = 0;
    GLsizei count = 0;
    int material = 0;
    Box3d bounds;  ///< of the mesh
  };
  std::shared_ptr<const ModelData> data;
  GlBuffer vertices, indices;
  std::vector<Part> parts;  ///< by mesh
  std::vector<GlTexture> textures;
  Box3d bounds;

  /// Parts whose indices leave the mesh are left empty.
  static GpuModel upload(std::shared_ptr<const ModelData> model);
};

/// One model node as it stands at the drawn time.
struct PlacedModel {
  const GpuModel* model = nullptr;
  const SceneNode* node = nullptr;
  Transform transform;
  Box3d bounds;  ///< local metres
  float dusting = 0.0f;
};

/// Keeps models on the card and draws them.
class ModelPass {
 public:
  Status initialise();
  /// Uploads models that are new and drops those that are gone.
  void setScene(const SceneSnapshot& scene);
  /// Where all enabled models stand; valid until the next setScene.
  /// Models that `bodies` names stand where it says; null = none.
  std::vector<PlacedModel> place(const SceneSnapshot& scene, double filmTime, const BodiesPart* bodies) const;
  void draw(const DrawContext& context, const std::vector<PlacedModel>& placed) const;
  /// Depth only, for a shadow map: `light` is its matrix.
  void drawDepth(const Matrix4& light, const std::vector<PlacedModel>& placed) const;
  std::size_t modelsHeld() const { return m_models.size(); }

 private:
  template <class Shows, class Begin>
  void forParts(const PlacedModel& placed, const Shows& shows, const Begin& begin) const;

  std::map<const ModelData*, GpuModel> m_models;
  std::array<GlProgram, 2> m_solidPrograms, m_cutoutPrograms;  ///< physical and published snow
  GlProgram m_depthProgram;
  GlVertexArray m_vertexArray;
};

/// Axis-aligned box round a transformed box.
Box3d transformed(const Transform& transform, const Box3d& box);

}  // namespace spin
