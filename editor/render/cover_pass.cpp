// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/render/cover_pass.h"

#include <algorithm>
#include <cmath>

#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

/// Pixels along a cell of a patch at which its snow begins to sink to the model's surface, and at which it
/// has sunk; it stays as many pixels above it as depth buffers need to tell the two apart.
constexpr double kPixelsSinking = 1.5, kPixelsSunk = 0.6, kPixelsKept = 0.3;
/// Colours of values also lie on bare surfaces, which must not flicker through.
constexpr float kValueLift = 0.02f;  // m
/// Snow on a model may stand this far above it, m, before it is taken to be out of sight.
constexpr double kTallestSnow = 10.0;

template <class T>
GLsizeiptr bytesOf(const std::vector<T>& values) {
  return static_cast<GLsizeiptr>(values.size() * sizeof(T));
}

void formatAttributes(const GlVertexArray& array) {
  const GLint components[2] = {3, 4};
  for (GLuint a = 0; a < 2; ++a) {
    glEnableVertexArrayAttrib(array.id(), a);
    glVertexArrayAttribFormat(array.id(), a, components[a], GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(array.id(), a, a);
  }
  glVertexArrayAttribFormat(array.id(), 2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0);
  glVertexArrayAttribBinding(array.id(), 2, 2);
}

void bindBuffers(const GlVertexArray& array, const GlBuffer& positions, const GlBuffer& snow,
                 const GlBuffer& looks, const GlBuffer& indices) {
  glVertexArrayVertexBuffer(array.id(), 0, positions.id(), 0, sizeof(Vec3f));
  glVertexArrayVertexBuffer(array.id(), 1, snow.id(), 0, sizeof(Vec4f));
  if (looks) {
    glEnableVertexArrayAttrib(array.id(), 2);
    glVertexArrayVertexBuffer(array.id(), 2, looks.id(), 0, sizeof(CoverTexel));
  } else {
    glDisableVertexArrayAttrib(array.id(), 2);
  }
  glVertexArrayElementBuffer(array.id(), indices.id());
}

void drawIndices(std::size_t first, std::size_t count) {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

}  // namespace

Status CoverPass::initialise() {
  for (std::size_t k = 0; k < kSnowLooks; ++k) {
    const std::string defines = definesOf(static_cast<SnowLook>(k));
    auto fine = GlProgram::build("terrain.vert", "terrain.frag", defines + "#define FINE 1\n#define NEAR 1");
    if (!fine) return fine.error();
    auto patch = GlProgram::build("patch.vert", "patch.frag", defines);
    if (!patch) return patch.error();
    m_finePrograms[k] = std::move(*fine);
    m_patchPrograms[k] = std::move(*patch);
  }
  m_fineArray = GlVertexArray::make();
  m_patchArray = GlVertexArray::make();
  formatAttributes(m_fineArray);
  formatAttributes(m_patchArray);
  return {};
}

void CoverPass::setCover(std::shared_ptr<const CoverPart> cover, const SceneSnapshot* scene,
                         double filmTime) {
  if (!cover || !cover->layout || !scene || !scene->terrain ||
      cover->values.size() != cover->layout->grids.size()) {
    m_cover.reset();
    m_snowShare = 0.0;
    return;
  }
  const bool sameMeshes = cover->layout == m_layout && scene->terrain == m_terrain;
  m_cover = std::move(cover);
  m_layout = m_cover->layout;
  m_terrain = scene->terrain;
  if (!sameMeshes) makeMeshes(*scene);
  updateCoarse(*scene);
  updateFine();
  updatePatches(*scene, filmTime);
  m_looksStale = m_indicesStale = true;
}

void CoverPass::makeMeshes(const SceneSnapshot& scene) {
  m_coarse = -1;
  m_depth.reset();
  m_looks.reset();
  m_fine.clear();
  m_patches.clear();
  const SceneNode* terrain = scene.first<TerrainNode>();
  for (std::size_t g = 0; g < m_layout->grids.size(); ++g) {
    const CoverGrid& grid = m_layout->grids[g];
    if (grid.base.width < 2 || grid.base.height < 2) continue;
    if (!terrain || grid.node != terrain->id)
      addPatch(g);
    else if (m_coarse < 0 && grid.base.hasShapeOf(scene.terrain->heights))
      m_coarse = static_cast<int>(g);
    else
      addFine(g);
  }
  for (Patches& patches : m_patches) uploadPatchMeshes(patches);
}

void CoverPass::addFine(std::size_t grid) {
  Fine fine;
  fine.grid = grid;
  fine.geometry = makeFineCover(m_layout->grids[grid]);
  if (fine.geometry.bounds.empty()) return;
  std::vector<std::uint32_t> indices;
  for (const FineCover::Block& block : fine.geometry.blocks) {
    fine.first.emplace_back();
    for (std::size_t s = 0; s < FineCover::kStrides; ++s) {
      fine.first.back()[s] = indices.size();
      indices.insert(indices.end(), block.indices[s].begin(), block.indices[s].end());
    }
  }
  fine.positions = GlBuffer::make();
  fine.snow = GlBuffer::make();
  fine.indices = GlBuffer::make();
  glNamedBufferStorage(fine.positions.id(), bytesOf(fine.geometry.positions), fine.geometry.positions.data(),
                       0);
  if (!indices.empty()) glNamedBufferStorage(fine.indices.id(), bytesOf(indices), indices.data(), 0);
  m_fine.push_back(std::move(fine));
}

void CoverPass::addPatch(std::size_t grid) {
  const std::string& node = m_layout->grids[grid].node;
  auto at =
      std::find_if(m_patches.begin(), m_patches.end(), [&](const Patches& p) { return p.node == node; });
  if (at == m_patches.end()) {
    m_patches.emplace_back();
    at = std::prev(m_patches.end());
    at->node = node;
  }
  PatchPart part;
  part.grid = grid;
  part.mesh = makePatchCover(m_layout->grids[grid]);
  part.contacts = rimContacts(part.mesh, grid, m_layout->grids);
  joinRims(part.mesh, part.contacts);
  for (const Vec3f& p : part.mesh.positions) part.bounds.extend(p.to<double>());
  at->cellSize = std::max(at->cellSize, m_layout->grids[grid].base.cellSize);
  if (!part.bounds.empty()) at->parts.push_back(std::move(part));
}

void CoverPass::uploadPatchMeshes(Patches& patches) const {
  std::vector<Vec3f> positions;
  for (const PatchPart& part : patches.parts)
    positions.insert(positions.end(), part.mesh.positions.begin(), part.mesh.positions.end());
  patches.vertices = positions.size();
  patches.positions = GlBuffer::make();
  patches.snow = GlBuffer::make();
  patches.indices = GlBuffer::make();
  if (!positions.empty())
    glNamedBufferStorage(patches.positions.id(), bytesOf(positions), positions.data(), 0);
}

void CoverPass::updateCoarse(const SceneSnapshot& scene) {
  m_coarseDepth = scene.terrain->heights.sameShape<float>(0.0f);
  if (m_coarse >= 0) {
    const auto& depth = m_cover->values[static_cast<std::size_t>(m_coarse)].depth;
    if (depth.size() == m_coarseDepth.size()) m_coarseDepth.values = depth;
  }
  double white = 0.0;
  std::size_t cells = 0;
  for (std::size_t k = 0; k < m_coarseDepth.size(); ++k) {
    float& d = m_coarseDepth.values[k];
    if (std::isnan(d)) d = 0.0f;
    if (std::isnan(scene.terrain->heights.values[k])) continue;
    white += std::tanh(static_cast<double>(d) / 0.05);
    ++cells;
  }
  m_snowShare = cells > 0 ? white / static_cast<double>(cells) : 0.0;
  if (!m_depth) {
    m_depth = GlTexture::make(GLenum{GL_TEXTURE_2D});
    glTextureStorage2D(m_depth.id(), 1, GL_R32F, m_coarseDepth.width, m_coarseDepth.height);
    setSampling(m_depth, GL_LINEAR, GL_LINEAR, GL_CLAMP_TO_EDGE);
  }
  glTextureSubImage2D(m_depth.id(), 0, 0, 0, m_coarseDepth.width, m_coarseDepth.height, GL_RED, GL_FLOAT,
                      m_coarseDepth.values.data());
}

void CoverPass::updateFine() {
  for (Fine& fine : m_fine) {
    const CoverGrid& grid = m_layout->grids[fine.grid];
    std::vector<float> depth = m_cover->values[fine.grid].depth;
    depth.resize(grid.base.size(), 0.0f);
    const auto snow = fineCoverSnow(fine.geometry, grid, depth, m_coarseDepth);
    glNamedBufferData(fine.snow.id(), bytesOf(snow), snow.data(), GL_DYNAMIC_DRAW);
  }
}

std::optional<double> CoverPass::snowSurfaceAt(double x, double y) const {
  // The highest of the cells round the place: snow that is banked up to it leaves no gap.
  const auto highest = [&](const Raster<float>& base, const std::vector<float>& depth) {
    std::optional<double> found;
    const int i0 = base.column(x - 0.5 * base.cellSize), j0 = base.row(y - 0.5 * base.cellSize);
    for (int j = j0; j <= j0 + 1; ++j)
      for (int i = i0; i <= i0 + 1; ++i) {
        if (!base.contains(i, j) || std::isnan(base.at(i, j))) continue;
        const float lies = base.index(i, j) < depth.size() ? depth[base.index(i, j)] : 0.0f;
        const auto z = static_cast<double>(base.at(i, j) + (std::isnan(lies) ? 0.0f : lies));
        found = std::max(found.value_or(z), z);
      }
    return found;
  };
  for (const Fine& fine : m_fine) {
    const Raster<float>& base = m_layout->grids[fine.grid].base;
    if (!base.contains(base.column(x), base.row(y))) continue;
    if (const auto z = highest(base, m_cover->values[fine.grid].depth)) return z;
  }
  return highest(m_terrain->heights, m_coarseDepth.values);
}

/// How far snow beside the rims of a patch stands above them: that of the terrain; where another patch of the
/// model meets it the mean of both depths, which either is drawn with.
std::vector<float> CoverPass::snowBeside(const PatchPart& part, Vec3d offset) const {
  std::vector<float> beside(part.mesh.positions.size(), 0.0f);
  for (std::size_t v = 0; v < beside.size(); ++v) {
    if (part.mesh.cell[v] >= 0) continue;
    const Vec3d p = part.mesh.positions[v].to<double>() + offset;
    if (const auto z = snowSurfaceAt(p.x, p.y)) beside[v] = static_cast<float>(*z - p.z);
  }
  const auto depthAt = [this](std::size_t grid, std::size_t cell) {
    const std::vector<float>& depth = m_cover->values[grid].depth;
    return cell < depth.size() ? depth[cell] : 0.0f;
  };
  for (const RimContact& contact : part.contacts) {
    const std::int32_t own = part.mesh.shownCell[contact.vertex];
    const float mean =
        0.5f * (depthAt(part.grid, static_cast<std::size_t>(own)) + depthAt(contact.grid, contact.cell));
    beside[contact.vertex] = mean;
  }
  return beside;
}

void CoverPass::updatePatches(const SceneSnapshot& scene, double filmTime) {
  for (Patches& patches : m_patches) {
    const auto node = std::find_if(scene.nodes.begin(), scene.nodes.end(),
                                   [&](const SceneNode& n) { return n.id == patches.node; });
    const Vec3d offset =
        node != scene.nodes.end() ? scene.modelTransform(*node, filmTime).translation : Vec3d{};
    std::vector<Vec4f> snow;
    snow.reserve(patches.vertices);
    for (PatchPart& part : patches.parts) {
      std::vector<float> depth = m_cover->values[part.grid].depth;
      depth.resize(m_layout->grids[part.grid].base.size(), 0.0f);
      part.drawn = patchCoverSnow(part.mesh, depth, snowBeside(part, offset));
      snow.insert(snow.end(), part.drawn.begin(), part.drawn.end());
    }
    glNamedBufferData(patches.snow.id(), bytesOf(snow), snow.data(), GL_DYNAMIC_DRAW);
  }
}

void CoverPass::updateIndices() {
  m_indicesStale = false;
  for (Patches& patches : m_patches) {
    std::vector<std::uint32_t> indices;
    std::uint32_t vertex = 0;
    for (PatchPart& part : patches.parts) {
      part.first = indices.size();
      appendCovered(part.mesh, part.drawn, vertex, indices, m_bareDrawn);
      part.count = indices.size() - part.first;
      vertex += static_cast<std::uint32_t>(part.drawn.size());
    }
    patches.count = indices.size();
    glNamedBufferData(patches.indices.id(), bytesOf(indices), indices.data(), GL_DYNAMIC_DRAW);
  }
}

void CoverPass::bindTextures() const {
  glBindTextureUnit(6, m_depth.id());
  glBindTextureUnit(8, m_looks.id());
}

std::vector<Vec4f> CoverPass::cuts() const {
  std::vector<Vec4f> out;
  if (!hasSnow()) return out;
  for (const Fine& fine : m_fine) {
    // A little inside the fine mesh: the two overlap by half a fine cell and leave no seam.
    const float inset = 0.5f * static_cast<float>(m_layout->grids[fine.grid].base.cellSize);
    const Vec4f r = fine.geometry.rectangle;
    out.push_back({r.x + inset, r.y + inset, r.z - inset, r.w - inset});
  }
  return out;
}

void CoverPass::drawFine(const DrawContext& context) const {
  if (!hasSnow()) return;
  const GlProgram& program = m_finePrograms[static_cast<std::size_t>(context.look)];
  program.use();
  glBindVertexArray(m_fineArray.id());
  for (const Fine& fine : m_fine) {
    if (!context.frustum.mayShow(fine.geometry.bounds)) continue;
    const Raster<float>& base = m_layout->grids[fine.grid].base;
    const double distance = distanceTo(fine.geometry.bounds, context.camera.position);
    const FineDetail detail = fineDetail(base.cellSize * context.pixelsPerUnit / std::max(distance, 1.0));
    program.set("uLattice", base.width, base.height, 1 << detail.level, FineCover::kBlock);
    program.set("uMorph", static_cast<float>(detail.morph));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, fine.positions.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, fine.snow.id());
    bindBuffers(m_fineArray, fine.positions, fine.snow, fine.looks, fine.indices);
    for (std::size_t b = 0; b < fine.geometry.blocks.size(); ++b) {
      const FineCover::Block& block = fine.geometry.blocks[b];
      const auto level = static_cast<std::size_t>(detail.level);
      if (context.frustum.mayShow(block.bounds))
        drawIndices(fine.first[b][level], block.indices[level].size());
    }
  }
}

