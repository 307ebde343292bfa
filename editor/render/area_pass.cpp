// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/area_pass.h"

#include <algorithm>
#include <cmath>

#include "core/nodes/flow_nodes.h"

namespace spin {
namespace {

void markOutline(const Raster<float>& h, const std::vector<Vec2d>& outline, std::vector<std::uint8_t>& mask) {
  Box3d box;
  for (const Vec2d& corner : outline) box.extend(Vec3d{corner.x, corner.y, 0.0});
  if (outline.size() < 3) return;
  const auto cell = [&](double v, double origin, int most) {
    return static_cast<int>(std::clamp(std::floor((v - origin) / h.cellSize), 0.0, 1.0 * most));
  };
  const int i0 = cell(box.min.x, h.originX, h.width - 1), i1 = cell(box.max.x, h.originX, h.width - 2) + 1;
  const int j0 = cell(box.min.y, h.originY, h.height - 1), j1 = cell(box.max.y, h.originY, h.height - 2) + 1;
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i)
      if (withinOutline(outline, {h.x(i), h.y(j)})) mask[h.index(i, j)] = 1;
}

struct Vertex {
  Vec3f position;
  float share;
};

}  // namespace

bool withinOutline(const std::vector<Vec2d>& outline, Vec2d p) {
  bool inside = false;
  if (outline.size() < 3) return false;
  for (std::size_t k = 0, before = outline.size() - 1; k < outline.size(); before = k++) {
    const Vec2d a = outline[k], b = outline[before];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

std::vector<std::uint8_t> releaseMask(const SceneSnapshot& scene, const SceneNode& node) {
  const auto* release = node.as<AvalancheReleaseNode>();
  if (!release || !scene.terrain || scene.terrain->heights.empty()) return {};
  const Raster<float>& h = scene.terrain->heights;
  std::vector<std::uint8_t> mask(h.size(), 0);
  markOutline(h, release->outline, mask);
  const auto* painted = std::get_if<TiledRaster<std::uint8_t>>(&node.painted);
  if (painted && painted->width() == h.width && painted->height() == h.height)
    for (int j = 0; j < h.height; ++j)
      for (int i = 0; i < h.width; ++i)
        if (painted->at(i, j) == kReleasePainted) mask[h.index(i, j)] = 1;
  const bool any = std::find(mask.begin(), mask.end(), 1) != mask.end();
  return any ? mask : std::vector<std::uint8_t>{};
}

Status AreaPass::initialise() {
  auto program = GlProgram::build("area.vert", "area.frag");
  if (!program) return program.error();
  m_program = std::move(*program);
  m_vertexArray = GlVertexArray::make();
  const GLuint id = m_vertexArray.id();
  glEnableVertexArrayAttrib(id, 0);
  glVertexArrayAttribFormat(id, 0, 3, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(id, 0, 0);
  glEnableVertexArrayAttrib(id, 1);
  glVertexArrayAttribFormat(id, 1, 1, GL_FLOAT, GL_FALSE, sizeof(Vec3f));
  glVertexArrayAttribBinding(id, 1, 0);
  return {};
}

void AreaPass::setScene(const SnapshotPointer& scene, const std::string& selected) {
  if (scene == m_scene && selected == m_selected) return;
  m_scene = scene;
  m_selected = selected;
  m_count = 0;
  const auto node = std::find_if(scene->nodes.begin(), scene->nodes.end(),
                                 [&](const SceneNode& n) { return n.id == selected && n.enabled; });
  if (node == scene->nodes.end()) return;
  const std::vector<std::uint8_t> mask = releaseMask(*scene, *node);
  if (mask.empty()) return;
  const Raster<float>& h = scene->terrain->heights;
  std::vector<std::int32_t> known(h.size(), -1);
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  const auto vertex = [&](int i, int j) {
    const std::size_t k = h.index(i, j);
    if (known[k] < 0) {
      known[k] = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(
          {Vec3d{h.x(i), h.y(j), static_cast<double>(h.values[k])}.to<float>(), static_cast<float>(mask[k])});
    }
    return static_cast<std::uint32_t>(known[k]);
  };
  for (int j = 0; j + 1 < h.height; ++j)
    for (int i = 0; i + 1 < h.width; ++i) {
      const std::size_t k = h.index(i, j), up = h.index(i, j + 1);
      if (!(mask[k] | mask[k + 1] | mask[up] | mask[up + 1])) continue;
      if (std::isnan(h.values[k] + h.values[k + 1] + h.values[up] + h.values[up + 1])) continue;
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                          d = vertex(i, j + 1);
      indices.insert(indices.end(), {a, b, c, a, c, d});
    }
  m_count = static_cast<GLsizei>(indices.size());
  if (m_count == 0) return;
  m_vertices = GlBuffer::make();
  m_indices = GlBuffer::make();
  glNamedBufferStorage(m_vertices.id(), static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                       vertices.data(), 0);
  glNamedBufferStorage(m_indices.id(), static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)),
                       indices.data(), 0);
}

void AreaPass::draw() const {
  if (empty()) return;
  m_program.use();
  glBindVertexArray(m_vertexArray.id());
  glVertexArrayVertexBuffer(m_vertexArray.id(), 0, m_vertices.id(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(m_vertexArray.id(), m_indices.id());
  glDrawElements(GL_TRIANGLES, m_count, GL_UNSIGNED_INT, nullptr);
}

}  // namespace spin
