// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/model_pass.h"

#include <algorithm>

#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

constexpr GLsizei kVertexBytes = 8 * sizeof(float);

Matrix4 multiply(const Matrix4& a, const Matrix4& b) {
  Matrix4 m{};
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t r = 0; r < 4; ++r)
      for (std::size_t k = 0; k < 4; ++k) m[c * 4 + r] += a[k * 4 + r] * b[c * 4 + k];
  return m;
}

Matrix4 normalMatrix(const Transform& t) {
  Matrix4 m{};
  for (std::size_t c = 0; c < 3; ++c) {
    const Vec3d column = t.normal({c == 0 ? 1.0 : 0.0, c == 1 ? 1.0 : 0.0, c == 2 ? 1.0 : 0.0});
    for (int r = 0; r < 3; ++r) m[c * 4 + static_cast<std::size_t>(r)] = static_cast<float>(column[r]);
  }
  m[15] = 1.0f;
  return m;
}

const Material& materialOf(const ModelData& data, int index) {
  static const Material kPlain;
  return index >= 0 && static_cast<std::size_t>(index) < data.materials.size()
             ? data.materials[static_cast<std::size_t>(index)]
             : kPlain;
}

/// Binds the material's texture; 0 if it has none.
GLuint bindTexture(const GpuModel& model, const Material& material) {
  const auto index = static_cast<std::size_t>(material.texture);
  const GLuint id = material.texture >= 0 && index < model.textures.size() ? model.textures[index].id() : 0;
  glBindTextureUnit(7, id);
  return id;
}

}  // namespace

Box3d transformed(const Transform& transform, const Box3d& box) {
  Box3d out;
  if (box.empty()) return out;
  for (int k = 0; k < 8; ++k)
    out.extend(transform.point(
        {(k & 1) ? box.max.x : box.min.x, (k & 2) ? box.max.y : box.min.y, (k & 4) ? box.max.z : box.min.z}));
  return out;
}

Status ModelPass::initialise() {
  for (std::size_t k = 0; k < m_solidPrograms.size(); ++k) {
    const std::string defines = definesOf(static_cast<SnowLook>(k));
    auto solid = GlProgram::build("model.vert", "model.frag", defines);
    if (!solid) return solid.error();
    auto cutout = GlProgram::build("model.vert", "model.frag", defines + "#define CUTOUT 1");
    if (!cutout) return cutout.error();
    m_solidPrograms[k] = std::move(*solid);
    m_cutoutPrograms[k] = std::move(*cutout);
  }
  auto depth = GlProgram::build("depth.vert", "depth.frag");
  if (!depth) return depth.error();
  m_depthProgram = std::move(*depth);
  m_vertexArray = GlVertexArray::make();
  const GLuint id = m_vertexArray.id();
  const GLint components[3] = {3, 3, 2};
  GLuint offset = 0;
  for (GLuint a = 0; a < 3; ++a) {
    glEnableVertexArrayAttrib(id, a);
    glVertexArrayAttribFormat(id, a, components[a], GL_FLOAT, GL_FALSE, offset);
    glVertexArrayAttribBinding(id, a, 0);
    offset += static_cast<GLuint>(components[a]) * sizeof(float);
  }
  return {};
}

void ModelPass::setScene(const SceneSnapshot& scene) {
  std::map<const ModelData*, GpuModel> kept;
  for (const auto& [id, data] : scene.models) {
    if (!data || kept.count(data.get()) > 0) continue;
    const auto known = m_models.find(data.get());
    kept.emplace(data.get(), known != m_models.end() ? std::move(known->second) : GpuModel::upload(data));
  }
  m_models = std::move(kept);
}