void CoverPass::drawPatches(const DrawContext& context, const std::vector<PlacedModel>& placed) const {
  if (!hasSnow() || m_patches.empty()) return;
  const GlProgram& program = m_patchPrograms[static_cast<std::size_t>(context.look)];
  program.use();
  glBindVertexArray(m_patchArray.id());
  for (const Patches& patches : m_patches) {
    const auto at = std::find_if(placed.begin(), placed.end(),
                                 [&](const PlacedModel& p) { return p.node->id == patches.node; });
    if (at == placed.end() || patches.count == 0) continue;
    const Vec3d offset = at->transform.translation;
    // Colours of values keep their place.
    const double perMetre = context.look == SnowLook::Values ? 1e9 : context.pixelsPerUnit;
    const float lift = context.look == SnowLook::Values ? kValueLift : 0.0f;
    program.set("uOffset", static_cast<float>(offset.x), static_cast<float>(offset.y),
                static_cast<float>(offset.z), lift);
    program.set("uSink", static_cast<float>(patches.cellSize * perMetre / kPixelsSinking),
                static_cast<float>(patches.cellSize * perMetre / kPixelsSunk),
                static_cast<float>(kPixelsKept / perMetre), 0.0f);
    bindBuffers(m_patchArray, patches.positions, patches.snow, patches.looks, patches.indices);
    for (const PatchPart& part : patches.parts) {
      Box3d bounds{part.bounds.min + offset, part.bounds.max + offset};
      bounds.max.z += kTallestSnow;
      const bool seen = part.count > 0 && context.frustum.mayShow(bounds);
      if (seen) drawIndices(part.first, part.count);
    }
  }
}

}  // namespace spin