std::vector<PlacedModel> ModelPass::place(const SceneSnapshot& scene, double filmTime,
                                          const BodiesPart* bodies) const {
  std::vector<PlacedModel> placed;
  for (const SceneNode* node : scene.all<ModelNode>()) {
    const auto data = scene.models.find(node->id);
    if (data == scene.models.end() || !data->second) continue;
    const GpuModel& model = m_models.at(data->second.get());
    const auto* body = bodies ? bodies->find(node->id) : nullptr;
    const Transform transform = body ? body->placement : scene.modelTransform(*node, filmTime);
    const auto dusting =
        static_cast<float>(static_cast<const ModelNode&>(*evaluate(*node, filmTime)).dusting);
    placed.push_back({&model, node, transform, transformed(transform, model.bounds), dusting});
  }
  return placed;
}

/// Calls begin(transform, material, hasTexture) before each part is drawn that shows(bounds) is true for.
template <class Shows, class Begin>
void ModelPass::forParts(const PlacedModel& placed, const Shows& shows, const Begin& begin) const {
  const GpuModel& model = *placed.model;
  glVertexArrayVertexBuffer(m_vertexArray.id(), 0, model.vertices.id(), 0, kVertexBytes);
  glVertexArrayElementBuffer(m_vertexArray.id(), model.indices.id());
  for (const MeshInstance& instance : model.data->instances) {
    const GpuModel::Part& part = model.parts[static_cast<std::size_t>(instance.mesh)];
    const Transform place = placed.transform * instance.transform;
    if (part.count == 0 || !shows(transformed(place, part.bounds))) continue;
    const Material& material = materialOf(*model.data, part.material);
    begin(place, material, bindTexture(model, material) != 0);
    glDrawElements(GL_TRIANGLES, part.count, GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(part.firstIndex * sizeof(std::uint32_t)));
  }
}

void ModelPass::draw(const DrawContext& context, const std::vector<PlacedModel>& placed) const {
  glBindVertexArray(m_vertexArray.id());
  // Colours of values need no variant: no snow is drawn on what carries none.
  const std::size_t variant = context.look == SnowLook::Published ? 1 : 0;
  // Near models first, so that they hide far ones before those are shaded.
  std::vector<std::pair<double, const PlacedModel*>> seen;
  for (const PlacedModel& one : placed)
    if (context.frustum.mayShow(one.bounds))
      seen.emplace_back(distanceTo(one.bounds, context.camera.position), &one);
  std::stable_sort(seen.begin(), seen.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance, one] : seen) {
    const bool selected =
        !context.options.selectedNode.empty() && one->node->id == context.options.selectedNode;
    const auto inView = [&](const Box3d& bounds) { return context.frustum.mayShow(bounds); };
    forParts(*one, inView, [&](const Transform& t, const Material& m, bool textured) {
      const bool cutout = textured && m.alphaCutout;
      const GlProgram& program = (cutout ? m_cutoutPrograms : m_solidPrograms)[variant];
      program.use();
      program.set("uHighlight", 1.0f, 0.45f, 0.05f, selected ? 0.35f : 0.0f);
      program.setMatrix("uModel", t.toColumnMajor());
      program.setMatrix("uNormalMatrix", normalMatrix(t));
      program.set("uBaseColour", m.baseColour.x, m.baseColour.y, m.baseColour.z, m.baseColour.w);
      program.set("uSurface", textured ? 1.0f : 0.0f, m.doubleSided ? 1.0f : 0.0f, m.roughness, one->dusting);
    });
  }
}

void ModelPass::drawDepth(const Matrix4& light, const std::vector<PlacedModel>& placed) const {
  m_depthProgram.use();
  glBindVertexArray(m_vertexArray.id());
  for (const PlacedModel& one : placed)
    forParts(
        one, [](const Box3d&) { return true; },
        [&](const Transform& t, const Material& m, bool textured) {
          m_depthProgram.setMatrix("uLightModel", multiply(light, t.toColumnMajor()));
          m_depthProgram.set("uCutout", textured && m.alphaCutout ? 1.0f : 0.0f);
        });
}

}  // namespace spin
